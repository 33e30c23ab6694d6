// The five steps of a collision against 50 digits, against the laws, and against what is known exactly.
#include "core/collision/pair_collision.h"
#include "core/engine/engine.h"
#include "core/engine/models.h"
#include "core/math/quad.h"
#include "tests/core/support.h"

#include <QTest>

#include <boost/multiprecision/cpp_bin_float.hpp>

using namespace thetalane;
using namespace thetalane::testing;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_50::backend_type,
                                           boost::multiprecision::et_off>;

namespace {

// Rounding of a dozen operations, each half a unit in the last place of a number up to 3 vmax.
constexpr double boundInEpsilons = 12;

struct WideVec {
    Wide x, y;
};
Wide dotOf(const WideVec& a, const WideVec& b) {
    return a.x * b.x + a.y * b.y;
}
WideVec plus(const WideVec& a, const Wide& s, const WideVec& b) {
    return {a.x + s * b.x, a.y + s * b.y};
}
template <class Real> WideVec widen(const Vec2<Real>& v) {
    return {Wide(v.x), Wide(v.y)};
}

// The other route: no rotation and no exchange formula, but an impulse J along the line of centres.
struct Reference {
    WideVec n, t, beforeA, beforeB, afterA, afterB;
    Wide distance, impulse, loss, reduced;

    template <class Real> Reference(const Disc<Real>& A, const Disc<Real>& B, const Real& restitution) {
        const Wide ma(A.mass), mb(B.mass), e(restitution);
        const WideVec d = plus(widen(A.position), Wide(-1), widen(B.position));
        distance = sqrt(dotOf(d, d));
        n = {d.x / distance, d.y / distance};
        t = {-n.y, n.x};
        beforeA = widen(A.velocity);
        beforeB = widen(B.velocity);
        reduced = 1 / (1 / ma + 1 / mb);
        impulse = (1 + e) * reduced * dotOf(plus(beforeB, Wide(-1), beforeA), n);
        afterA = plus(beforeA, impulse / ma, n);
        afterB = plus(beforeB, -impulse / mb, n);
        // as a difference of energies: 50 digits can afford it
        loss = (ma * (dotOf(beforeA, beforeA) - dotOf(afterA, afterA)) +
                mb * (dotOf(beforeB, beforeB) - dotOf(afterB, afterB))) /
               2;
    }
};

template <class Real> struct Worst {
    double contact = 0, rotated = 0, exchanged = 0, after = 0, impulse = 0, loss = 0;

    static void take(double& worst, const Wide& got, const Wide& wanted, const Wide& scale) {
        const Wide error = abs(got - wanted) / (scale * Wide(std::numeric_limits<Real>::epsilon()));
        worst = std::max(worst, error.template convert_to<double>());
    }
    static void take(double& worst, const Vec2<Real>& got, const WideVec& wanted, const Wide& scale) {
        take(worst, Wide(got.x), wanted.x, scale);
        take(worst, Wide(got.y), wanted.y, scale);
    }

    void compare(const PairCollision<Real>& c, const Reference& r) {
        const Wide vA = sqrt(dotOf(r.beforeA, r.beforeA)), vB = sqrt(dotOf(r.beforeB, r.beforeB));
        const Wide v = vA > vB ? vA : vB;
        const auto local = [&r](const WideVec& u) { return WideVec{dotOf(u, r.n), dotOf(u, r.t)}; };
        take(contact, Wide(c.contact.Z), r.distance, r.distance);
        take(contact, Wide(c.contact.a), r.n.x * r.distance, r.distance);
        take(contact, Wide(c.contact.b), r.n.y * r.distance, r.distance);
        take(contact, {c.contact.cosTheta, c.contact.sinTheta}, r.n, Wide(1));
        take(rotated, c.rotated.first, local(r.beforeA), v);
        take(rotated, c.rotated.second, local(r.beforeB), v);
        take(exchanged, c.exchanged.first, local(r.afterA), v);
        take(exchanged, c.exchanged.second, local(r.afterB), v);
        take(after, c.after.first, r.afterA, v);
        take(after, c.after.second, r.afterB, v);
        take(impulse, Wide(c.impulse), r.impulse, r.reduced * v);
        take(loss, Wide(c.energyLoss), r.loss, r.reduced * v * v);
    }
    double most() const { return std::max({contact, rotated, exchanged, after, impulse, loss}); }
};

double pickRestitution(Random& random) {
    const int pick = random.below(6);
    return pick == 0 ? 0.0 : pick == 1 ? 1.0 : random.unit();
}

template <class Real> Disc<Real> randomDisc(Random& random, double massLow, double massHigh) {
    const double speed = random.logUniform(1e-3, 1e3), way = random.in(-4, 4);
    return {Real(random.logUniform(massLow, massHigh)),
            Real(random.logUniform(1e-2, 1)),
            {Real(random.in(-1, 1)), Real(random.in(-1, 1))},
            {Real(speed * std::cos(way)), Real(speed * std::sin(way))}};
}

// A touching pair; where they touch is rounded to Real, and the reference starts from the rounded values.
template <class Real> std::pair<Disc<Real>, Disc<Real>> randomPair(Random& random, double massRange) {
    auto a = randomDisc<Real>(random, 1 / massRange, massRange);
    auto b = randomDisc<Real>(random, 1 / massRange, massRange);
    const double angle = random.in(-4, 4);
    const Real reach = a.radius + b.radius;
    a.position = b.position + Vec2<Real>{reach * Real(std::cos(angle)), reach * Real(std::sin(angle))};
    return {a, b};
}

template <class Real> double worstOf(const char* name, int pairs, double massRange) {
    Random random(20240601);
    Worst<Real> worst;
    for (int k = 0; k < pairs; ++k) {
        const auto [a, b] = randomPair<Real>(random, massRange);
        const Real e(pickRestitution(random));
        worst.compare(collide(a, b, e), Reference(a, b, e));
    }
    qInfo("%s, masses to %.0e, worst error in epsilons of the largest speed: contact %.2f rotated %.2f "
          "exchanged %.2f after %.2f impulse %.2f loss %.2f",
          name, massRange, worst.contact, worst.rotated, worst.exchanged, worst.after, worst.impulse,
          worst.loss);
    return worst.most();
}

Disc<double> turned(Disc<double> d) {
    d.position = {-d.position.y, d.position.x};
    d.velocity = {-d.velocity.y, d.velocity.x};
    return d;
}
Disc<double> mirrored(Disc<double> d) {
    d.position.x = -d.position.x;
    d.velocity.x = -d.velocity.x;
    return d;
}
Vec2d turned(Vec2d v) {
    return {-v.y, v.x};
}
Vec2d mirrored(Vec2d v) {
    return {-v.x, v.y};
}

// A at the left of B, moving right at v; φ between its velocity and the line of centres.
PairCollision<double> oblique(double ma, double mb, double phi, double e, double v = 1) {
    const Disc<double> b{mb, 0.1, {0, 0}, {0, 0}};
    const Disc<double> a{ma, 0.1, {-0.2 * std::cos(phi), 0.2 * std::sin(phi)}, {v, 0}};
    return collide(a, b, e);
}
double angleBetween(Vec2d a, Vec2d b) {
    return std::atan2(std::abs(cross(a, b)), dot(a, b));
}

} // namespace

class TestCollision : public QObject {
    Q_OBJECT

private slots:
    void everyStepAgreesWithFiftyDigits() {
        QVERIFY(worstOf<float>("float", 40'000, 1e3) < boundInEpsilons);
        QVERIFY(worstOf<double>("double", 100'000, 1e3) < boundInEpsilons);
        QVERIFY(worstOf<Quad>("quad", 20'000, 1e3) < boundInEpsilons);
    }

    // Masses up to 10¹⁵ apart (10⁻⁷·⁵ to 10⁷·⁵).
    void masses15OrdersApart() {
        QVERIFY(worstOf<float>("float", 10'000, 3.1622776e7) < boundInEpsilons);
        QVERIFY(worstOf<double>("double", 10'000, 3.1622776e7) < boundInEpsilons);
    }

    void lawsHold() {
        Random random(7);
        constexpr double eps = std::numeric_limits<double>::epsilon();
        for (int k = 0; k < 100'000; ++k) {
            const auto [a, b] = randomPair<double>(random, 1e3);
            const double e = pickRestitution(random);
            const auto c = collide(a, b, e);
            const double v = std::max(norm(a.velocity), norm(b.velocity));
            const Vec2d p =
                a.mass * c.after.first + b.mass * c.after.second - a.mass * a.velocity - b.mass * b.velocity;
            QVERIFY(norm(p) <= 32 * eps * (a.mass + b.mass) * v);
            QVERIFY(norm(c.momentumResidual - p) <= 8 * eps * (a.mass + b.mass) * v);
            QVERIFY(std::abs(c.restitutionResidual) <= 32 * eps * v);
            QCOMPARE(c.exchanged.first.y, c.rotated.first.y);
            QCOMPARE(c.exchanged.second.y, c.rotated.second.y);
            QVERIFY(c.energyLoss >= 0);
            const auto energy = [&](const VelocityPair<double>& u) {
                return (a.mass * dot(u.first, u.first) + b.mass * dot(u.second, u.second)) / 2;
            };
            QVERIFY(std::abs(energy(c.before) - energy(c.after) - c.energyLoss) <=
                    64 * eps * (a.mass + b.mass) * v * v);
            QCOMPARE(c.impulse > 0, c.rotated.second.x > c.rotated.first.x);
        }
    }

    // Exchanging the names, a mirror and a quarter turn change no bit of the outcome.
    void symmetryToTheLastBit() {
        Random random(11);
        for (int k = 0; k < 20'000; ++k) {
            const auto [a, b] = randomPair<double>(random, 1e3);
            const double e = pickRestitution(random);
            const auto c = collide(a, b, e);
            const auto swapped = collide(b, a, e);
            QVERIFY(swapped.after.first == c.after.second && swapped.after.second == c.after.first);
            QCOMPARE(swapped.energyLoss, c.energyLoss);
            QCOMPARE(swapped.impulse, c.impulse);
            const auto turn = collide(turned(a), turned(b), e);
            QVERIFY(turn.after.first == turned(c.after.first));
            QVERIFY(turn.after.second == turned(c.after.second));
            QVERIFY(turn.exchanged.first == c.exchanged.first);
            const auto mirror = collide(mirrored(a), mirrored(b), e);
            QVERIFY(mirror.after.first == mirrored(c.after.first));
            QVERIFY(mirror.after.second == mirrored(c.after.second));
        }
    }

    void headOn() {
        Random random(13);
        for (int k = 0; k < 1000; ++k) {
            const double ma = random.logUniform(1e-3, 1e3), mb = random.logUniform(1e-3, 1e3);
            const double e = pickRestitution(random), v = random.in(0.1, 10);
            const auto c = oblique(ma, mb, 0, e, v);
            QVERIFY(std::abs(c.after.first.x - (ma - e * mb) * v / (ma + mb)) < 1e-14 * v);
            QVERIFY(std::abs(c.after.second.x - (1 + e) * ma * v / (ma + mb)) < 1e-14 * v);
            QCOMPARE(c.after.first.y, 0.0);
            QCOMPARE(c.after.second.y, 0.0);
        }
        // Equal masses and e = 1 exchange their velocities to the bit; e = 0 makes them equal to the bit.
        const auto swap = oblique(1.7, 1.7, 0, 1, 0.3);
        QCOMPARE(swap.after.first.x, 0.0);
        QCOMPARE(swap.after.second.x, 0.3);
        const auto stick = oblique(1.7, 1.7, 0, 0, 0.3);
        QCOMPARE(stick.after.first.x, stick.after.second.x);
    }

    // Equal masses part at 90° - atan[((1 - e)/2) cot φ]; 90° for e = 1.
    void angleOfParting() {
        for (const double e : {0.0, 0.3, 0.75, 0.999, 1.0}) {
            for (int degree = 1; degree < 90; ++degree) {
                const double phi = degree * std::numbers::pi / 180;
                const auto c = oblique(1.3, 1.3, phi, e);
                const double expected = std::numbers::pi / 2 - std::atan((1 - e) / 2 / std::tan(phi));
                QVERIFY(std::abs(angleBetween(c.after.first, c.after.second) - expected) < 1e-13);
            }
        }
    }

    // A heavier body on a resting one is turned by at most asin[(1 + e) mB/(2 mA + (1 - e) mB)].
    void largestDeflection() {
        for (const double e : {0.0, 0.5, 1.0}) {
            for (const double mb : {0.1, 0.5, 0.95}) {
                double most = 0;
                for (int k = 1; k < 20'000; ++k) {
                    const double phi = k * std::numbers::pi / 2 / 20'000;
                    most = std::max(most, angleBetween(oblique(1, mb, phi, e).after.first, {1, 0}));
                }
                QVERIFY(std::abs(std::sin(most) - (1 + e) * mb / (2 + (1 - e) * mb)) < 1e-7);
            }
        }
    }

    void walls() {
        Random random(17);
        for (int k = 0; k < 10'000; ++k) {
            const auto d = randomDisc<double>(random, 1e-3, 1e3);
            const double e = pickRestitution(random);
            for (const Side side : sides) {
                const auto c = collideWithSide(d, side, e);
                const bool upright = side == Side::Left || side == Side::Right;
                const Vec2d expected =
                    upright ? Vec2d{-e * d.velocity.x, d.velocity.y} : Vec2d{d.velocity.x, -e * d.velocity.y};
                QVERIFY(c.after.first == expected);
                const double normal = upright ? d.velocity.x : d.velocity.y;
                const double inwards = side == Side::Left || side == Side::Bottom ? normal : -normal;
                QVERIFY(std::abs(c.energyLoss - d.mass * (1 - e * e) * normal * normal / 2) <=
                        1e-14 * d.mass * normal * normal);
                QVERIFY(std::abs(c.impulse + (1 + e) * d.mass * inwards) <=
                        1e-14 * d.mass * std::abs(normal));
                QCOMPARE(c.restitutionResidual, 0.0);
                QVERIFY(std::isinf(c.second.mass) && c.second.velocity == Vec2d{});
                QCOMPARE(norm(d.position - c.second.position), d.radius);
            }
        }
    }

    // A wall at any angle is the limit of a body without bound in mass.
    void aWallIsAnEndlessMass() {
        Random random(19);
        for (int k = 0; k < 1000; ++k) {
            auto [a, b] = randomPair<double>(random, 10);
            b.velocity = {};
            b.mass = 1e25;
            const double e = pickRestitution(random);
            const auto limit = collide(a, b, e);
            const auto wall = collideWithWall(a, b.position, limit.contact, e);
            const double v = norm(a.velocity);
            QVERIFY(norm(wall.after.first - limit.after.first) < 4e-15 * v);
            QVERIFY(std::abs(wall.impulse - limit.impulse) < 4e-15 * a.mass * v);
            QVERIFY(std::abs(wall.energyLoss - limit.energyLoss) < 4e-15 * a.mass * v * v);
        }
    }

    void coincidentCentres() {
        const Disc<double> a{1, 0.1, {0.3, -2}, {1, 0.5}}, b{2, 0.1, {0.3, -2}, {-1, 0.25}};
        const auto c = collide(a, b, 1.0);
        QCOMPARE(c.contact.Z, 0.0);
        QCOMPARE(c.contact.cosTheta, 1.0);
        QCOMPARE(c.contact.sinTheta, 0.0);
        QVERIFY(c.rotated.first == a.velocity && c.rotated.second == b.velocity);
        QVERIFY(std::abs(c.after.first.x + 5.0 / 3) < 1e-15 && std::abs(c.after.second.x - 1.0 / 3) < 1e-15);
        QCOMPARE(c.after.first.y, 0.5);
        QCOMPARE(c.after.second.y, 0.25);
    }
};

QTEST_GUILESS_MAIN(TestCollision)
#include "test_collision.moc"
