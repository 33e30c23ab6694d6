// Processor time of contestants that take turns: what slows the machine slows all of them alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace thetalane::benchmarks {

inline volatile double sink = 0; // keeps work from being optimised away

// Of this process [s]: time in which others had the core does not count.
double processorTime();

double timed(const std::function<void()>& work);

struct Contestant {
    std::string name;
    std::function<double()> seconds; // one repetition: the processor time of one piece of work
    std::vector<double> taken{};     // by each repetition

    double least() const;
    double median() const;
    double spread() const; // the middle half of the repetitions, from quartile to quartile, of the median
};

// `work` is one piece; one repetition does it as often as `atLeast` seconds hold it.
Contestant repeated(std::string name, std::function<void()> work, double atLeast);

// Every repetition asks each contestant once. One that takes long is asked less often, three times at least.
void takeTurns(std::vector<Contestant>& contestants, int repetitions);

} // namespace thetalane::benchmarks
