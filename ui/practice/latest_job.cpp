#include "ui/practice/latest_job.h"

#include <utility>

namespace thetalane {

LatestJob::LatestJob(QObject* parent)
    : QObject(parent) {}

LatestJob::~LatestJob() = default;

void LatestJob::start(Work work) {
    if (!m_running)
        return begin(std::move(work));
    m_next = std::move(work);
    m_thread.request_stop();
}

void LatestJob::drop() {
    m_next = nullptr;
    m_dropped = true;
    m_thread.request_stop();
}

void LatestJob::begin(Work work) {
    m_running = true;
    m_dropped = false;
    m_thread = std::jthread([this, work = std::move(work)](const std::stop_token& stop) {
        QMetaObject::invokeMethod(
            this, [this, answer = work(stop)] { take(answer); }, Qt::QueuedConnection);
    });
}

void LatestJob::take(const Answer& answer) {
    m_thread.join(); // it has nothing more to do
    m_running = false;
    if (m_next)
        return begin(std::exchange(m_next, nullptr));
    if (!m_dropped && answer)
        answer();
}

} // namespace thetalane
