#include "core/study/choose_method.h"

#include "core/study/compare_runs.h"
#include "core/study/measure_cost.h"
#include "core/study/truth.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace thetalane {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<Method> candidates() {
    std::vector<Method> methods{eventMethod(), eventMethod(Precision::Float)};
    for (const double n : {30.0, 60.0, 120.0, 240.0, 500.0, 1000.0, 10'000.0}) {
        methods.push_back(steppedMethod(1 / n, true));
        methods.push_back(sweptMethod(1 / n, 1));
        methods.push_back(sweptMethod(1 / n, 4));
    }
    return methods;
}

class Chooser {
public:
    Chooser(const Scene& scene, double tolerance, double until, double patience, std::stop_token stop)
        : m_cases(oneScene(scene, until))
        , m_patience(patience)
        , m_stop(std::move(stop)) {
        m_choice.tolerance = tolerance;
        m_choice.untilAsked = until;
    }

    Choice choose() {
        m_truth = truthWithin(m_cases, referenceMethod(), m_patience / 3, m_stop);
        m_choice.until = m_truth.until;
        m_choice.reference = m_truth.method.settings.precision;
        for (const Method& method : candidates())
            if (!m_stop.stop_requested() && (m_choice.tried.size() < 2 || seconds() < m_patience))
                m_choice.tried.push_back(tried(method));
        measureAgain();
        decide();
        m_choice.seconds = seconds();
        return m_choice;
    }

private:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

    // Errors grow: where the end was not reached they must leave room for that.
    double limit() const {
        return m_choice.until < m_choice.untilAsked ? m_choice.tolerance * roomToGrow : m_choice.tolerance;
    }

    TriedMethod tried(const Method& method) {
        TriedMethod t{method};
        const double expected = expectedTime(method, m_cases.scenes.front(), m_truth.until);
        // What costs more than twice the cheapest that is good enough need not be measured.
        if (expected > m_patience / 4 || expected * 1e6 > 2 * m_cheapestWithin) {
            t.tooSlow = true;
            t.cost = expected * 1e6;
            t.error = std::numeric_limits<double>::infinity();
            return t;
        }
        Method limited = method; // what is exchanged again and again must not fill the memory
        limited.settings.maxCollisions = 20 * m_truth.first->timeline.collisionCount() + 100'000;
        const double begin = threadTime();
        const auto outcome = runMethod(limited, m_cases.scenes.front(), m_truth.until);
        t.cost = 1e6 * (threadTime() - begin);
        t.error = compareRuns(*m_truth.first, std::get<Run>(outcome), m_truth.until).furthest;
        t.within = t.error <= limit();
        if (t.within)
            m_cheapestWithin = std::min(m_cheapestWithin, t.cost);
        return t;
    }

    // Those that are good enough once more, in turn, as a single run tells little about costs.
    void measureAgain() {
        std::vector<Method> methods;
        for (const TriedMethod& t : m_choice.tried)
            if (t.within)
                methods.push_back(t.method);
        if (methods.empty() || m_stop.stop_requested())
            return;
        CostMeter meter(m_cases, m_truth.until, methods);
        const std::vector<bool> all(methods.size(), false);
        constexpr int most = 7;
        for (int k = 0; k < most && (k == 0 || seconds() < m_patience) && meter.round(all, m_stop); ++k)
            continue;
        std::size_t k = 0;
        for (TriedMethod& t : m_choice.tried)
            if (t.within && meter.rounds(k++) > 0)
                t.cost = meter.cost(k - 1).median;
    }

    void decide() {
        auto& tried = m_choice.tried;
        std::stable_sort(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.cost < b.cost; });
        const auto cheapest = std::find_if(tried.begin(), tried.end(), [](auto& t) { return t.within; });
        m_choice.met = cheapest != tried.end();
        const auto best =
            std::min_element(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.error < b.error; });
        m_choice.method = m_choice.met          ? cheapest->method
                          : best != tried.end() ? best->method
                                                : eventMethod();
    }

    StudyCases m_cases;
    double m_patience;
    std::stop_token m_stop;
    Clock::time_point m_start = Clock::now();
    Truth m_truth;
    double m_cheapestWithin = std::numeric_limits<double>::infinity(); // µs
    Choice m_choice;
};

} // namespace

std::optional<Choice> chooseMethod(const Scene& scene, double tolerance, double until, double patience,
                                   std::stop_token stop) {
    const bool sound = std::isfinite(tolerance) && tolerance > 0 && std::isfinite(until) && until > 0;
    if (!sound || scene.bodies.empty())
        return std::nullopt;
    return Chooser(scene, tolerance, until, patience, std::move(stop)).choose();
}

} // namespace thetalane
