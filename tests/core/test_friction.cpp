// Bodies under friction: closed forms against published figures, a small-step integration and 50 digits.
#include "core/math/quad.h"
#include "core/motion/friction.h"
#include "tests/core/random.h"

#include <QTest>

#include <array>
#include <numbers>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

constexpr double radius = 0.1085;
constexpr double standardGravity = 9.80665;

FloorBody<double> sphere(double rollingFriction = 0) {
    return {radius, 2.5, rollingFriction};
}

FloorBody<double> pin() {
    return {};
}

Floor<double> evenFloor(double friction, double gravity = standardGravity) {
    return {gravity, {{}, {friction}}};
}

// The path to its end, or to t: every stretch in turn.
template <class Real> struct Journey {
    FloorState<Real> state;
    Real now{};
    int stretches = 0;
    Real slidFor{};
    Vec2<Real> slidTo;
};

template <class Real>
Journey<Real> travel(FloorState<Real> s, const FloorBody<Real>& body, const Floor<Real>& floor,
                     const Real& until) {
    Journey<Real> j{s, Real(0), 0, Real(0), s.position};
    while (j.stretches < 100) {
        const Stretch<Real> next = nextStretch(j.state, body, floor);
        if (!(j.now + next.lasts <= until)) {
            j.state = stateWithin<Real>(j.state, next, body, floor, until - j.now);
            j.now = until;
            return j;
        }
        const bool slid = j.state.phase == FloorPhase::Sliding;
        j.state = stateAfter(j.state, next, body, floor);
        j.now += next.lasts;
        ++j.stretches;
        if (slid && j.state.phase != FloorPhase::Sliding) {
            j.slidFor = j.now;
            j.slidTo = j.state.position;
        }
    }
    return j;
}

double energyOf(const FloorState<double>& s, const FloorBody<double>& body) { // per mass
    const double turning = body.rolls() ? body.arm * body.arm / body.inverseInertia : 0;
    return (dot(s.velocity, s.velocity) + turning * (s.spin.x * s.spin.x + s.spin.y * s.spin.y)) / 2;
}

// Where the straight path after the slide is at y, x [m].
double hookAt(const Journey<double>& j, double y) {
    return j.slidTo.x + (y - j.slidTo.y) * j.state.velocity.x / j.state.velocity.y;
}

// x, y, vx, vy, ωx, ωy under Coulomb friction, by Newton and Euler alone: force along -u, torque R ẑ × …
using Phase6 = std::array<double, 6>;

Phase6 rateOf(const Phase6& s, const FloorBody<double>& body, const Floor<double>& floor) {
    const double ux = s[2] - body.arm * s[5], uy = s[3] + body.arm * s[4], u = std::hypot(ux, uy);
    std::size_t zone = 0;
    while (zone < floor.zones.edges.size() && floor.zones.edges[zone] < s[1])
        ++zone;
    const double f = u > 0 ? -floor.zones.friction[zone] * floor.gravity / u : 0;
    const double fx = f * ux, fy = f * uy;
    // Torque (0, 0, -R) × (fx, fy, 0) = (R fy, -R fx, 0), over β R².
    const double turn = body.rolls() ? body.inverseInertia / body.arm : 0;
    return {s[2], s[3], fx, fy, turn * fy, -turn * fx};
}

Phase6 rungeKutta(Phase6 s, double dt, int steps, const FloorBody<double>& body, const Floor<double>& floor) {
    const auto moved = [](const Phase6& a, const Phase6& b, double h) {
        Phase6 r;
        for (std::size_t i = 0; i < 6; ++i)
            r[i] = a[i] + h * b[i];
        return r;
    };
    for (int k = 0; k < steps; ++k) {
        const Phase6 a = rateOf(s, body, floor), b = rateOf(moved(s, a, dt / 2), body, floor),
                     c = rateOf(moved(s, b, dt / 2), body, floor), d = rateOf(moved(s, c, dt), body, floor);
        for (std::size_t i = 0; i < 6; ++i)
            s[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return s;
}

FloorState<double> randomBall(Random& random, const FloorBody<double>& body, const Floor<double>& floor) {
    return onFloor<double>({random.in(-1, 1), random.in(-1, 3)}, {random.in(-3, 3), random.in(-8, 8)},
                           {random.in(-40, 40), random.in(-40, 40), random.in(-9, 9)}, body, floor);
}

} // namespace

class TestFriction : public QObject {
    Q_OBJECT

private slots:
    void sideSpin();
    void hookTable();
    void pinSlidesToRest();
    void againstSmallSteps();
    void againstFiftyDigits();
    void energyNeverRises();
    void edges();
    void crossingALine();
    void extremes();
    void frictionless();
    void rollingAndRest();
};

// The final velocity is v₀ - (2/7) u₀ whatever μ, so its angle is atan(β R ω/v) = 9.2438° (9.242° is the
// angle for R = 10.848 cm); at μ = 0.12 the slide's time and length, 2.0969 s and
// 14.379 m.
void TestFriction::sideSpin() {
    for (const double friction : {0.01, 0.04, 0.12, 0.2, 1.0}) {
        const Floor<double> floor = evenFloor(friction);
        const auto start = onFloor<double>({}, {0, 8}, {0, 30, 0}, sphere(), floor);
        const auto end = travel<double>(start, sphere(), floor, 1000);
        QCOMPARE(end.state.phase, FloorPhase::Rolling);
        const double angle = std::atan2(std::abs(end.state.velocity.x), end.state.velocity.y);
        QVERIFY(std::abs(angle - std::atan(0.4 * radius * 30 / 8)) < 1e-14);
        QVERIFY(std::abs(angle * 180 / std::numbers::pi - 9.242) < 0.002);
        if (friction == 0.12) {
            QVERIFY(std::abs(end.slidFor - 2.0969) < 5e-5);
            QVERIFY(std::abs(end.slidTo.y - 14.37898) < 5e-6);
        }
    }
}

// Slide to 8.90, 13.35, 14.94 m; hook 69, 57, 39 cm: μ = 0.12, 0.08, and 0.04 then 0.20 from 12 m on. All six
// come out for β = 0.388, a bowling ball's, at the head pin with standard gravity. A uniform sphere slides
// that far with g = 10 m/s².
void TestFriction::hookTable() {
    const double axis = 22 * std::numbers::pi / 180;
    const Spin<double> spin{-30 * std::cos(axis), 30 * std::sin(axis), 0};
    struct Row {
        FrictionZones<double> zones;
        double slide, hook;
    };
    const Row rows[] = {
        {{{}, {0.12}}, 8.90, 0.69}, {{{}, {0.08}}, 13.35, 0.57}, {{{12}, {0.04, 0.20}}, 14.94, 0.39}};
    const auto thrown = [&spin](const FloorBody<double>& ball, const Floor<double>& floor) {
        return travel<double>(onFloor<double>({}, {0, 8}, spin, ball, floor), ball, floor, 1000);
    };
    for (const Row& row : rows) {
        const auto real = thrown({radius, 1 / 0.388, 0}, {standardGravity, row.zones});
        QVERIFY(std::abs(real.slidTo.y - row.slide) < 0.0051);
        QVERIFY(std::abs(std::abs(hookAt(real, 18.288)) - row.hook) < 0.0051);
        const auto uniform = thrown(sphere(), {standardGravity, row.zones});
        const auto atTen = thrown(sphere(), {10, row.zones});
        QVERIFY(std::abs(atTen.slidTo.y - row.slide) < 0.0051);
        qInfo("slide %.3f m, hook %.3f m; uniform sphere %.3f m, %.3f m; with g = 10 m/s² %.3f m, %.3f m",
              real.slidTo.y, hookAt(real, 18.288), uniform.slidTo.y, hookAt(uniform, 18.288), atTen.slidTo.y,
              hookAt(atTen, 18.288));
    }
}

void TestFriction::pinSlidesToRest() {
    const Floor<double> floor = evenFloor(0.4);
    const auto start = onFloor<double>({1, 2}, {3, -4}, {0, 0, 5}, pin(), floor);
    QCOMPARE(start.phase, FloorPhase::Sliding);
    const Stretch<double> s = nextStretch(start, pin(), floor);
    QCOMPARE(s.change, FloorChange::Rests);
    QVERIFY(std::abs(s.lasts - 5 / (0.4 * standardGravity)) < 1e-15);
    const auto end = stateAfter(start, s, pin(), floor);
    QVERIFY(end.phase == FloorPhase::Rest && end.velocity == Vec2d{});
    QVERIFY(std::abs(norm(end.position - start.position) - 25 / (0.8 * standardGravity)) < 1e-14);
    QCOMPARE(end.spin.z, 5.0);
    QCOMPARE(nextStretch(end, pin(), floor).lasts, std::numeric_limits<double>::infinity());
}

// A fifth of a second in steps of 10⁻⁶ s. Where an edge lies inside a step, the integration is off by a
// step's worth.
void TestFriction::againstSmallSteps() {
    Random random(3);
    double worst[2] = {0, 0}; // in zones, on an even floor
    for (int k = 0; k < 12; ++k) {
        const FloorBody<double> body = k % 3 == 0 ? pin() : FloorBody<double>{radius, random.in(2.2, 3), 0};
        const Floor<double> floor = k % 2 ? evenFloor(random.in(0.05, 0.3))
                                          : Floor<double>{standardGravity, {{0, 1}, {0.1, 0.02, 0.3}}};
        const auto s = randomBall(random, body, floor);
        const double span = std::min(0.2, 0.9 * travel<double>(s, body, floor, 50).slidFor);
        const int steps = std::max(1, int(span * 1e6));
        const Phase6 end =
            rungeKutta({s.position.x, s.position.y, s.velocity.x, s.velocity.y, s.spin.x, s.spin.y}, 1e-6,
                       steps, body, floor);
        const auto e = travel<double>(s, body, floor, steps * 1e-6).state;
        const double differences[] = {end[0] - e.position.x,        end[1] - e.position.y,
                                      end[2] - e.velocity.x,        end[3] - e.velocity.y,
                                      (end[4] - e.spin.x) * radius, (end[5] - e.spin.y) * radius};
        for (const double d : differences)
            worst[k % 2] = std::max(worst[k % 2], std::abs(d));
    }
    qInfo("worst difference from 10⁻⁶ s steps: even floor %.2g, zones %.2g m, m/s", worst[1], worst[0]);
    QVERIFY(worst[1] < 1e-9 && worst[0] < 1e-5);
}

// The whole journey in double and in 50 digits from the same doubles, looked at at any time.
void TestFriction::againstFiftyDigits() {
    Random random(5);
    double worst = 0;
    for (int k = 0; k < 5000; ++k) {
        const FloorBody<double> body =
            k % 4 ? FloorBody<double>{radius, random.in(2.2, 3), random.in(0, 0.02)} : pin();
        const Floor<double> floor{standardGravity, {{0, 1.5, 4}, {0.04, random.in(0, 0.3), 0.1, 0.25}}};
        const auto s = randomBall(random, body, floor);
        const FloorBody<Wide> wideBody{body.arm, body.inverseInertia, body.rollingFriction};
        Floor<Wide> wideFloor{Wide(floor.gravity), {{0, 1.5, 4}, {}}};
        wideFloor.zones.friction.clear();
        for (const double m : floor.zones.friction)
            wideFloor.zones.friction.push_back(m);
        const auto wide = onFloor<Wide>(convert<Wide>(s.position), convert<Wide>(s.velocity),
                                        {s.spin.x, s.spin.y, s.spin.z}, wideBody, wideFloor);
        const double t = random.in(0, 4);
        const auto a = travel<double>(s, body, floor, t);
        const auto b = travel<Wide>(wide, wideBody, wideFloor, Wide(t));
        QCOMPARE(a.stretches, b.stretches);
        QCOMPARE(a.state.phase, b.state.phase);
        QCOMPARE(a.state.zone, b.state.zone);
        const Wide d = norm(convert<Wide>(a.state.position) - b.state.position) +
                       norm(convert<Wide>(a.state.velocity) - b.state.velocity) +
                       abs(a.state.spin.x - b.state.spin.x) * radius;
        worst = std::max(worst, d.convert_to<double>());
    }
    qInfo("worst difference from 50 digits: %.2g m, m/s", worst);
    QVERIFY(worst < 1e-13);
}

void TestFriction::energyNeverRises() {
    Random random(11);
    for (int k = 0; k < 3000; ++k) {
        const FloorBody<double> body = k % 4 ? sphere(random.in(0, 0.05)) : pin();
        const Floor<double> floor{standardGravity, {{0, 2}, {0.1, random.in(0, 0.1), 0.3}}};
        const auto s = randomBall(random, body, floor);
        double before = energyOf(s, body);
        for (int step = 1; step <= 60; ++step) {
            const double now = energyOf(travel<double>(s, body, floor, step * 0.1).state, body);
            QVERIFY(now <= before * (1 + 1e-14) + 1e-28);
            before = now;
        }
    }
}

// A slide keeps û across an edge, and a body on an edge belongs to the side it moves to.
void TestFriction::edges() {
    const Floor<double> floor{standardGravity, {{1, 2}, {0.1, 0, 0.3}}};
    auto s = onFloor<double>({0, 0}, {1, 5}, {20, -9, 0}, sphere(), floor);
    const Vec2d u = s.slipDirection;
    for (int zone = 1; zone <= 2; ++zone) {
        const Stretch<double> next = nextStretch(s, sphere(), floor);
        QCOMPARE(next.change, FloorChange::UpperZone);
        s = stateAfter(s, next, sphere(), floor);
        QCOMPARE(s.position.y, double(zone));
        QCOMPARE(s.zone, zone);
        QVERIFY(s.slipDirection == u);
    }
    QCOMPARE(onFloor<double>({0, 1}, {0, 1}, {}, pin(), floor).zone, 1);
    QCOMPARE(onFloor<double>({0, 1}, {0, -1}, {}, pin(), floor).zone, 0);
    // Backspin: it goes up over the edge by a little, is drawn back, and leaves downwards: two crossings, no
    // more.
    const Floor<double> drawn{10, {{1}, {0.2, 0.3}}};
    const double up = std::sqrt(2 * 0.2 * 10 * 0.9) + 1e-7;
    const auto ball = onFloor<double>({0, 0.1}, {0, up}, {90, 0, 0}, sphere(), drawn);
    const auto end = travel<double>(ball, sphere(), drawn, 100);
    QVERIFY(end.stretches == 3 && end.state.velocity.y < 0 && end.state.phase == FloorPhase::Rolling);
    // Thrown so that it turns just below the edge: none.
    const auto below = onFloor<double>({0, 0.1}, {0, up - 1e-6}, {90, 0, 0}, sphere(), drawn);
    QCOMPARE(travel<double>(below, sphere(), drawn, 100).stretches, 1);
}

void TestFriction::crossingALine() {
    const double never = std::numeric_limits<double>::infinity();
    QCOMPARE(timeToCross<double>(6, 3, 0), 2.0);
    QCOMPARE(timeToCross<double>(6, -3, 0), never);
    QCOMPARE(timeToCross<double>(2, 2, -1), never); // turns as it touches
    QCOMPARE(timeToCross<double>(1.5, 2, -1), 1.0);
    QCOMPARE(timeToCross<double>(4, -1, 0.5), 2 + std::sqrt(20.0));
    QCOMPARE(timeToCross<double>(0, 1, -1), 0.0);
    QCOMPARE(timeToCross<double>(0, -1, 1), 2.0); // leaves it and comes back
    QCOMPARE(timeToCross<double>(0, -1, -1), never);
    QCOMPARE(timeToCross<double>(0, 0, 1), 0.0);
    QCOMPARE(timeToCross<double>(0, 0, 0), never);
    QCOMPARE(timeToCross<double>(0, 0, -1), never);
    QCOMPARE(timeToCross<double>(2, 0, 1), 2.0);
}

// 1e-9 to 1e6 m/s: finitely many stretches to an exact rest, in double, float and quad.
template <class Real> void restsFrom(double speed) {
    const Floor<Real> floor{Real(10), {{Real(0), Real(1)}, {Real(0.25), Real(0.5), Real(0.125)}}};
    for (const bool rolls : {false, true}) {
        const FloorBody<Real> body =
            rolls ? FloorBody<Real>{Real(0.125), Real(2.5), Real(0.01)} : FloorBody<Real>{};
        for (const double sign : {1.0, -1.0}) {
            const Vec2<Real> v{Real(speed * 0.6), Real(sign * speed * 0.8)};
            const auto s =
                onFloor<Real>({Real(0), Real(0.5)}, v, {Real(-5 * speed), Real(speed), Real(0)}, body, floor);
            const auto end = travel<Real>(s, body, floor, Real(1e12f));
            QVERIFY(end.state.phase == FloorPhase::Rest);
            QVERIFY(end.state.velocity == Vec2<Real>{} && end.state.spin.x == Real(0) &&
                    end.state.spin.y == Real(0));
            QVERIFY(end.stretches <= 5);
            QVERIFY(end.state.position.x > Real(0));
        }
    }
}

void TestFriction::extremes() {
    for (const double speed : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6}) {
        restsFrom<double>(speed);
        restsFrom<float>(speed);
        restsFrom<Quad>(speed);
    }
    // Rolls backwards to a stop in the very instant the slip ends: R ω = v/β.
    const Floor<double> floor = evenFloor(0.1, 10);
    const auto s = onFloor<double>({}, {0, 1}, {2.5 / radius, 0, 0}, sphere(), floor);
    const auto end = travel<double>(s, sphere(), floor, 100);
    QVERIFY(end.state.phase == FloorPhase::Rest && end.stretches == 1);
}

void TestFriction::frictionless() {
    const Floor<double> floor = evenFloor(0);
    for (const FloorBody<double>& body : {pin(), sphere()}) {
        const auto s = onFloor<double>({1, 1}, {2, 3}, {4, 5, 6}, body, floor);
        const Stretch<double> next = nextStretch(s, body, floor);
        QVERIFY(next.acceleration == Vec2d{} && next.change == FloorChange::None);
        QCOMPARE(next.lasts, std::numeric_limits<double>::infinity());
        const auto later = stateWithin(s, next, body, floor, 7.0);
        QVERIFY(later.velocity == s.velocity && later.position == (Vec2d{15, 22}));
        QCOMPARE(later.slip, s.slip);
    }
}

void TestFriction::rollingAndRest() {
    const Floor<double> floor{10, {{1}, {0.1, 0.2}}};
    // Rolling from the start: slip 0 within rounding; rolling friction is the same in every zone.
    const auto s = onFloor<double>({0, 0}, {3, 4}, {-4 / radius, 3 / radius, 2}, sphere(0.01), floor);
    QCOMPARE(s.phase, FloorPhase::Rolling);
    const auto end = travel<double>(s, sphere(0.01), floor, 1000);
    QVERIFY(end.stretches == 1 && end.state.phase == FloorPhase::Rest && end.state.spin.z == 2);
    QVERIFY(std::abs(nextStretch(s, sphere(0.01), floor).lasts - 50) < 1e-12 &&
            norm(end.state.position - Vec2d{75, 100}) < 1e-11);
    QCOMPARE(onFloor<double>({}, {}, {0, 0, 9}, sphere(), floor).phase, FloorPhase::Rest);
    // Spinning on the spot about a lying axis: it is off.
    QCOMPARE(onFloor<double>({}, {}, {1, 0, 0}, sphere(), floor).phase, FloorPhase::Sliding);
}

QTEST_GUILESS_MAIN(TestFriction)
#include "test_friction.moc"
