// Two bodies and one collision, against the closed form.
#include "core/collision/pair_collision.h"
#include "core/scene/validation.h"
#include "core/study/extreme_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane::extremes {
namespace {

// Two of these meet at 30° when the second lies `aside` below the first's path, head-on with none.
Scene pair(double massRatio, double aside, double e = 1) {
    const double ma = massRatio > 1 ? massRatio : 1, mb = massRatio > 1 ? 1 : 1 / massRatio;
    return sceneOf(e, {ball(1, ma, 0.1, {-0.6, 0}, {1, 0}), ball(2, mb, 0.1, {0.2, -aside}, {0, 0})});
}

Meeting meetingIn(const Scene& s) {
    return meetingOf(s.bodies[0], s.bodies[1], Quad(s.restitution));
}

// The body whose velocity after the collision is relatively further off.
ExtremeResult velocityResult(const Scene& scene, double until) {
    const Meeting exact = meetingIn(scene);
    const Timeline timeline = runOf(scene, until);
    ExtremeResult r{.asked = ExtremeMeasure::Speed, .error = -1};
    for (std::size_t b = 0; b < 2; ++b) {
        const Vec2<Quad>& v = b == 0 ? exact.first : exact.second;
        const Vec2d got = timeline.bodyAt(b, timeline.endTime()).velocity;
        const Quad size = norm(v);
        const double error = double(Quad(norm(convert<Quad>(got) - v) / size));
        if (!(error <= r.error)) {
            r.exact = double(size);
            r.got = norm(got);
            r.error = error;
        }
    }
    return r;
}

struct FirstContact {
    double time = 0;
    Contact<double> contact;
};
FirstContact firstContact(const Scene& scene, double until) {
    const Timeline timeline = runOf(scene, until);
    const double none = std::numeric_limits<double>::quiet_NaN();
    if (timeline.collisions().empty())
        return {none, {none, none, none, none, none}};
    return {timeline.collisions()[0].time, timeline.collisions()[0].steps.contact};
}

ExtremeResult timeResult(const Scene& scene, const FirstContact& got) {
    const Meeting exact = meetingIn(scene);
    return {.asked = ExtremeMeasure::ContactTime,
            .exact = double(exact.time),
            .got = got.time,
            .error = relativeError(got.time, exact.time)};
}

// The sine of the angle between the lines of centres is their vector product.
ExtremeResult angleResult(const Scene& scene, const FirstContact& got) {
    const Meeting exact = meetingIn(scene);
    const Vec2<Quad> n = convert<Quad>(Vec2d{got.contact.cosTheta, got.contact.sinTheta});
    return {.asked = ExtremeMeasure::NormalAngle,
            .exact = std::atan2(double(exact.normal.y), double(exact.normal.x)),
            .got = std::atan2(got.contact.sinTheta, got.contact.cosTheta),
            .error = std::abs(double(cross(exact.normal, n)))};
}

void add(Results& out, ExtremeRow row, ExtremeCase kase, double value, ExtremeResult r, double bound) {
    r.row = row;
    r.kase = kase;
    r.value = value;
    r.bound = bound;
    out.push_back(r);
}

} // namespace

// Head-on nothing but the exchange rounds; aside, also the place of contact does, which turns the line of
// centres: by the rounding of 0.6 m on 0.2 m.
void massRatios(Results& out) {
    for (const int exponent : {-15, -12, -9, -6, -3, 3, 6, 9, 12, 15}) {
        const double ratio = std::pow(10.0, exponent);
        add(out, ExtremeRow::MassRatio, ExtremeCase::HeadOn, ratio, velocityResult(pair(ratio, 0), 2),
            4 * epsilon);
        add(out, ExtremeRow::MassRatio, ExtremeCase::Glancing, ratio, velocityResult(pair(ratio, 0.1), 2),
            16 * epsilon);
    }
}

// The larger of 1 m, met at 30° to the line of centres.
void radiusRatios(Results& out) {
    for (const int exponent : {-6, -3, 3, 6}) {
        const double ratio = std::pow(10.0, exponent);
        const double ra = std::min(1.0, ratio), rb = std::min(1.0, 1 / ratio);
        const Scene scene =
            sceneOf(1, {ball(1, 1, ra, {-2, 0}, {1, 0}), ball(2, 1, rb, {1, -(ra + rb) / 2}, {0, 0})});
        const FirstContact got = firstContact(scene, 5);
        add(out, ExtremeRow::RadiusRatio, ExtremeCase::RadiusRatio, ratio, timeResult(scene, got),
            8 * epsilon);
        add(out, ExtremeRow::RadiusRatio, ExtremeCase::RadiusRatio, ratio, angleResult(scene, got),
            16 * epsilon);
    }
}

void speeds(Results& out) {
    for (const int exponent : {-9, -6, -3, 0, 3, 6}) {
        const double speed = std::pow(10.0, exponent);
        Scene scene = pair(1, 0.1);
        scene.bodies[0].velocity.x = speed;
        add(out, ExtremeRow::Speed, ExtremeCase::Speed, speed,
            timeResult(scene, firstContact(scene, 2 / speed)), 8 * epsilon);
        add(out, ExtremeRow::Speed, ExtremeCase::Speed, speed, velocityResult(scene, 2 / speed),
            16 * epsilon);
    }
}

// Moved, the scene asked for is the unmoved one: what is lost is the rounding of the coordinates, half a unit
// in the last place each, at the start and at contact.
void coordinates(Results& out) {
    const Scene home = pair(1, 0.1);
    const Meeting exact = meetingIn(home);
    for (const int exponent : {-6, -3, 0, 3, 6}) {
        const double offset = std::pow(10.0, exponent);
        Scene scene = home;
        for (Body& b : scene.bodies)
            b.position = b.position + Vec2d{offset, offset};
        const FirstContact got = firstContact(scene, 2);
        const double rounding = 4 * epsilon * (offset + 1);
        ExtremeResult way = timeResult(home, got);
        way.asked = ExtremeMeasure::ContactTimeInPath;
        way.error = std::abs(double(Quad(Quad(got.time) - exact.time))); // at 1 m/s
        add(out, ExtremeRow::Coordinates, ExtremeCase::Offset, offset, way, rounding);
        add(out, ExtremeRow::Coordinates, ExtremeCase::Offset, offset, angleResult(home, got),
            rounding / 0.2);
    }
    for (const int exponent : {-6, 6}) {
        const double size = std::pow(10.0, exponent);
        Scene scene = home;
        for (Body& b : scene.bodies) {
            b.position = b.position * size;
            b.radius *= size;
        }
        const FirstContact got = firstContact(scene, 2 * size);
        add(out, ExtremeRow::Coordinates, ExtremeCase::Scaled, size, timeResult(scene, got), 8 * epsilon);
        add(out, ExtremeRow::Coordinates, ExtremeCase::Scaled, size, angleResult(scene, got), 16 * epsilon);
    }
}

// E after, from the states; and ½ μ (1 - e²) u², which the states no longer resolve where e is next to 1.
void restitutions(Results& out) {
    for (const double e : {0.0, 5e-324, 1e-300, 0.5, 1 - 0x1p-53, 1.0}) {
        const Scene scene = pair(2, 0.1, e);
        const Meeting exact = meetingIn(scene);
        const Timeline timeline = runOf(scene, 2);
        const double after = energyOf(scene, timeline.stateAt(2));
        add(out, ExtremeRow::Restitution, ExtremeCase::Elasticity, e,
            {.asked = ExtremeMeasure::EnergyAfter,
             .exact = double(exact.energyAfter),
             .got = after,
             .error = relativeError(after, exact.energyAfter)},
            16 * epsilon);
        const Quad loss = exact.energyBefore - exact.energyAfter;
        const double lost = timeline.collisions().empty() ? -1 : timeline.collisions()[0].steps.energyLoss;
        add(out, ExtremeRow::Restitution, ExtremeCase::Elasticity, e,
            {.asked = ExtremeMeasure::EnergyLoss,
             .exact = e == 1 ? 0 : double(loss),
             .got = lost,
             .error = e == 1 ? std::abs(lost) : relativeError(lost, loss)},
            16 * epsilon);
    }
}

void coincident(Results& out) {
    const Scene same = sceneOf(1, {ball(1, 1, 0.1, {0.3, 0.4}, {1, 0}), ball(2, 1, 0.2, {0.3, 0.4}, {})});
    const bool refused =
        std::ranges::any_of(validate(same), [](auto& e) { return e.code == SceneErrorCode::Overlap; });
    add(out, ExtremeRow::Coincident, ExtremeCase::SamePlace, 0,
        {.asked = ExtremeMeasure::Refused, .exact = 1, .got = double(refused), .error = double(!refused)}, 0);
    // 3 : 4 apart, so that cos θ is 0.6; with no distance, the declared θ = 0.
    for (const double apart : {0.0, 1e-9, 1e-15, 1e-100, 1e-150, 1e-200, 1e-300}) {
        const Vec2<double> d{0.6 * apart, 0.8 * apart};
        const auto steps =
            collide<double>({1, 0.1, d, {-1, 0}}, {3, 0.1, {}, {1, 0.5}}, 1); // from the origin: no rounding
        const double exact = apart > 0 ? 0.6 : 1, got = steps.contact.cosTheta;
        const Vec2<Quad> a = convert<Quad>(steps.after.first), b = convert<Quad>(steps.after.second);
        const Quad energy = (dot(a, a) + 3 * dot(b, b)) / 2; // of 0.5 + 1.875 before
        add(out, ExtremeRow::Coincident, ExtremeCase::Apart, apart,
            {.asked = ExtremeMeasure::NormalCosine,
             .exact = exact,
             .got = got,
             .error = std::abs(got - exact)},
            4 * epsilon);
        add(out, ExtremeRow::Coincident, ExtremeCase::Apart, apart,
            {.asked = ExtremeMeasure::EnergyAfter,
             .exact = 2.375,
             .got = double(energy),
             .error = relativeError(double(energy), Quad(2.375))},
            16 * epsilon);
    }
    for (const double radius : {1e-9, 1e-12}) {
        const Scene scene = sceneOf(1, {ball(1, 1, radius, {-4 * radius, 0}, {1, 0}),
                                        ball(2, 1, radius, {2 * radius, -radius}, {0, 0})});
        const FirstContact got = firstContact(scene, 1);
        add(out, ExtremeRow::Coincident, ExtremeCase::TinyRadii, radius, timeResult(scene, got), 8 * epsilon);
        add(out, ExtremeRow::Coincident, ExtremeCase::TinyRadii, radius, angleResult(scene, got),
            16 * epsilon);
    }
}

// Along an axis, where the coordinates hold the distance to the last bit, and at 37° to it, where they round.
// The sign of the distance beyond grazing is that of the rounded scene.
void grazing(Results& out) {
    for (const double within : {1e-12, 1e-13, 1e-14, 1e-15}) {
        for (const bool inside : {true, false})
            for (const bool slanted : {false, true}) {
                const double aside = 0.2 + (inside ? -within : within);
                const Vec2d along = slanted ? Vec2d{0.8, 0.6} : Vec2d{1, 0}, up{-along.y, along.x};
                const Scene scene =
                    sceneOf(1, {ball(1, 1, 0.1, along * -0.5, along), ball(2, 1, 0.1, up * -aside, {0, 0})});
                const double exact = meetingIn(scene).meets, got = !runOf(scene, 2).collisions().empty();
                const ExtremeCase kase =
                    inside ? (slanted ? ExtremeCase::GrazesInsideSlanted : ExtremeCase::GrazesInside)
                           : (slanted ? ExtremeCase::GrazesOutsideSlanted : ExtremeCase::GrazesOutside);
                add(out, ExtremeRow::Grazing, kase, within,
                    {.asked = ExtremeMeasure::Meets,
                     .exact = exact,
                     .got = got,
                     .error = std::abs(got - exact)},
                    0);
            }
    }
}

} // namespace thetalane::extremes
