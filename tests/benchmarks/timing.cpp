#include "tests/benchmarks/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>

namespace thetalane::benchmarks {
namespace {

double quantile(std::vector<double> values, double part) {
    const auto k = std::ptrdiff_t(part * double(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[std::size_t(k)];
}

} // namespace

double processorTime() {
#ifdef CLOCK_PROCESS_CPUTIME_ID
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
#else
    return double(std::clock()) / CLOCKS_PER_SEC;
#endif
}

double timed(const std::function<void()>& work) {
    const double start = processorTime();
    work();
    return processorTime() - start;
}

double Contestant::least() const {
    return *std::min_element(taken.begin(), taken.end());
}

double Contestant::median() const {
    return quantile(taken, 0.5);
}

double Contestant::spread() const {
    return (quantile(taken, 0.75) - quantile(taken, 0.25)) / median();
}

Contestant repeated(std::string name, std::function<void()> work, double atLeast) {
    auto times = std::make_shared<int>(0); // found out the first time, which also warms up
    return {std::move(name), [times, atLeast, work = std::move(work)] {
                if (*times == 0) {
                    work();
                    const double once = std::max(timed(work), 1e-9);
                    *times = int(std::clamp(std::ceil(atLeast / once), 1.0, 1e6));
                }
                return timed([&] {
                           for (int k = 0; k < *times; ++k)
                               work();
                       }) /
                       *times;
            }};
}

void takeTurns(std::vector<Contestant>& contestants, int repetitions) {
    constexpr int fewest = 3;
    constexpr double patience = 3; // with one contestant [s]
    std::vector<double> spent(contestants.size(), 0);
    for (int r = 0; r < repetitions; ++r)
        for (std::size_t k = 0; k < contestants.size(); ++k) {
            if (r >= fewest && spent[k] > patience)
                continue;
            const double start = processorTime();
            contestants[k].taken.push_back(contestants[k].seconds());
            spent[k] += processorTime() - start;
        }
}

} // namespace thetalane::benchmarks
