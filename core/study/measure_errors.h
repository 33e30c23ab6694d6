// Every method on every case against the truth, on several threads.
#pragma once

#include "core/study/compare_runs.h"
#include "core/study/truth.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

namespace thetalane {

class ErrorMeter {
public:
    // leftOut: methods that are not run.
    ErrorMeter(const StudyCases& cases, const Truth& truth, std::vector<Method> methods,
               std::vector<bool> leftOut);

    // Works on until cases 0 to `end` - 1 are done, or it is stopped; `meanwhile` is called on this thread,
    // some ten times a second.
    void measure(std::size_t end, int threads, const std::function<void()>& meanwhile, std::stop_token stop);

    std::size_t casesDone() const;                             // with every method
    std::vector<CaseError> errorsOf(std::size_t method) const; // of the cases done with it
    double fewestDigits() const;                               // that the truth has left in the end

private:
    struct Case {
        std::once_flag begun;
        std::shared_ptr<const Run> truth;
        std::atomic<std::size_t> methodsLeft{0};
    };

    void work(std::size_t end, std::stop_token stop);
    void measureOne(std::size_t task);
    void begin(std::size_t index);
    std::atomic<bool>& isDone(std::size_t method, std::size_t index) const {
        return m_done[index * m_methods.size() + method];
    }

    const StudyCases& m_cases;
    Truth m_truth;
    std::vector<Method> m_methods;
    std::vector<bool> m_leftOut;
    std::unique_ptr<Case[]> m_slots;
    std::vector<CaseError> m_errors; // case by case
    std::unique_ptr<std::atomic<bool>[]> m_done;
    std::atomic<std::size_t> m_next{0}; // task: case by case, method by method
    std::atomic<std::size_t> m_tasksDone{0};
    mutable std::mutex m_digitsLock;
    double m_fewestDigits;
    bool m_digitsKnown = true;
};

} // namespace thetalane
