// Computes strike maps beside the window, on all cores. One at a time: the next begins when the one before
// has let go.
#pragma once

#include "core/study/strike_map.h"

#include <QObject>

#include <memory>
#include <thread>

namespace thetalane {

struct MapNews {
    std::shared_ptr<const StrikeMap> map; // the finest that is whole; null before the first
    std::size_t done = 0;                 // of `all` cells
    std::size_t all = 0;
    double seconds = 0; // since it began
    bool ended = false; // map->whole() says whether all is there
};

class MapWorker : public QObject {
    Q_OBJECT
public:
    explicit MapWorker(QObject* parent = nullptr);
    ~MapWorker() override; // waits for the map that is under way, which lets go at once

    void start(const MapSettings& settings); // instead of what runs; refusalOf() finds nothing wrong
    void cancel();                           // its last news holds what there is
    bool running() const { return m_running || m_next; }

signals:
    // On the thread of the window; of the map that was started last, and no other.
    void news(const thetalane::MapNews& news);

private:
    void begin(const MapSettings& settings);
    void take(std::uint64_t number, const MapNews& news);

    std::optional<MapSettings> m_next; // waits for what runs to end
    std::uint64_t m_number = 0;        // of what runs
    bool m_running = false;
    std::jthread m_thread;
};

} // namespace thetalane
