// Work beside the window, of which only the answer asked for last is wanted.
#pragma once

#include <QObject>

#include <functional>
#include <stop_token>
#include <thread>

namespace thetalane {

// One job at a time on a thread of its own; a newer one takes the place of what waits or runs.
class LatestJob : public QObject {
    Q_OBJECT
public:
    explicit LatestJob(QObject* parent = nullptr);
    ~LatestJob() override; // waits for what runs, which is asked to stop

    // work: on the other thread; what it returns is called on this one, unless something newer was asked for.
    using Answer = std::function<void()>;
    using Work = std::function<Answer(const std::stop_token&)>;
    void start(Work work);
    void drop(); // nothing is wanted any more
    bool running() const { return m_running; }

private:
    void begin(Work work);
    void take(const Answer& answer);

    Work m_next;
    bool m_running = false;
    bool m_dropped = false;
    std::jthread m_thread;
};

} // namespace thetalane
