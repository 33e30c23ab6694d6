#include "core/study/measure_errors.h"

#include "core/study/digits_left.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

namespace thetalane {

ErrorMeter::ErrorMeter(const StudyCases& cases, const Truth& truth, std::vector<Method> methods,
                       std::vector<bool> leftOut)
    : m_cases(cases)
    , m_truth(truth)
    , m_methods(std::move(methods))
    , m_leftOut(std::move(leftOut))
    , m_slots(new Case[cases.scenes.size()])
    , m_errors(cases.scenes.size() * m_methods.size())
    , m_done(new std::atomic<bool>[cases.scenes.size() * m_methods.size()])
    , m_fewestDigits(std::numeric_limits<double>::infinity()) {
    for (std::size_t k = 0; k < m_errors.size(); ++k)
        m_done[k] = false;
    for (std::size_t k = 0; k < cases.scenes.size(); ++k)
        m_slots[k].methodsLeft = m_methods.size();
}

void ErrorMeter::measure(std::size_t end, int threads, const std::function<void()>& meanwhile,
                         std::stop_token stop) {
    const std::size_t tasks = std::min(end, m_cases.scenes.size()) * m_methods.size();
    std::vector<std::jthread> workers;
    std::atomic<int> working{threads};
    for (int k = 0; k < threads; ++k)
        workers.emplace_back([&, stop] {
            work(tasks, stop);
            --working;
        });
    for (int k = 1; working > 0; ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        if (k % 20 == 0)
            meanwhile();
    }
    workers.clear();
    m_next = m_tasksDone.load(); // every worker went one too far
}

void ErrorMeter::work(std::size_t end, std::stop_token stop) {
    while (!stop.stop_requested()) {
        std::size_t task = m_next.load();
        do
            if (task >= end)
                return;
        while (!m_next.compare_exchange_weak(task, task + 1));
        measureOne(task);
        ++m_tasksDone;
    }
}

void ErrorMeter::begin(std::size_t index) {
    Case& slot = m_slots[index];
    slot.truth = index == 0 && m_truth.first
                     ? m_truth.first
                     : std::make_shared<const Run>(truthOf(m_truth, m_cases.scenes[index]));
    const std::vector<double> digits = digitsLeft(*slot.truth);
    const std::lock_guard lock(m_digitsLock);
    if (!digits.empty())
        m_fewestDigits = std::min(m_fewestDigits, digits.back());
    else if (!slot.truth->timeline.collisions().empty())
        m_digitsKnown = false;
}

void ErrorMeter::measureOne(std::size_t task) {
    const std::size_t index = task / m_methods.size(), method = task % m_methods.size();
    Case& slot = m_slots[index];
    std::call_once(slot.begun, [&] { begin(index); });
    if (!m_leftOut[method]) {
        const Run& truth = *slot.truth;
        Method m = m_methods[method];
        // What sticks or is exchanged again and again must not fill the memory.
        m.settings.maxCollisions = 20 * truth.timeline.collisionCount() + 100'000;
        if (m_methods[method] == m_truth.method)
            m_errors[task] = compareRuns(truth, truth, m_truth.until);
        else
            m_errors[task] = compareRuns(
                truth, std::get<Run>(runMethod(m, m_cases.scenes[index], m_truth.until)), m_truth.until);
        m_done[task] = true;
    }
    if (--slot.methodsLeft == 0)
        slot.truth.reset();
}

std::size_t ErrorMeter::casesDone() const {
    std::size_t done = 0;
    for (std::size_t k = 0; k < m_cases.scenes.size(); ++k)
        done += m_slots[k].methodsLeft == 0;
    return done;
}

std::vector<CaseError> ErrorMeter::errorsOf(std::size_t method) const {
    std::vector<CaseError> errors;
    for (std::size_t k = 0; k < m_cases.scenes.size(); ++k)
        if (isDone(method, k))
            errors.push_back(m_errors[k * m_methods.size() + method]);
    return errors;
}

double ErrorMeter::fewestDigits() const {
    const std::lock_guard lock(m_digitsLock);
    return m_digitsKnown ? m_fewestDigits : std::numeric_limits<double>::infinity();
}

} // namespace thetalane
