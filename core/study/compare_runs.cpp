#include "core/study/compare_runs.h"

#include "core/bowling/pinfall.h"
#include "core/study/contact_names.h"
#include "core/study/digits_left.h"
#include "core/study/parting.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace thetalane {
namespace {

// The pins, or in a scene without pins the bodies, that met anything.
std::vector<int> touched(const Run& run, double until) {
    if (std::any_of(run.scene.bodies.begin(), run.scene.bodies.end(),
                    [](auto& b) { return b.kind == BodyKind::Pin; }))
        return pinsTouched(run.scene, run.timeline, until);
    std::vector<int> bodies;
    for (const Collision& c : run.timeline.collisions()) {
        bodies.push_back(c.first);
        if (!c.isWall())
            bodies.push_back(c.second);
    }
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    return bodies;
}

// Two that meet again and have met nobody else in between: between free bodies that cannot be.
std::int64_t repetitions(const Run& run) {
    std::vector<MetName> last(run.scene.bodies.size(), -5); // no name
    std::int64_t count = 0;
    for (const Collision& c : run.timeline.collisions()) {
        const MetName name = nameOf(c);
        MetName& first = last[std::size_t(c.first)];
        MetName& second = c.isWall() ? first : last[std::size_t(c.second)];
        count += first == name && second == name;
        first = second = name;
    }
    return count;
}

std::int64_t missedContacts(const Timeline& truth, const Timeline& run) {
    const auto there = sortedNames(truth.collisions()), here = sortedNames(run.collisions());
    std::vector<MetName> missed;
    std::set_difference(there.begin(), there.end(), here.begin(), here.end(), std::back_inserter(missed));
    return std::int64_t(missed.size());
}

void comparePositions(CaseError& error, const Run& truth, const Run& run, double until) {
    std::vector<BodyState> there, here;
    for (std::size_t k = 0; k < studyTimes; ++k) {
        const double t = until * double(k + 1) / double(studyTimes);
        truth.timeline.stateAt(t, there);
        run.timeline.stateAt(t, here);
        double sum = 0;
        for (std::size_t i = 0; i < there.size(); ++i) {
            const double off = norm(there[i].position - here[i].position);
            sum += off * off;
            error.furthest = std::max(error.furthest, off);
        }
        error.position[k] = std::sqrt(sum / double(there.size()));
    }
    const Totals want = totals(truth.scene, there), got = totals(truth.scene, here);
    double energy = 0, momentum = 0; // at the start
    for (const Body& b : truth.scene.bodies) {
        energy += b.mass * dot(b.velocity, b.velocity) / 2;
        momentum += b.mass * norm(b.velocity);
    }
    error.energyDrift = energy > 0 ? std::abs(got.energy - want.energy) / energy : 0;
    error.momentumDrift = momentum > 0 ? norm(got.momentum - want.momentum) / momentum : 0;
}

void compareDigits(CaseError& error, const Run& truth, const Run& run) {
    const auto said = digitsLeft(run);
    if (said.empty())
        return;
    const auto found = digitsInCommon(truth, run);
    error.digitsAsked = std::int64_t(found.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        error.digitsRight += std::abs(said[k] - found[k]) <= 1;
}

} // namespace

CaseError compareRuns(const Run& truth, const Run& run, double until) {
    CaseError error;
    error.collisions = run.timeline.collisionCount();
    error.sameTouched = touched(truth, until) == touched(run, until);
    error.sameDown = pinsDown(truth.scene, truth.timeline, until) == pinsDown(run.scene, run.timeline, until);
    if (const auto k = firstDifference(truth.timeline, run.timeline)) {
        const auto list = truth.timeline.collisions();
        error.firstDifference = int(*k);
        error.differenceTime = *k < list.size() ? list[*k].time : run.timeline.collisions()[*k].time;
    }
    error.missed = missedContacts(truth.timeline, run.timeline);
    error.repeated = std::max<std::int64_t>(0, repetitions(run) - repetitions(truth));
    comparePositions(error, truth, run, until);
    if (run.settings.precision < truth.settings.precision)
        compareDigits(error, truth, run);
    return error;
}

} // namespace thetalane
