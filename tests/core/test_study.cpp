// The study of speed against accuracy: its cases, its measures and its bookkeeping, against what is known
// without it.
#include "core/scene/builtin.h"
#include "core/study/compare_runs.h"
#include "core/study/measure_cost.h"
#include "core/study/parting.h"
#include "core/study/study.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace thetalane;

namespace {

Run runOf(const Method& method, const Scene& scene, double until) {
    return std::get<Run>(runMethod(method, scene, until));
}

const MethodResult& resultOf(const StudyResult& result, const Method& method) {
    for (const MethodResult& r : result.methods)
        if (r.method == method)
            return r;
    qFatal("no such method");
}

StudyOptions optionsOf(std::vector<Method> methods, int costRounds = 0) {
    StudyOptions options;
    options.methods = std::move(methods);
    options.costRounds = costRounds;
    return options;
}

// Two balls that meet at 0.5 s, and one far away.
Scene meeting(double speed = 1) {
    Scene scene;
    scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {-0.7, 0}, {speed, 0}},
                    {"B", BodyKind::Ball, 1, 0.1, {0, 0}, {}},
                    {"C", BodyKind::Ball, 1, 0.1, {0, 9}, {}}};
    return scene;
}

} // namespace

class TestStudy : public QObject {
    Q_OBJECT

private slots:
    void throwsAreTheSameForTheSameSeed() {
        const StudyCases a = rackThrows(50, 7), b = rackThrows(50, 7), c = rackThrows(50, 8);
        QVERIFY(a.scenes == b.scenes);
        QVERIFY(a.scenes != c.scenes);
        QCOMPARE(a.until, 2.0);
        // More of them begin with the same ones, and all are within what was promised.
        const StudyCases more = rackThrows(400, 7);
        for (std::size_t k = 0; k < 50; ++k)
            QVERIFY(more.scenes[k] == a.scenes[k]);
        double least = 1, most = -1;
        for (const Scene& s : more.scenes) {
            const Body& ball = s.bodies.front();
            const double angle = std::atan2(ball.velocity.x, ball.velocity.y) * 180 / 3.14159265358979;
            const double offset =
                ball.position.x - ball.position.y * std::tan(angle * 3.14159265358979 / 180);
            QVERIFY(angle >= 0 && angle <= 6 + 1e-9);
            QVERIFY(std::abs(offset) <= 0.16 + 1e-9);
            QVERIFY(std::abs(norm(ball.velocity) - 6.8) < 1e-12);
            QCOMPARE(s.restitution, 0.75);
            QVERIFY(!s.friction && !s.lane);
            least = std::min(least, offset);
            most = std::max(most, offset);
        }
        QVERIFY(least < -0.155 && most > 0.155);
    }

    void laneThrowsReachTheRack() {
        const StudyCases cases = laneThrows(40, 3);
        QCOMPARE(cases.scenes.size(), std::size_t(40));
        int touched = 0;
        for (const Scene& s : cases.scenes) {
            QVERIFY(s.friction && s.lane && !s.friction->oil.empty());
            touched += runOf(eventMethod(), s, cases.until).timeline.collisionCount() > 0;
        }
        QVERIFY(touched >= 38); // within 16 cm of the head pin one reaches some pin, but for the very edge
    }

    void aRunAgreesWithItself() {
        const Scene scene = *builtinScene("rack");
        const Run run = runOf(eventMethod(), scene, 2);
        const CaseError e = compareRuns(run, run, 2);
        QVERIFY(e.sameTouched && e.sameDown && e.firstDifference < 0);
        QCOMPARE(e.missed + e.repeated, 0);
        QCOMPARE(e.furthest + e.energyDrift + e.momentumDrift, 0.0);
        QVERIFY(e.collisions > 10);
    }

    // Without the collision A goes on and B stays: at 2 s both are 1.5 m off, of three bodies.
    void positionErrorIsTheRmsOverTheBodies() {
        const Run truth = runOf(eventMethod(), meeting(), 2);
        QCOMPARE(truth.timeline.collisionCount(), 1);
        Scene apart = meeting();
        apart.bodies[1].position.y = 0; // the same scene, run so coarsely that they pass through each other
        const Run run = runOf(steppedMethod(2, false), apart, 2);
        QCOMPARE(run.timeline.collisionCount(), 0);
        const CaseError e = compareRuns(truth, run, 2);
        QVERIFY(std::abs(e.position.back() - std::sqrt(2 * 1.5 * 1.5 / 3)) < 1e-12);
        QVERIFY(std::abs(e.furthest - 1.5) < 1e-12);
        QCOMPARE(e.missed, 1);
        QCOMPARE(e.firstDifference, 0);
        QVERIFY(std::abs(e.differenceTime - 0.5) < 1e-12);
        QVERIFY(!e.sameTouched);
        QVERIFY(e.sameDown); // there are no pins
    }

    // At 0.01 m a step they overlap for many steps, and each exchanges again.
    void repeatedContactsAreCounted() {
        Scene scene = meeting();
        scene.restitution = 0; // they stay together, and overlap for ever
        const Run truth = runOf(eventMethod(), scene, 2);
        const Run run = runOf(steppedMethod(0.01, false), scene, 2);
        const CaseError e = compareRuns(truth, run, 2);
        QCOMPARE(e.missed, 0);
        QCOMPARE(e.repeated, run.timeline.collisionCount() - 1);
        QVERIFY(e.repeated > 100);
    }

    void partingIsWhereItHappens() {
        const Run truth = runOf(eventMethod(), meeting(), 2);
        const Run late = runOf(steppedMethod(2, false), meeting(), 2);
        const auto parting = firstParting(truth, late, 0.1);
        QVERIFY(parting.has_value());
        QVERIFY(std::abs(parting->time - 0.6) < 1e-9); // 0.1 s after the impact at 1 m/s
        QVERIFY(parting->body == 0 || parting->body == 1);
        QVERIFY(std::abs(norm(parting->truth - parting->run) - 0.1) < 1e-9);
        QVERIFY(!firstParting(truth, truth, 1e-15));
    }

    void contactsOfOneInstantHaveNoOrder() {
        Timeline empty;
        TimelineRecord a, b;
        for (TimelineRecord* r : {&a, &b}) {
            for (int body = 0; body < 4; ++body)
                r->segments.push_back({body, {}});
            r->collisions.resize(2);
            r->collisions[0].second = 1;
            r->collisions[1].first = 2;
            r->collisions[1].second = 3;
            r->endTime = 1;
        }
        a.collisions[0].time = 0.1;
        a.collisions[1].time = 0.2;
        std::swap(b.collisions[0], b.collisions[1]);
        b.collisions[0].time = b.collisions[1].time = 0.2;
        QVERIFY(!firstDifference(Timeline(4, a), Timeline(4, b)));
        b.collisions[1].time = 0.3;
        QCOMPARE(firstDifference(Timeline(4, a), Timeline(4, b)).value(), std::size_t(0));
        b.collisions.pop_back();
        b.collisions[0] = a.collisions[0];
        QCOMPARE(firstDifference(Timeline(4, a), Timeline(4, b)).value(), std::size_t(1));
    }

    // 100 of the 4,000 frictionless throws; the study of all of them prints the same figures.
    void theExactEngineTouchesTheSamePins() {
        const StudyCases cases = rackThrows(100);
        const StudyResult result = runStudy(
            cases, optionsOf({eventMethod(), eventMethod(Precision::Float), steppedMethod(1.0 / 1000, false),
                              steppedMethod(1.0 / 1000, true), sweptMethod(1.0 / 1000, 4)}));
        QCOMPARE(result.cases, cases.scenes.size());
        QVERIFY(!result.cancelled);
        QVERIFY(result.truthDigits > 20 && result.truthDigits < 34);
        const MethodResult& exact = result.methods[0];
        QCOMPARE(exact.sameTouched, 1.0);
        QCOMPARE(exact.sameDown, 1.0);
        QVERIFY(exact.error().median < 1e-12);
        QVERIFY(exact.energyDrift < 1e-14 && exact.momentumDrift < 1e-14);
        QVERIFY(result.methods[1].error().median > 1e-7 && result.methods[1].error().median < 1e-3);
        // What the paper's loop is known for: it never converges, and its exchange is repeated again and
        // again.
        const MethodResult &loop = result.methods[2], &approaching = result.methods[3];
        QVERIFY(loop.sameTouched > 0.15 && loop.sameTouched < 0.55);
        QVERIFY(loop.repeated > 100);
        QVERIFY(approaching.sameTouched > 0.55 && approaching.sameTouched < 0.9);
        QCOMPARE(approaching.repeated, 0.0);
        QVERIFY(loop.error().median > approaching.error().median);
        QVERIFY(result.methods[4].error().median < approaching.error().median);
    }

    void theReferenceHasNoError() {
        const StudyResult result = runStudy(rackThrows(5), optionsOf({referenceMethod()}));
        QCOMPARE(result.methods[0].state, MethodState::Measured);
        QCOMPARE(result.methods[0].error().worst, 0.0);
        QCOMPARE(result.methods[0].sameOrder, 1.0);
    }

    void threadsChangeNothing() {
        const auto options = optionsOf(studyMethods(MethodSet::Quick));
        StudyOptions alone = options, together = options;
        alone.threads = 1;
        together.threads = 3;
        const StudyCases cases = rackThrows(20, 5);
        const StudyResult a = runStudy(cases, alone), b = runStudy(cases, together);
        for (std::size_t m = 0; m < a.methods.size(); ++m) {
            QCOMPARE(a.methods[m].error().median, b.methods[m].error().median);
            QCOMPARE(a.methods[m].error().rms, b.methods[m].error().rms);
            QCOMPARE(a.methods[m].sameTouched, b.methods[m].sameTouched);
            QCOMPARE(a.methods[m].collisions, b.methods[m].collisions);
        }
    }

    void costsAreMeasuredInTurn() {
        const StudyResult result =
            runStudy(rackThrows(8),
                     optionsOf({eventMethod(), steppedMethod(0.01, true), steppedMethod(0.0005, true)}, 3));
        for (const MethodResult& r : result.methods) {
            QCOMPARE(r.costRounds, 3);
            QVERIFY(r.cost.lower > 0 && r.cost.lower <= r.cost.median && r.cost.median <= r.cost.upper);
            QVERIFY(std::abs(r.costPerSecond - r.cost.median / 2) < 1e-9 * r.cost.median);
        }
        QCOMPARE(result.methods[0].costRatio, 1.0);
        // Twenty times the steps; wide, as other things run on the machine.
        QVERIFY(result.methods[2].cost.median > 5 * result.methods[1].cost.median);
    }

    void aCancelledStudyKeepsAndLabelsWhatItHas() {
        std::stop_source stop;
        const StudyCases cases = rackThrows(4000);
        auto options = optionsOf(studyMethods(MethodSet::Standard));
        const StudyResult result = runStudy(
            cases, options,
            [&](const StudyResult& soFar, const StudyProgress& p) {
                if (p.stage == StudyStage::Errors && soFar.cases > 0)
                    stop.request_stop();
            },
            stop.get_token());
        QVERIFY(result.cancelled);
        QVERIFY(result.cases > 0 && result.cases < cases.scenes.size());
        QCOMPARE(result.casesAsked, cases.scenes.size());
        const MethodResult& exact = result.methods[0];
        QVERIFY(exact.cases >= result.cases);
        QCOMPARE(exact.sameTouched, 1.0);

        std::stop_source before;
        before.request_stop();
        const StudyResult nothing = runStudy(rackThrows(3), options, {}, before.get_token());
        QVERIFY(nothing.cancelled);
        QCOMPARE(nothing.cases, std::size_t(0));
        for (const MethodResult& r : nothing.methods)
            QVERIFY(r.cases == 0 && r.costRounds == 0 && r.state != MethodState::Measured);
    }

    void theFirstLookIsWholeAndEarly() {
        int looks = 0;
        std::size_t firstCases = 0;
        bool withCosts = false;
        (void)runStudy(rackThrows(60), optionsOf(studyMethods(MethodSet::Quick), 2),
                       [&](const StudyResult& soFar, const StudyProgress& p) {
                           if (p.stage == StudyStage::Cost && p.done > 0 && looks++ == 0) {
                               firstCases = soFar.cases;
                               withCosts = soFar.methods.back().costRounds == 1;
                           }
                       });
        QCOMPARE(looks, 2);
        QVERIFY(firstCases >= 8 && firstCases < 60);
        QVERIFY(withCosts);
    }

    void whatCannotBeRunIsRefused() {
        Method none = steppedMethod(0, false), backwards = steppedMethod(-1, false),
               endless = steppedMethod(1e-12, false);
        Method notANumber = sweptMethod(std::nan(""), 1), noPasses = sweptMethod(0.01, 0);
        const StudyResult result = runStudy(
            rackThrows(2), optionsOf({eventMethod(), none, backwards, endless, notANumber, noPasses}, 1));
        QCOMPARE(result.methods[0].state, MethodState::Measured);
        const RefusalReason reasons[] = {RefusalReason::StepNotPositive, RefusalReason::StepNotPositive,
                                         RefusalReason::TooManySteps, RefusalReason::StepNotPositive,
                                         RefusalReason::PassesNotPositive};
        for (std::size_t m = 1; m < result.methods.size(); ++m) {
            QCOMPARE(result.methods[m].state, MethodState::Refused);
            QCOMPARE(result.methods[m].refusal.reason, reasons[m - 1]);
            QCOMPARE(result.methods[m].costRounds, 0);
        }
    }

    void whatTakesTooLongIsLeftOut() {
        auto options = optionsOf({eventMethod(), steppedMethod(1e-6, true)}, 1);
        options.patience = 0.2;
        const StudyResult result = runStudy(oneScene(*builtinScene("gas-100"), 2), options);
        QVERIFY(result.until < 2 && result.until > 0); // as far as the reference got
        QCOMPARE(result.untilAsked, 2.0);
        QCOMPARE(result.methods[0].state, MethodState::Measured);
        QVERIFY(result.methods[0].sameOrder == 1.0 || result.truthDigits < 18);
        QCOMPARE(result.methods[1].state, MethodState::TooSlow);
        QVERIFY(result.methods[1].cost.median > 0.2e6);
    }

    void aModelLeftOutIsLeftOut() {
        const Scene lane = laneThrows(1).scenes.front();
        QVERIFY(!sceneFor(without(Model::Friction), lane).friction);
        QVERIFY(sceneFor(without(Model::Oil), lane).friction->oil.empty());
        QCOMPARE(sceneFor(without(Model::Spin), lane).bodies[0].spin, Spin<double>{});
        QCOMPARE(sceneFor(without(Model::WallRestitution), lane).lane->kickbacks->restitution, 1.0);
        QCOMPARE(sceneFor(without(Model::Restitution), lane).restitution, 1.0);
        QVERIFY(!settingsFor(without(Model::Ties), 1).ties);
        QVERIFY(sceneFor(eventMethod(), lane) == lane);
        QCOMPARE(ablationMethods(lane).size(), std::size_t(7));
        QCOMPARE(ablationMethods(*builtinScene("two-balls")).size(), std::size_t(1));
    }

    void leavingFrictionOutChangesThePinsDown() {
        const StudyCases cases = laneThrows(60);
        const StudyResult result = runStudy(cases, ablationStudy(cases.scenes.front()));
        QCOMPARE(result.methods[0].sameDown, 1.0);
        QVERIFY(resultOf(result, without(Model::Friction)).sameDown < 0.5);
        QVERIFY(resultOf(result, without(Model::Friction)).costRatio < 0.8);
        QVERIFY(resultOf(result, without(Model::Spin)).sameDown < 0.5);
        // The ball does not roll on the walls: only pins that fly are thrown back otherwise.
        QVERIFY(resultOf(result, without(Model::WallRestitution)).sameDown > 0.3);
    }

    void quartilesAreWhatTheyAre() {
        const Quartiles q = quartilesOf({5, 1, 4, 2, 3});
        QCOMPARE(q.lower, 2.0);
        QCOMPARE(q.median, 3.0);
        QCOMPARE(q.upper, 4.0);
        QCOMPARE(quartilesOf({}).median, 0.0);
    }

    void standardMethodsAreDifferentAndHaveWhatIsPromised() {
        for (const MethodSet set : {MethodSet::Quick, MethodSet::Standard, MethodSet::All}) {
            const auto methods = studyMethods(set);
            QVERIFY(methods[0] == eventMethod());
            QVERIFY(isReference(methods[1]));
            for (std::size_t i = 0; i < methods.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY(!(methods[i] == methods[j]));
        }
        std::set<double> steps;
        for (const Method& m : studyMethods(MethodSet::Standard))
            if (m.settings.kind == EngineKind::Stepped)
                steps.insert(m.settings.step);
        QCOMPARE(*steps.begin(), 1.0 / 1000);
        QCOMPARE(*steps.rbegin(), 1.0 / 30);
    }
};

QTEST_GUILESS_MAIN(TestStudy)
#include "test_study.moc"
