// Runs the lab beside the window. One study at a time: the next begins when the one before has let go.
#pragma once

#include "ui/lab/run_lab.h"

#include <QObject>

#include <thread>

namespace thetalane {

class LabWorker : public QObject {
    Q_OBJECT
public:
    explicit LabWorker(QObject* parent = nullptr);
    ~LabWorker() override; // waits for the run that is under way

    void start(std::shared_ptr<const LabPlan> plan); // instead of what runs
    void cancel();                                   // its last news says what there is
    bool running() const { return m_current != nullptr; }

signals:
    // On the thread of the window; of the plan that was started last, and no other.
    void news(std::shared_ptr<const thetalane::LabResult> result);

private:
    void begin();
    void take(const std::shared_ptr<const LabResult>& result);

    std::shared_ptr<const LabPlan> m_current; // runs
    std::shared_ptr<const LabPlan> m_next;    // waits for it to end
    std::jthread m_thread;
};

} // namespace thetalane
