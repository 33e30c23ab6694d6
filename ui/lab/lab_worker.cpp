#include "ui/lab/lab_worker.h"

namespace thetalane {

LabWorker::LabWorker(QObject* parent)
    : QObject(parent) {}

LabWorker::~LabWorker() = default;

void LabWorker::start(std::shared_ptr<const LabPlan> plan) {
    m_next = std::move(plan);
    if (m_current)
        m_thread.request_stop();
    else
        begin();
}

void LabWorker::cancel() {
    m_next.reset();
    m_thread.request_stop();
}

void LabWorker::begin() {
    m_current = std::exchange(m_next, nullptr);
    m_thread = std::jthread([this, plan = m_current](std::stop_token stop) {
        const LabNews news = [this](std::shared_ptr<const LabResult> result) {
            QMetaObject::invokeMethod(
                this, [this, r = std::move(result)] { take(r); }, Qt::QueuedConnection);
        };
        runLab(plan, news, stop);
    });
}

void LabWorker::take(const std::shared_ptr<const LabResult>& result) {
    if (result->plan != m_current)
        return;
    const bool superseded = m_next != nullptr;
    if (result->ended) {
        m_thread.join(); // it has nothing more to do
        m_current.reset();
    }
    if (!superseded)
        emit news(result);
    else if (result->ended)
        begin();
}

} // namespace thetalane
