#include "ui/lane/extent.h"

#include "ui/lane/scale.h"
#include "ui/lane/step_overlay.h"

#include <algorithm>
#include <set>
#include <utility>

namespace thetalane {
namespace {

QRectF disc(const Vec2d& centre, double radius) {
    return toUnits(centre - Vec2d{radius, radius}, centre + Vec2d{radius, radius});
}

// Where everything starts, and where any two first meet: a pair that the paper's loop holds together, meeting
// again and again as it flies off, would make the rest of the scene dots.
QRectF action(const Run& run) {
    constexpr std::size_t most = 500;
    QRectF all;
    for (const Body& body : run.scene.bodies)
        all |= disc(body.position, body.radius);
    const auto collisions = run.timeline.collisions();
    std::set<std::pair<int, int>> met;
    for (std::size_t i = 0; i < std::min(collisions.size(), most); ++i)
        if (met.insert({collisions[i].first, collisions[i].second}).second)
            all |= disc(collisions[i].steps.first.position, collisions[i].steps.first.radius);
    return all;
}

QRectF open(const Run& run, double until) {
    // Of the action's size. Pins scatter far, and what matters of them is the rack.
    const double beyond = run.scene.bodies.back().kind == BodyKind::Pin ? 0.12 : 0.35;
    const QRectF start = action(run);
    QRectF all = start;
    for (std::size_t i = 0; i < run.scene.bodies.size(); ++i)
        all |= disc(run.timeline.bodyAt(i, until).position, run.scene.bodies[i].radius);
    const double more = beyond * std::max(start.width(), start.height());
    return all & start.adjusted(-more, -more, more, more);
}

} // namespace

QRectF fitRect(const Run& run, double until) {
    constexpr double beforeHeadPin = 0.75, behindDeck = 0.3;
    if (const auto& lane = run.scene.lane)
        return toUnits({lane->left - lane->gutterWidth, -beforeHeadPin},
                       {lane->right + lane->gutterWidth, lane->end + behindDeck});
    QRectF rect = open(run, until);
    if (const auto& frame = run.scene.frame) {
        const Vec2d low = toMetres(rect.bottomLeft());
        const Vec2d high = toMetres(rect.topRight());
        rect = toUnits({frame->left.value_or(low.x), frame->bottom.value_or(low.y)},
                       {frame->right.value_or(high.x), frame->top.value_or(high.y)});
    }
    return rect;
}

QRectF wholeRect(const Run& run, double until) {
    constexpr double approach = 0.7;
    if (const auto& lane = run.scene.lane)
        return toUnits({lane->left - lane->gutterWidth, lane->foulLine - approach},
                       {lane->right + lane->gutterWidth, lane->end + lane->pitDepth});
    return fitRect(run, until);
}

QRectF rackRect(const Run& run) {
    constexpr double before = 0.3;
    const Lane& lane = *run.scene.lane;
    return toUnits({lane.left, -before}, {lane.right, lane.end});
}

QRectF foulLineRect(const Run& run) {
    constexpr double before = 0.6, beyond = 5; // past the seven arrows
    const Lane& lane = *run.scene.lane;
    return toUnits({lane.left - lane.gutterWidth, lane.foulLine - before},
                   {lane.right + lane.gutterWidth, lane.foulLine + beyond});
}

QRectF pairRect(const Collision& collision) {
    const PairCollision<double>& s = collision.steps;
    const double reach = overlayReach(collision);
    const double share = s.first.radius / (s.first.radius + s.second.radius);
    const Vec2d contact = s.first.position + (s.second.position - s.first.position) * share;
    return disc(contact, reach);
}

} // namespace thetalane
