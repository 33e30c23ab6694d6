#include "core/study/quantity.h"

#include "core/bowling/pinfall.h"

#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180; // rad

std::optional<Vec2d> angleOf(const Vec2d& v) {
    if (norm(v) == 0)
        return std::nullopt;
    return Vec2d{std::atan2(v.y, v.x) / degree, 0};
}

std::optional<Vec2d> angleBetween(const Vec2d& a, const Vec2d& b) {
    if (norm(a) == 0 || norm(b) == 0)
        return std::nullopt;
    return Vec2d{std::abs(std::atan2(cross(a, b), dot(a, b))) / degree, 0};
}

double energyLost(const Run& run, const Collision* collision) {
    if (collision)
        return collision->steps.energyLoss;
    const auto energyAt = [&](double t) { return totals(run.scene, run.timeline.stateAt(t)).energy; };
    return energyAt(0) - energyAt(run.timeline.endTime());
}

} // namespace

bool isVector(QuantityKind kind) {
    return kind == QuantityKind::Velocity || kind == QuantityKind::TotalMomentum;
}

bool isCount(QuantityKind kind) {
    return kind == QuantityKind::Collisions || kind == QuantityKind::PinsDown;
}

bool needsBody(QuantityKind kind) {
    using enum QuantityKind;
    return kind == Speed || kind == Direction || kind == AngleBetween || kind == Velocity;
}

bool needsOther(QuantityKind kind) {
    return kind == QuantityKind::AngleBetween;
}

std::optional<Vec2d> measure(const Run& run, const Quantity& q) {
    const auto collisions = run.timeline.collisions();
    if (q.collision < 0 || q.collision > std::int64_t(collisions.size()))
        return std::nullopt;
    const Collision* collision = q.collision > 0 ? &collisions[std::size_t(q.collision - 1)] : nullptr;
    const double time = collision ? collision->time : run.timeline.endTime();
    const auto velocity = [&](int body) { return run.timeline.bodyAt(std::size_t(body), time).velocity; };
    const auto momentum = [&] { return totals(run.scene, run.timeline.stateAt(time)).momentum; };
    using enum QuantityKind;
    switch (q.kind) {
    case Speed:
        return Vec2d{norm(velocity(q.body)), 0};
    case Direction:
        return angleOf(velocity(q.body));
    case AngleBetween:
        return angleBetween(velocity(q.body), velocity(q.other));
    case Theta:
        if (!collision)
            return std::nullopt;
        return angleOf({collision->steps.contact.cosTheta, collision->steps.contact.sinTheta});
    case EnergyLost:
        return Vec2d{energyLost(run, collision), 0};
    case MomentumSize:
        return Vec2d{norm(momentum()), 0};
    case Collisions:
        return Vec2d{double(run.timeline.collisionCount()), 0};
    case PinsDown:
        return Vec2d{double(pinsDown(run.scene, run.timeline, run.timeline.endTime()).size()), 0};
    case Velocity:
        return velocity(q.body);
    case TotalMomentum:
        return momentum();
    }
    return std::nullopt;
}

} // namespace thetalane
