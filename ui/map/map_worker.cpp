#include "ui/map/map_worker.h"

#include <chrono>

namespace thetalane {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double tellEvery = 0.05; // [s]

} // namespace

MapWorker::MapWorker(QObject* parent)
    : QObject(parent) {}

MapWorker::~MapWorker() = default;

void MapWorker::start(const MapSettings& settings) {
    if (!m_running)
        return begin(settings);
    m_next = settings;
    m_thread.request_stop();
}

void MapWorker::cancel() {
    m_next.reset();
    m_thread.request_stop();
}

void MapWorker::begin(const MapSettings& settings) {
    m_running = true;
    const std::uint64_t number = ++m_number;
    m_thread = std::jthread([this, number, settings](const std::stop_token& stop) {
        const auto start = Clock::now();
        MapNews now;
        double told = 0;
        const auto tell = [&](bool always) {
            now.seconds = std::chrono::duration<double>(Clock::now() - start).count();
            if (!always && now.seconds < told + tellEvery)
                return;
            told = now.seconds;
            QMetaObject::invokeMethod(
                this, [this, number, news = now] { take(number, news); }, Qt::QueuedConnection);
        };
        MapWatch watch;
        watch.refined = [&](const StrikeMap& map) {
            now.map = std::make_shared<const StrikeMap>(map);
            tell(true);
        };
        watch.progressed = [&](std::size_t done, std::size_t all) {
            now.done = done;
            now.all = all;
            tell(false);
        };
        const StrikeMap last = computeStrikeMap(settings, 0, watch, stop);
        if (!now.map || now.map->stride != last.stride)
            now.map = std::make_shared<const StrikeMap>(last);
        now.ended = true;
        tell(true);
    });
}

void MapWorker::take(std::uint64_t number, const MapNews& found) {
    if (number != m_number)
        return;
    if (found.ended) {
        m_thread.join(); // it has nothing more to do
        m_running = false;
        if (const auto next = std::exchange(m_next, std::nullopt))
            return begin(*next);
    }
    if (!m_next)
        emit news(found);
}

} // namespace thetalane
