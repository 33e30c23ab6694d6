#include "core/study/study.h"

#include "core/study/measure_cost.h"
#include "core/study/measure_errors.h"
#include "core/study/sum_up.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace thetalane {
namespace {

// The stages of one study, and what they have found so far.
class StudyInProgress {
public:
    StudyInProgress(const StudyCases& cases, const StudyOptions& options, const StudyReport& report,
                    std::stop_token stop)
        : m_cases(cases)
        , m_options(options)
        , m_report(report)
        , m_stop(std::move(stop))
        , m_threads(options.threads > 0 ? options.threads
                                        : std::max(1, int(std::thread::hardware_concurrency()))) {
        m_result.until = m_result.untilAsked = cases.until;
        m_result.casesAsked = cases.scenes.size();
        m_result.truth = options.truth;
        for (const Method& m : options.methods) {
            m_result.methods.emplace_back();
            m_result.methods.back().method = m;
        }
    }

    StudyResult run() {
        findTruth();
        sortOut();
        CostMeter costs(m_cases, m_result.until, m_options.methods);
        ErrorMeter errors(m_cases, m_truth, m_options.methods, m_leftOut);
        constexpr std::size_t firstLook = 8;
        measureErrors(errors, std::min(firstLook, m_cases.scenes.size()));
        measureCosts(costs);
        measureErrors(errors, m_cases.scenes.size());
        takeOver(errors);
        m_result.cancelled = m_stop.stop_requested();
        return m_result;
    }

private:
    void tell(StudyStage stage, std::size_t done, std::size_t total) {
        if (m_report)
            m_report(m_result, {stage, done, total});
    }

    void findTruth() {
        tell(StudyStage::Truth, 0, 1);
        m_truth = truthWithin(m_cases, m_options.truth, m_options.patience, m_stop);
        m_result.truth = m_truth.method;
        m_result.until = m_truth.until;
    }

    // Who is refused, and who would take too long.
    void sortOut() {
        for (MethodResult& r : m_result.methods) {
            if (m_stop.stop_requested())
                break;
            const Scene& scene = m_cases.scenes.front();
            if (const auto refusal = refusalOf(r.method, scene, m_result.until)) {
                r.state = MethodState::Refused;
                r.refusal = *refusal;
            } else if (const double seconds = expected(r.method, scene); seconds > m_options.patience) {
                r.state = MethodState::TooSlow;
                r.cost.lower = r.cost.median = r.cost.upper = 1e6 * seconds;
            }
        }
        for (const MethodResult& r : m_result.methods)
            m_leftOut.push_back(r.state != MethodState::Waiting);
    }

    double expected(const Method& method, const Scene& scene) const {
        const bool tooMany = method.settings.kind == EngineKind::Event &&
                             method.settings.precision == Precision::Quad &&
                             scene.bodies.size() > mostBodiesInQuad;
        return tooMany ? std::numeric_limits<double>::infinity()
                       : expectedTime(method, scene, m_result.until);
    }

    void measureCosts(CostMeter& costs) {
        const double mostSpent = 6 * m_options.patience;
        constexpr int fewest = 3;
        for (int k = 0; k < m_options.costRounds && (k < fewest || costs.spent() < mostSpent); ++k) {
            const auto after = [&](std::size_t m) {
                takeOver(costs, m);
                if (k == 0) // the first look comes point by point
                    tell(StudyStage::Cost, 0, std::size_t(m_options.costRounds));
            };
            if (!costs.round(m_leftOut, m_stop, after))
                return;
            tell(StudyStage::Cost, std::size_t(k + 1), std::size_t(m_options.costRounds));
        }
    }

    void takeOver(const CostMeter& costs, std::size_t m) {
        MethodResult& r = m_result.methods[m];
        if (costs.rounds(m) == 0)
            return;
        r.costRounds = costs.rounds(m);
        r.cost = costs.cost(m);
        r.costRatio = costs.ratio(m);
        r.costPerSecond = r.cost.median / m_result.until;
        r.costPerCollision = r.collisions > 0 ? r.cost.median / r.collisions : 0;
    }

    void measureErrors(ErrorMeter& errors, std::size_t end) {
        const auto report = [&] {
            takeOver(errors);
            tell(StudyStage::Errors, m_result.cases, m_result.casesAsked);
        };
        errors.measure(end, m_threads, report, m_stop);
        report();
    }

    void takeOver(const ErrorMeter& errors) {
        m_result.cases = errors.casesDone();
        m_result.truthDigits = errors.fewestDigits();
        for (std::size_t m = 0; m < m_result.methods.size(); ++m) {
            MethodResult& r = m_result.methods[m];
            sumUp(r, errors.errorsOf(m));
            r.costPerCollision = r.collisions > 0 ? r.cost.median / r.collisions : 0;
        }
    }

    const StudyCases& m_cases;
    const StudyOptions& m_options;
    const StudyReport& m_report;
    std::stop_token m_stop;
    int m_threads;
    Truth m_truth;
    std::vector<bool> m_leftOut;
    StudyResult m_result;
};

} // namespace

StudyOptions ablationStudy(const Scene& scene) {
    StudyOptions options;
    options.methods = ablationMethods(scene);
    options.truth = options.methods.front();
    return options;
}

StudyResult runStudy(const StudyCases& cases, const StudyOptions& options, const StudyReport& report,
                     std::stop_token stop) {
    return StudyInProgress(cases, options, report, std::move(stop)).run();
}

} // namespace thetalane
