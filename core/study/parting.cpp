#include "core/study/parting.h"

#include "core/study/contact_names.h"

#include <algorithm>

namespace thetalane {
namespace {

double apart(const Run& truth, const Run& run, std::size_t body, double t) {
    return norm(truth.timeline.bodyAt(body, t).position - run.timeline.bodyAt(body, t).position);
}

// The moments between which both of them move evenly, for one body, up to `end`.
std::vector<double> moments(const Run& truth, const Run& run, std::size_t body, double end) {
    std::vector<double> times{end};
    for (const Run* r : {&truth, &run})
        for (const Segment& s : r->timeline.segments(body))
            if (s.start < end)
                times.push_back(s.start);
    std::sort(times.begin(), times.end());
    return times;
}

std::optional<double> leavesAt(const Run& truth, const Run& run, std::size_t body, double end,
                               double tolerance) {
    double before = 0;
    for (const double t : moments(truth, run, body, end)) {
        if (apart(truth, run, body, t) <= tolerance) {
            before = t;
            continue;
        }
        double after = t;
        for (int k = 0; k < 60; ++k) {
            const double middle = (before + after) / 2;
            (apart(truth, run, body, middle) <= tolerance ? before : after) = middle;
        }
        return after;
    }
    return std::nullopt;
}

// One past the contacts that share their instant with the one before `end`, in either list.
bool isWithinAnInstant(std::span<const Collision> list, std::size_t end) {
    return end > 0 && end < list.size() && list[end].time == list[end - 1].time;
}

} // namespace

std::optional<Parting> firstParting(const Run& truth, const Run& run, double tolerance) {
    std::optional<Parting> first;
    double end = std::min(truth.timeline.endTime(), run.timeline.endTime());
    if (truth.timeline.endReason() == EndReason::AtRest) // it stays there
        end = run.timeline.endTime();
    else if (run.timeline.endReason() == EndReason::AtRest)
        end = truth.timeline.endTime();
    for (std::size_t body = 0; body < truth.scene.bodies.size(); ++body) {
        const auto t = leavesAt(truth, run, body, end, tolerance);
        if (!t)
            continue;
        end = *t;
        first = Parting{*t, int(body), truth.timeline.bodyAt(body, *t).position,
                        run.timeline.bodyAt(body, *t).position};
    }
    return first;
}

std::optional<std::size_t> firstDifference(const Timeline& truth, const Timeline& run) {
    const auto a = truth.collisions(), b = run.collisions();
    const std::size_t shorter = std::min(a.size(), b.size());
    for (std::size_t begin = 0; begin < shorter;) {
        std::size_t end = begin + 1;
        while (end < shorter && (isWithinAnInstant(a, end) || isWithinAnInstant(b, end)))
            ++end;
        auto there = sortedNames(a.subspan(begin, end - begin));
        auto here = sortedNames(b.subspan(begin, end - begin));
        if (there != here) {
            std::size_t k = begin;
            while (k < end && nameOf(a[k]) == nameOf(b[k]))
                ++k;
            return k;
        }
        begin = end;
    }
    return a.size() == b.size() ? std::nullopt : std::optional(shorter);
}

} // namespace thetalane
