#include "ui/lab/run_lab.h"

#include "core/study/digits_left.h"
#include "core/study/truth.h"
#include "ui/lab/shifted_throws.h"

#include <algorithm>
#include <chrono>

namespace thetalane {
namespace {

using Clock = std::chrono::steady_clock;

// Chaos is followed contact by contact, with a tangent vector for every body.
constexpr std::int64_t mostFollowed = 2000;

// A run in which the teller's contacts differ shows what the preset is about; a pair met again and again is
// seen in nothing but the contacts.
bool tells(const Run& truth, const Run& run, const LabPlan& plan) {
    if (plan.preset == Preset::Through)
        return truth.timeline.collisionCount() > 0 && run.timeline.collisionCount() == 0;
    if (plan.preset == Preset::Float) // it hardly ever changes a contact
        return firstParting(truth, run, plan.tolerance).has_value();
    return firstDifference(truth.timeline, run.timeline).has_value();
}

Scene sceneOf(const LabPlan& plan, std::size_t row, const Scene& scene) {
    return plan.shifts.empty() ? scene : shifted(scene, plan.shifts[row]);
}

std::optional<Run> runOf(const LabPlan& plan, std::size_t row, const Scene& scene, double until) {
    const Method& method = plan.options.methods[plan.shifts.empty() ? row : 0];
    auto outcome = runMethod(method, sceneOf(plan, row, scene), until);
    if (Run* run = std::get_if<Run>(&outcome))
        return std::move(*run);
    return std::nullopt;
}

std::size_t caseToDraw(const LabPlan& plan, const StudyResult& result, const Truth& truth,
                       std::stop_token stop) {
    constexpr std::size_t most = 64; // looked at
    const auto& scenes = plan.cases.scenes;
    if (plan.teller >= plan.rows() || result.methods[plan.teller].state == MethodState::TooSlow)
        return 0;
    for (std::size_t k = 0; scenes.size() > 1 && k < std::min(most, scenes.size()); ++k) {
        if (stop.stop_requested())
            break;
        const auto run = runOf(plan, plan.teller, scenes[k], result.until);
        if (run && tells(truthOf(truth, scenes[k]), *run, plan))
            return k;
    }
    return 0;
}

Ghost ghostOf(const Run& truth, std::size_t row, Run run, double tolerance) {
    Ghost ghost;
    ghost.row = row;
    ghost.parting = firstParting(truth, run, tolerance);
    ghost.difference = firstDifference(truth.timeline, run.timeline);
    if (run.timeline.collisionCount() <= mostFollowed) {
        const auto digits = digitsLeft(run);
        if (!digits.empty())
            ghost.digits = digits.back();
    }
    ghost.run = std::make_shared<const Run>(std::move(run));
    return ghost;
}

// A little after the last of them left and the first contact was, so that something is seen to be elsewhere.
double momentToShow(const Ghosts& ghosts) {
    constexpr double goesOn = 0.2; // s
    const auto contacts = ghosts.truth->timeline.collisions();
    double last = contacts.empty() ? 0 : std::min(contacts.front().time + goesOn, 0.8 * ghosts.until);
    for (const Ghost& g : ghosts.all)
        if (g.parting)
            last = std::max(last, g.parting->time);
    return last > 0 ? std::min(ghosts.until, 1.25 * last + 0.02 * ghosts.until) : ghosts.until;
}

// How far the whole has come: the first cases, the costs and all cases take about this much of it.
double partDone(const StudyProgress& p, bool costsKnown) {
    constexpr double first = 0.05, costs = 0.45;
    const double done = p.total > 0 ? double(p.done) / double(p.total) : 0;
    switch (p.stage) {
    case StudyStage::Truth:
        return 0;
    case StudyStage::Cost:
        return first + costs * done;
    case StudyStage::Errors:
        break;
    }
    return costsKnown ? first + costs + (1 - first - costs) * done : first * done;
}

class LabInProgress {
public:
    LabInProgress(std::shared_ptr<const LabPlan> plan, const LabNews& news, std::stop_token stop)
        : m_plan(std::move(plan))
        , m_news(news)
        , m_stop(std::move(stop)) {}

    void run() {
        const StudyReport report = [this](const StudyResult& r, const StudyProgress& p) { take(r, p); };
        const StudyResult last = m_plan->shifts.empty()
                                     ? runStudy(m_plan->cases, m_plan->options, report, m_stop)
                                     : studyShifts(*m_plan, report, m_stop);
        if (!m_ghosts && !m_stop.stop_requested())
            m_ghosts = std::make_shared<const Ghosts>(drawGhosts(*m_plan, last, m_stop));
        tell(last, 1, true);
    }

private:
    void take(const StudyResult& result, const StudyProgress& progress) {
        m_costsKnown = m_costsKnown || progress.stage == StudyStage::Cost || !m_plan->shifts.empty();
        // Before the costs are measured, or where there are none, so that nothing disturbs them.
        if (!m_ghosts && progress.stage == StudyStage::Errors && progress.done > 0 &&
            !m_stop.stop_requested())
            m_ghosts = std::make_shared<const Ghosts>(drawGhosts(*m_plan, result, m_stop));
        tell(result, partDone(progress, m_costsKnown), false);
    }

    void tell(const StudyResult& study, double part, bool ended) {
        LabResult result{m_plan, study, m_ghosts, 0, 0, ended};
        m_part = std::max(m_part, part);
        result.part = m_part;
        result.seconds = std::chrono::duration<double>(Clock::now() - m_begin).count();
        m_news(std::make_shared<const LabResult>(std::move(result)));
    }

    std::shared_ptr<const LabPlan> m_plan;
    const LabNews& m_news;
    std::stop_token m_stop;
    std::shared_ptr<const Ghosts> m_ghosts;
    Clock::time_point m_begin = Clock::now();
    double m_part = 0;
    bool m_costsKnown = false;
};

} // namespace

Ghosts drawGhosts(const LabPlan& plan, const StudyResult& result, std::stop_token stop) {
    Truth truth{result.truth, result.until, nullptr};
    Ghosts ghosts;
    ghosts.kase = caseToDraw(plan, result, truth, stop);
    ghosts.until = result.until;
    ghosts.tolerance = plan.tolerance;
    const Scene& scene = plan.cases.scenes[ghosts.kase];
    ghosts.truth = std::make_shared<const Run>(truthOf(truth, scene));
    for (const std::size_t row : plan.ghosts) {
        const MethodState state = result.methods[row].state;
        if (stop.stop_requested() || state == MethodState::Refused || state == MethodState::TooSlow)
            continue;
        if (auto run = runOf(plan, row, scene, result.until))
            ghosts.all.push_back(ghostOf(*ghosts.truth, row, std::move(*run), plan.tolerance));
    }
    ghosts.shownAt = momentToShow(ghosts);
    return ghosts;
}

void runLab(std::shared_ptr<const LabPlan> plan, const LabNews& news, std::stop_token stop) {
    LabInProgress(std::move(plan), news, std::move(stop)).run();
}

} // namespace thetalane
