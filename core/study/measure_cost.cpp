#include "core/study/measure_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace thetalane {
namespace {

constexpr std::size_t mostCases = 32;
constexpr double shortest = 2e-3; // of what is timed at a time [s]

} // namespace

double threadTime() {
#ifdef CLOCK_THREAD_CPUTIME_ID
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
#else
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
#endif
}

Quartiles quartilesOf(std::vector<double> values) {
    if (values.empty())
        return {};
    const auto at = [&values](double part) {
        const auto k = std::ptrdiff_t(part * double(values.size() - 1) + 0.5);
        std::nth_element(values.begin(), values.begin() + k, values.end());
        return values[std::size_t(k)];
    };
    return {at(0.25), at(0.5), at(0.75)};
}

CostMeter::CostMeter(const StudyCases& cases, double until, std::vector<Method> methods)
    : m_until(until)
    , m_methods(std::move(methods))
    , m_times(m_methods.size(), 0)
    , m_taken(m_methods.size()) {
    const std::size_t count = std::min(mostCases, cases.scenes.size());
    for (std::size_t k = 0; k < count; ++k)
        m_scenes.push_back(cases.scenes[k * cases.scenes.size() / count]);
}

// The scenes are copied before the clock runs: an engine takes over its own.
double CostMeter::timeOnce(std::size_t method) const {
    const EngineSettings settings = settingsFor(m_methods[method], m_until, false);
    std::vector<Scene> scenes;
    scenes.reserve(m_scenes.size());
    for (const Scene& scene : m_scenes)
        scenes.push_back(sceneFor(m_methods[method], scene));
    const double start = threadTime();
    for (Scene& scene : scenes)
        (void)simulate(std::move(scene), settings);
    return threadTime() - start;
}

bool CostMeter::round(const std::vector<bool>& leftOut, std::stop_token stop) {
    for (std::size_t m = 0; m < m_methods.size(); ++m) {
        if (leftOut[m])
            continue;
        if (stop.stop_requested())
            return false;
        const double begin = threadTime();
        double taken = 0;
        int done = 0;
        if (m_times[m] == 0) { // found out the first time, which also warms up
            const double once = std::max(timeOnce(m), 1e-7);
            m_times[m] = int(std::clamp(std::ceil(shortest / once), 1.0, 1e4));
            if (m_times[m] == 1) { // it is not worth another one
                taken = once;
                done = 1;
            }
        }
        for (; done < m_times[m]; ++done)
            taken += timeOnce(m);
        m_taken[m].push_back(1e6 * taken / m_times[m] / double(m_scenes.size()));
        m_spent += threadTime() - begin;
    }
    return true;
}

Quartiles CostMeter::cost(std::size_t method) const {
    return quartilesOf(m_taken[method]);
}

double CostMeter::ratio(std::size_t method) const {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(m_taken[0].size(), m_taken[method].size()); ++k)
        ratios.push_back(m_taken[method][k] / m_taken[0][k]);
    return quartilesOf(std::move(ratios)).median;
}

} // namespace thetalane
