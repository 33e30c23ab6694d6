// Contacts at the same instant: resolved together, passed on, mirror images of each other.
#include "core/collision/contact_group.h"
#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/builtin.h"
#include "tests/core/support.h"

#include <QTest>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

Scene sceneOf(double e, std::vector<Body> bodies) {
    Scene scene;
    scene.restitution = e;
    scene.bodies = std::move(bodies);
    return scene;
}

// A cue along x onto two at rest at ±angle, touching both at once; all turned by `turn`.
Scene cueOnTwo(double e, double angle, double turn, double targetMass = 1) {
    const double reach = 0.2;
    const auto turned = [turn](Vec2d p) {
        return Vec2d{p.x * std::cos(turn) - p.y * std::sin(turn),
                     p.x * std::sin(turn) + p.y * std::cos(turn)};
    };
    const Vec2d up{reach * std::cos(angle), reach * std::sin(angle)};
    return sceneOf(e, {disc(0, 1, 0.1, turned({-0.5, 0}), turned({1, 0})),
                       disc(1, targetMass, 0.1, turned(up), {}),
                       disc(2, targetMass, 0.1, turned({up.x, -up.y}), {})});
}

// The mirror image at the y axis, body by body of `twin`.
double asymmetry(std::span<const BodyState> states, const std::vector<std::size_t>& twin) {
    double worst = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState &a = states[i], &b = states[twin[i]];
        worst = std::max({worst, std::abs(a.position.x + b.position.x), std::abs(a.position.y - b.position.y),
                          std::abs(a.velocity.x + b.velocity.x), std::abs(a.velocity.y - b.velocity.y)});
    }
    return worst;
}

// Bodies on the axis and mirrored pairs beside it, thrown so that the whole is its own image.
Scene mirroredScene(Random& random, double e, std::vector<std::size_t>& twin) {
    Scene scene;
    scene.restitution = e;
    twin.clear();
    const auto free = [&scene](Vec2d p, double r) {
        return std::all_of(scene.bodies.begin(), scene.bodies.end(),
                           [&](const Body& b) { return norm(b.position - p) > b.radius + r + 1e-3; });
    };
    const int pairs = 1 + random.below(4), single = random.below(3);
    while (int(scene.bodies.size()) < single) {
        const double r = random.in(0.05, 0.12);
        const Vec2d p{0, random.in(-0.8, 0.8)};
        if (!free(p, r))
            continue;
        twin.push_back(scene.bodies.size());
        scene.bodies.push_back(
            disc(int(scene.bodies.size()), random.logUniform(0.3, 3), r, p, {0, random.in(-1, 1)}));
    }
    while (int(scene.bodies.size()) < single + 2 * pairs) {
        const double r = random.in(0.05, 0.12);
        const Vec2d p{random.in(r + 1e-3, 0.9), random.in(-0.8, 0.8)};
        if (!free(p, r))
            continue;
        const Vec2d v{random.in(-1, 0.3), random.in(-1, 1)};
        const double mass = random.logUniform(0.3, 3);
        const std::size_t n = scene.bodies.size();
        twin.insert(twin.end(), {n + 1, n});
        scene.bodies.push_back(disc(int(n), mass, r, p, v));
        scene.bodies.push_back(disc(int(n) + 1, mass, r, {-p.x, p.y}, {-v.x, v.y}));
    }
    return scene;
}

} // namespace

class TestTies : public QObject {
    Q_OBJECT

private slots:
    // Equal masses, targets at ±30°, e = 1: cue -v/5, each target .6928 v.
    void cueOnTwoAtOnce() {
        for (const double turn : {0.0, 0.3, 1.0, 2.5, -1.2}) {
            const Timeline timeline = runOf(cueOnTwo(1, std::numbers::pi / 6, turn), eventSettings(1));
            QCOMPARE(timeline.collisionCount(), 2);
            for (const Collision& c : timeline.collisions()) {
                QCOMPARE(c.group, 1);
                QCOMPARE(c.pass, 1);
                QCOMPARE(c.together, 2);
                QVERIFY(std::abs(c.steps.restitutionResidual) < 1e-15);
                QVERIFY(norm(c.steps.momentumResidual) < 1e-15);
                QVERIFY(std::abs(c.steps.energyLoss) < 1e-15);
            }
            const auto end = timeline.stateAt(1);
            QVERIFY(std::abs(norm(end[0].velocity) - 0.2) < 1e-14);
            QVERIFY(norm(end[0].velocity + Vec2d{std::cos(turn), std::sin(turn)} * 0.2) < 1e-14);
            for (int k = 1; k <= 2; ++k)
                QVERIFY(std::abs(norm(end[k].velocity) - 0.4 * std::sqrt(3.0)) < 1e-14);
        }
    }

    // From momentum along the axis and each contact's e-law: target speed u = (1 + e) cos φ v/(1 + 2 (M/m)
    // cos²φ), the cue's v - 2 (M/m) u cos φ, with M the target's mass.
    void cueOnTwoAtAnyRestitution() {
        for (const double e : {0.0, 0.3, 0.75, 1.0})
            for (const double angle : {0.53, 0.7, 1.0, 1.4})
                for (const double mass : {0.1, 1.0, 7.0}) {
                    const auto end = runOf(cueOnTwo(e, angle, 0, mass), eventSettings(0.6)).stateAt(0.6);
                    const double c = std::cos(angle), u = (1 + e) * c / (1 + 2 * mass * c * c);
                    QVERIFY(std::abs(norm(end[1].velocity) - u) < 1e-14);
                    QVERIFY(std::abs(end[0].velocity.x - (1 - 2 * mass * u * c)) < 1e-14);
                    QCOMPARE(end[1].velocity.x, end[2].velocity.x);
                    QCOMPARE(end[1].velocity.y, -end[2].velocity.y);
                    QCOMPARE(end[0].velocity.y, 0.0);
                }
    }

    // A cradle whose balls touch: the impulse goes through one contact at a time, all at one instant.
    void touchingChainPassesOn() {
        for (int n = 3; n <= 8; ++n) {
            std::vector<Body> balls{disc(0, 1.3, 0.0625, {-0.5, 0}, {1, 0})};
            for (int k = 1; k < n; ++k)
                balls.push_back(disc(k, 1.3, 0.0625, {0.125 * k, 0}, {}));
            const Timeline timeline = runOf(sceneOf(1, balls), eventSettings(2));
            QCOMPARE(timeline.collisionCount(), n - 1);
            int pass = 0;
            for (const Collision& c : timeline.collisions()) {
                QCOMPARE(c.group, 1);
                QCOMPARE(c.pass, ++pass);
                QCOMPARE(c.together, 1);
                QCOMPARE(c.time, timeline.collisions()[0].time);
            }
            const auto end = timeline.stateAt(2);
            for (int k = 0; k < n - 1; ++k)
                QCOMPARE(end[k].velocity, (Vec2d{0, 0}));
            QCOMPARE(end[n - 1].velocity, (Vec2d{1, 0}));
        }
    }

    // Two from the left onto a touching row: two leave on the right.
    void twoIntoACradle() {
        const double d = 0.125;
        std::vector<Body> balls;
        for (int k = 0; k < 5; ++k)
            balls.push_back(disc(k, 1, d / 2, {k < 2 ? -1 + d * k : d * k, 0}, {k < 2 ? 1.0 : 0.0, 0}));
        const auto end = runOf(sceneOf(1, balls), eventSettings(3)).stateAt(3);
        for (int k = 0; k < 5; ++k)
            QCOMPARE(end[k].velocity, (Vec2d{k < 3 ? 0.0 : 1.0, 0}));
    }

    // A ball straight down the middle: the rack is its own mirror image, to the last bit.
    void aRackHeadOnStaysSymmetric() {
        const std::vector<std::size_t> twin{0, 1, 3, 2, 6, 5, 4, 10, 9, 8, 7};
        for (const double e : {0.0, 0.5, 0.75, 1.0})
            for (const double speed : {2.0, 6.8}) {
                const Timeline timeline = runOf(rackScene(0, 0, speed, e), eventSettings(5));
                QVERIFY(timeline.collisionCount() > 4);
                QCOMPARE(asymmetry(timeline.stateAt(5), twin), 0.0);
                for (const Collision& c : timeline.collisions())
                    QVERIFY(c.first != 2 || c.second != 3 || c.together == 1);
            }
    }

    void mirrorScenesStayMirrorImages() {
        Random random(71);
        int exact = 0;
        std::int64_t met = 0, together = 0;
        double worst = 0;
        for (int k = 0; k < 2000; ++k) {
            std::vector<std::size_t> twin;
            const Scene scene = mirroredScene(random, random.below(3) / 2.0, twin);
            const Timeline timeline = runOf(scene, eventSettings(3));
            met += timeline.collisionCount();
            for (const Collision& c : timeline.collisions())
                together += c.together > 1;
            const double off = asymmetry(timeline.stateAt(3), twin);
            exact += off == 0;
            worst = std::max(worst, off);
        }
        qInfo("2000 mirrored scenes, %lld collisions, %lld resolved together: %d end equal to the last bit, "
              "the worst is off by %.1e",
              static_cast<long long>(met), static_cast<long long>(together), exact, worst);
        QVERIFY(together > 500);
        QVERIFY(exact >= 1990);
        QVERIFY(worst < 1e-12);
    }

    // Into a corner, at once at both walls, and between a wall and a ball: each contact has its own e.
    void eachContactHasItsOwnRestitution() {
        Scene corner = sceneOf(1, {disc(0, 1, 0.125, {1, 1}, {-1, -1})});
        corner.frame = Frame{0.0, {}, 0.0, {}, 0.5};
        const Timeline timeline = runOf(corner, eventSettings(2));
        QCOMPARE(timeline.collisionCount(), 2);
        QCOMPARE(timeline.bodyAt(0, 2).velocity, (Vec2d{0.5, 0.5}));

        // A ball comes to the wall (e = 0) and to a heavy one that waits above (e = 1) at the same instant.
        Scene both =
            sceneOf(1, {disc(0, 1, 0.125, {1, 0.5}, {-1, 0}), disc(1, 1e12, 0.125, {0.125, 0.75}, {})});
        both.frame = Frame{0.0, {}, {}, {}, 0.0};
        const Timeline met = runOf(both, eventSettings(2));
        QVERIFY(met.collisionCount() >= 1);
        QVERIFY(std::abs(met.bodyAt(0, 2).velocity.x) < 1e-12);
    }

    // The solver alone: the law of each contact, no pull, no energy from nowhere, against random groups.
    void randomGroups() {
        Random random(73);
        double worst = 0;
        for (int k = 0; k < 3000; ++k) {
            const std::size_t bodies = 2 + std::size_t(random.below(6)),
                              count = 1 + std::size_t(random.below(9));
            std::vector<double> inverseMass;
            std::vector<Vec2d> v;
            for (std::size_t b = 0; b < bodies; ++b) {
                inverseMass.push_back(1 / random.logUniform(1e-3, 1e3));
                v.push_back({random.in(-1, 1), random.in(-1, 1)});
            }
            std::vector<GroupContact<double>> contacts;
            std::vector<double> before, e;
            while (contacts.size() < count) {
                const auto first = std::size_t(random.below(int(bodies)));
                const auto other = std::size_t(random.below(int(bodies) + 1));
                if (other == first)
                    continue;
                const std::size_t second = other == bodies ? GroupContact<double>::wall : other;
                const double angle = random.in(-4, 4);
                GroupContact<double> c{first, second, {std::cos(angle), std::sin(angle)}, 0};
                const Vec2d u = second == GroupContact<double>::wall ? v[first] : v[first] - v[second];
                if (dot(c.normal, u) > 0)
                    c.normal = -c.normal;
                before.push_back(dot(c.normal, u));
                e.push_back(random.below(3) / 2.0);
                c.demand = (1 + e.back()) * before.back();
                contacts.push_back(c);
            }
            const auto s = solveContacts<double>(contacts, inverseMass);
            double energyBefore = 0, energyAfter = 0;
            for (std::size_t b = 0; b < bodies; ++b) {
                const Vec2d after = v[b] + s.change[b];
                energyBefore += dot(v[b], v[b]) / inverseMass[b] / 2;
                energyAfter += dot(after, after) / inverseMass[b] / 2;
            }
            QVERIFY(energyAfter <= energyBefore * (1 + 1e-12));
            for (std::size_t i = 0; i < contacts.size(); ++i) {
                const auto& c = contacts[i];
                const Vec2d first = v[c.first] + s.change[c.first];
                const Vec2d second =
                    c.second == GroupContact<double>::wall ? Vec2d{} : v[c.second] + s.change[c.second];
                const double after = dot(c.normal, first - second), scale = norm(first) + norm(second) + 1;
                QVERIFY(s.impulse[i] >= 0);
                QVERIFY(after >= -e[i] * before[i] - 1e-12 * scale);
                if (s.impulse[i] > 0)
                    worst = std::max(worst, std::abs(after + e[i] * before[i]) / scale);
            }
        }
        qInfo("the e-law of a contact that pushes holds to %.1e", worst);
        QVERIFY(worst < 1e-12);
    }

    // Also where a cascade is closed in one pass: what the collisions say they took is what is gone.
    void theLossesAddUp() {
        for (const Precision precision : {Precision::Double, Precision::Float})
            for (const double e : {0.0, 0.01, 0.3, 0.9}) {
                Scene scene = *builtinScene("break");
                scene.restitution = e;
                scene.frame.reset();
                const Timeline timeline = runOf(scene, eventSettings(10, precision));
                const double start = totals(scene, timeline.stateAt(0)).energy;
                double left = start;
                for (const Collision& c : timeline.collisions())
                    left -= c.steps.energyLoss;
                const double missing = left - totals(scene, timeline.stateAt(10)).energy;
                QVERIFY2(std::abs(missing) < start * (precision == Precision::Double ? 1e-12 : 1e-6),
                         qPrintable(QString("e %1: %2 J").arg(e).arg(missing)));
            }
    }

    // More than are solved exactly: a long row between two that come from both ends, and a wall of discs.
    void manyContactsAtOnce() {
        std::vector<Body> bodies;
        for (int k = 0; k < 60; ++k) {
            bodies.push_back(disc(2 * k, 1, 0.0625, {0.2 * k, 0}, {0, 1}));
            bodies.push_back(disc(2 * k + 1, 1, 0.0625, {0.2 * k + 0.1, 0.25}, {0, -1}));
        }
        const Scene scene = sceneOf(1, bodies);
        const Timeline timeline = runOf(scene, eventSettings(1));
        const Totals start = totals(scene, timeline.stateAt(0)), end = totals(scene, timeline.stateAt(1));
        int together = 0;
        for (const Collision& c : timeline.collisions())
            together = std::max(together, c.together);
        QVERIFY2(together > 100, qPrintable(QString::number(together)));
        QVERIFY2(end.energy <= start.energy * (1 + 1e-12) && end.energy > start.energy * (1 - 1e-9),
                 qPrintable(QString::number(end.energy / start.energy - 1)));
        QVERIFY(deepestOverlap(scene, timeline.stateAt(1)) < 1e-13);
    }
};

QTEST_GUILESS_MAIN(TestTies)
#include "test_ties.moc"
