// Processor time of methods that take turns on one thread: what slows the machine slows all of them alike.
#pragma once

#include "core/study/study.h"

namespace thetalane {

// Of this thread [s]: time in which others had the core does not count, where the system can tell.
double threadTime();

Quartiles quartilesOf(std::vector<double> values); // of none: zeros

class CostMeter {
public:
    // Cases spread over all of them are run, the same ones by every method.
    CostMeter(const StudyCases& cases, double until, std::vector<Method> methods);

    // One round: every method that is not left out once; false when it was stopped. Then the costs so far.
    bool round(const std::vector<bool>& leftOut, std::stop_token stop);
    int rounds(std::size_t method) const { return int(m_taken[method].size()); }
    Quartiles cost(std::size_t method) const; // of a case [µs]
    double ratio(std::size_t method) const;   // to the first method, median of the rounds
    double spent() const { return m_spent; }  // by all rounds [s]

private:
    double timeOnce(std::size_t method) const;

    std::vector<Scene> m_scenes;
    double m_until;
    std::vector<Method> m_methods;
    std::vector<int> m_times;                 // that a round runs the cases, so that the clock can tell
    std::vector<std::vector<double>> m_taken; // of each method, a round each [µs]
    double m_spent = 0;
};

} // namespace thetalane
