// The strike map: every cell is the throw it says, whatever the threads; parts fit together or are refused.
#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"
#include "core/format/map_csv.h"
#include "core/study/strike_map.h"

#include <QTest>

#include <chrono>
#include <cmath>
#include <numbers>

using namespace thetalane;

namespace {

constexpr double degree = std::numbers::pi / 180;

Run runOf(Scene scene, bool keepDetail = true) {
    EngineSettings settings;
    settings.keepDetail = keepDetail;
    return std::get<Run>(simulate(std::move(scene), settings));
}

MapSettings part(MapSettings s, int first, int count) {
    s.firstRow = first;
    s.rowCount = count;
    return s;
}

MapFile fileOf(const char* name, const MapSettings& s) {
    return {name, mapCsv(computeStrikeMap(s, 1))};
}

const MapFileError* errorOf(const std::variant<StrikeMap, MapFileError>& merged) {
    return std::get_if<MapFileError>(&merged);
}

int strikesInRow(const StrikeMap& map, int row) {
    int strikes = 0;
    for (int column = 0; column < map.columns(); ++column)
        strikes += map.at(column, row).strike();
    return strikes;
}

} // namespace

class TestStrikeMap : public QObject {
    Q_OBJECT

private slots:
    void scenes_data() {
        QTest::addColumn<int>("scene");
        QTest::newRow("rack") << int(MapScene::Rack);
        QTest::newRow("bowling") << int(MapScene::Bowling);
    }

    void cellsAreTheThrowsTheySay_data() { scenes_data(); }
    void cellsAreTheThrowsTheySay() {
        QFETCH(int, scene);
        const MapSettings s = defaultMap(MapScene(scene), 13, 11);
        const StrikeMap map = computeStrikeMap(s, 2);
        QVERIFY(map.whole());
        for (int row = 0; row < 11; ++row)
            for (int column = 0; column < 13; ++column) {
                const auto cellScene = mapScene(s, column, row);
                QVERIFY(cellScene);
                const Run run = runOf(*cellScene);
                const std::vector<int> down = pinsDown(run.scene, run.timeline, run.timeline.endTime());
                PinSet left = allPins; // the ball is body 0, pin k body k
                for (const int body : down)
                    left.reset(std::size_t(body - 1));
                QCOMPARE(map.at(column, row).left(), left);
                QCOMPARE(map.at(column, row).pinsDown(), int(down.size()));
                QCOMPARE(map.at(column, row).strike(), down.size() == 10);
            }
    }

    void threadsDoNotMatter_data() { scenes_data(); }
    void threadsDoNotMatter() {
        QFETCH(int, scene);
        const MapSettings s = defaultMap(MapScene(scene), 37, 29);
        const StrikeMap one = computeStrikeMap(s, 1);
        for (const int threads : {2, 3, 8})
            QVERIFY(computeStrikeMap(s, threads).cells == one.cells);
    }

    // Offset right of the head pin and an angle from the right come from where a right-hander's ball does,
    // and the mirror image from the left.
    void signsAreABowlers() {
        const MapSettings rack = defaultMap(MapScene::Rack, 3, 2);
        const auto right = mapScene(rack, 2, 1);
        QVERIFY(right->bodies[0].velocity.x < 0 && right->bodies[0].velocity.y > 0);
        const double toHeadPin = -right->bodies[0].position.y / right->bodies[0].velocity.y;
        QVERIFY(std::abs(right->bodies[0].position.x + toHeadPin * right->bodies[0].velocity.x - 0.16) <
                1e-12);
        MapSettings mirrored = rack;
        std::swap(mirrored.across.from, mirrored.across.to);
        mirrored.up.to = -mirrored.up.to;
        const auto left = mapScene(mirrored, 2, 1);
        QCOMPARE(left->bodies[0].velocity.x, -right->bodies[0].velocity.x);
    }

    // A whole-lane cell's throw, run by the engine, comes to the pins where and how the cell says.
    void throwsArriveAsAsked() {
        const MapSettings s = defaultMap(MapScene::Bowling, 9, 9);
        for (int row = 0; row < 9; ++row)
            for (int column = 0; column < 9; ++column) {
                const auto t = mapThrow(s, column, row);
                QVERIFY(t);
                QCOMPARE(t->speed, s.base.speed);
                QCOMPARE(t->position, 0.0);
                const auto entry = entryOf(*t, s.friction);
                QVERIFY(entry);
                QVERIFY(std::abs(entry->offset - s.across.at(column)) < 1e-9);
                QVERIFY(std::abs(entry->angle - s.up.at(row)) < 1e-9);
                Scene alone = bowlingScene(*t, 0.75, s.friction, {});
                const Run run = runOf(alone);
                // The engine's own path, where the ball is as far before the head pin as they touch head on.
                const double line = -(regulation::ballRadius + regulation::pinRadius);
                double low = 0, high = run.timeline.endTime();
                for (int k = 0; k < 100; ++k)
                    (run.timeline.bodyAt(0, (low + high) / 2).position.y < line ? low : high) =
                        (low + high) / 2;
                const BodyState there = run.timeline.bodyAt(0, low);
                const double slope = there.velocity.x / there.velocity.y;
                QVERIFY(std::abs(there.position.x - line * slope - entry->offset) < 1e-8);
                QVERIFY(std::abs(std::atan(-slope) - entry->angle) < 1e-8);
                QVERIFY(std::abs(norm(there.velocity) - entry->speed) < 1e-8);
            }
    }

    void throwsThatCannotBe() {
        const Throw base{.speed = 8, .position = 0, .spin = 40};
        QVERIFY(throwArriving(base, 0.07, 6 * degree, houseFriction()));
        QVERIFY(!throwArriving(base, 0.07, 20 * degree, houseFriction()));
        QVERIFY(!throwArriving({.speed = 8, .position = 0, .spin = 0}, 0.07, 6 * degree, houseFriction()));
        QVERIFY(!throwArriving({.speed = 0.3, .position = 0, .spin = 40}, 0.07, 0, houseFriction())); // stops
        // Straight, without friction: the place follows from the angle, within the lane.
        const auto straight = throwArriving(base, 0.07, 1 * degree, std::nullopt);
        QVERIFY(straight);
        QVERIFY(std::abs(entryOf(*straight, std::nullopt)->offset - 0.07) < 1e-12);
        QVERIFY(!throwArriving(base, 0.07, 3 * degree, std::nullopt));
        MapSettings s = defaultMap(MapScene::Bowling, 2, 2);
        s.base.spin = 0;
        const StrikeMap map = computeStrikeMap(s, 1);
        QCOMPARE(int(map.at(0, 1).state), int(MapCell::State::NoThrow));
        QVERIFY(!mapScene(s, 0, 1));
        QVERIFY(!map.at(0, 1).strike());
    }

    // The pocket of the books is one here: 6.8 cm and 5 to 6° strike, head on hardly ever does, and the
    // steeper the ball comes in, the wider the pocket.
    void thePocket_data() { scenes_data(); }
    void thePocket() {
        QFETCH(int, scene);
        const auto strikes = [&](double left, double right, double low, double high) {
            MapSettings s = defaultMap(MapScene(scene));
            s.across = {MapQuantity::Offset, left, right, 41};
            s.up = {MapQuantity::Angle, low * degree, high * degree, 11};
            s.rowCount = 11;
            const StrikeMap map = computeStrikeMap(s, 2);
            int count = 0;
            for (int row = 0; row < 11; ++row)
                count += strikesInRow(map, row);
            return double(count) / (41 * 11);
        };
        QVERIFY(strikes(0.065, 0.071, 5, 6) > 0.95);
        QVERIFY(strikes(-0.01, 0.01, 0, 2) < 0.1);
        QVERIFY(strikes(-0.01, 0.01, 5, 6) < 0.05);
        const double narrow = strikes(0.04, 0.10, 0, 1), middle = strikes(0.04, 0.10, 3, 4),
                     wide = strikes(0.04, 0.10, 7, 8);
        QVERIFY(narrow > 0.1 && middle > 1.2 * narrow && wide > 1.2 * middle);
    }

    void coarseToFine() {
        const MapSettings s = defaultMap(MapScene::Rack, 50, 40);
        std::vector<int> strides;
        std::size_t lastDone = 0, calls = 0;
        StrikeMap coarse;
        MapWatch watch;
        watch.refined = [&](const StrikeMap& map) {
            strides.push_back(map.stride);
            if (map.stride == 16)
                coarse = map;
            for (int row = 0; row < 40; ++row)
                for (int column = 0; column < 50; ++column)
                    QVERIFY(map.at(column, row).known()); // a picture at every stage
        };
        watch.progressed = [&](std::size_t done, std::size_t all) {
            QVERIFY(done >= lastDone && done <= all);
            QCOMPARE(all, std::size_t(2000));
            lastDone = done;
            ++calls;
        };
        const StrikeMap map = computeStrikeMap(s, 1, watch);
        QCOMPARE(strides, (std::vector<int>{16, 8, 4, 2, 1}));
        QCOMPARE(lastDone, std::size_t(2000));
        QVERIFY(calls > 50);
        QCOMPARE(coarse.at(17, 17), map.at(16, 16)); // shows the cell before it that is there
    }

    void stopping() {
        std::stop_source source;
        MapWatch watch;
        watch.refined = [&](const StrikeMap& map) {
            if (map.stride == 4)
                source.request_stop();
        };
        const StrikeMap map =
            computeStrikeMap(defaultMap(MapScene::Rack, 64, 64), 2, watch, source.get_token());
        QCOMPARE(map.stride, 4);
        QVERIFY(!map.whole());
        QVERIFY(map.at(63, 63).known());
        source = std::stop_source();
        source.request_stop();
        QCOMPARE(computeStrikeMap(defaultMap(MapScene::Rack, 8, 8), 2, {}, source.get_token()).stride, 0);
    }

    void otherAxes() {
        MapSettings s = defaultMap(MapScene::Bowling, 9, 7);
        s.across = {MapQuantity::Speed, 6, 8, 9};
        s.up = {MapQuantity::Mass, 4, 7.26, 7};
        QVERIFY(!refusalOf(s));
        const auto t = mapThrow(s, 8, 6);
        QVERIFY(t);
        QCOMPARE(t->speed, 8.0);
        QCOMPARE(t->mass, 7.26);
        QVERIFY(std::abs(entryOf(*t, s.friction)->offset - s.base.offset) < 1e-9);
        s.across = {MapQuantity::Spin, 20, 50, 9};
        QVERIFY(!refusalOf(s));
        QCOMPARE(mapThrow(s, 8, 0)->spin, 50.0);
        MapSettings one = defaultMap(MapScene::Rack, 1, 1);
        QVERIFY(!refusalOf(one));
        QVERIFY(computeStrikeMap(one, 4).whole());
    }

    void refusals_data() {
        QTest::addColumn<int>("fault");
        QTest::newRow("no columns") << int(MapFault::Count);
        QTest::newRow("too many") << int(MapFault::TooManyCells);
        QTest::newRow("same axes") << int(MapFault::SameQuantity);
        QTest::newRow("spin of the rack") << int(MapFault::SpinWithoutFriction);
        QTest::newRow("heavy") << int(MapFault::OutOfRange);
        QTest::newRow("rows") << int(MapFault::Rows);
    }
    void refusals() {
        QFETCH(int, fault);
        MapSettings s = defaultMap(MapScene::Rack, 8, 8);
        switch (MapFault(fault)) {
        case MapFault::Count:
            s.across.count = 0;
            break;
        case MapFault::TooManyCells:
            s.across.count = s.up.count = s.rowCount = 100'000;
            break;
        case MapFault::SameQuantity:
            s.up.quantity = MapQuantity::Offset;
            break;
        case MapFault::SpinWithoutFriction:
            s.up.quantity = MapQuantity::Spin;
            break;
        case MapFault::OutOfRange:
            s.base.mass = 8;
            break;
        case MapFault::Rows:
            s.firstRow = 5;
            s.rowCount = 4;
            break;
        }
        const auto refusal = refusalOf(s);
        QVERIFY(refusal);
        QCOMPARE(int(refusal->fault), fault);
    }

    // Parts of a map, in any order, are to the byte what the whole gives.
    void partsFitTogether_data() { scenes_data(); }
    void partsFitTogether() {
        QFETCH(int, scene);
        MapSettings s = defaultMap(MapScene(scene), 7, 10);
        s.base.mass = 6.123456789;
        s.across.from = 0.01; // the last value of these, stepped to from the first, is off by rounding
        s.across.to = 0.0333;
        s.up.from = -7.3 * degree;
        s.up.to = 3.1 * degree;
        const QByteArray whole = fileOf("whole", s).text;
        QVERIFY(whole.startsWith("offset_m,angle_deg,pins_down,strike,"));
        QCOMPARE(whole.count('\n'), 71);
        MapFile parts[] = {fileOf("b", part(s, 4, 5)), fileOf("c", part(s, 9, 1)),
                           fileOf("a", part(s, 0, 4))};
        parts[1].text.replace("\n", "\r\n"); // carried through another system
        const auto merged = mergeMaps(parts);
        QVERIFY(!errorOf(merged));
        QCOMPARE(mapCsv(std::get<StrikeMap>(merged)), whole);
        QVERIFY(std::get<StrikeMap>(merged).cells == computeStrikeMap(s, 1).cells);
    }

    void partsThatDoNotFit_data() {
        QTest::addColumn<QList<QByteArray>>("texts");
        QTest::addColumn<int>("fault");
        QTest::addColumn<QString>("column");
        QTest::addColumn<int>("place"); // line, or row
        const MapSettings s = defaultMap(MapScene::Rack, 3, 6);
        const QByteArray low = fileOf("a", part(s, 0, 3)).text, high = fileOf("b", part(s, 3, 3)).text;
        const auto row = [&](const char* name, const QList<QByteArray>& texts, MapFileFault fault,
                             const char* column = "", int place = 0) {
            QTest::newRow(name) << texts << int(fault) << QString(column) << place;
        };
        const auto changed = [](QByteArray text, const char* from, const char* to) {
            return text.replace(text.indexOf(from), qsizetype(qstrlen(from)), to);
        };
        MapSettings other = part(s, 3, 3);
        other.base.speed = 7;
        row("another speed", {low, fileOf("b", other).text}, MapFileFault::OtherSettings, "speed_m_s", 2);
        other = part(s, 3, 3);
        other.restitution = 0.5;
        row("another e", {low, fileOf("b", other).text}, MapFileFault::OtherSettings, "restitution", 2);
        row("another scene", {low, fileOf("b", part(defaultMap(MapScene::Bowling, 3, 6), 3, 3)).text},
            MapFileFault::OtherSettings, "scene", 2);
        other = part(s, 3, 3);
        other.up.to = 6 * degree;
        row("other angles", {low, fileOf("b", other).text}, MapFileFault::OtherSettings, "angle_deg", 2);
        other = part(s, 3, 3);
        other.across.to = 0.2;
        row("other offsets", {low, fileOf("b", other).text}, MapFileFault::OtherSettings, "offset_m", 4);
        row("fewer offsets", {low, fileOf("b", part(defaultMap(MapScene::Rack, 2, 6), 3, 3)).text},
            MapFileFault::RowUnfinished, "", 4);
        row("other count of rows", {low, fileOf("b", part(defaultMap(MapScene::Rack, 3, 7), 3, 3)).text},
            MapFileFault::OtherSettings, "rows", 2);
        row("overlap", {low, high, fileOf("c", part(s, 2, 1)).text}, MapFileFault::RowTwice, "", 3);
        row("the same twice", {low, low}, MapFileFault::RowTwice, "", 1);
        row("rows missing", {low, fileOf("b", part(s, 5, 1)).text}, MapFileFault::RowsMissing, "", 4);
        row("last rows missing", {low}, MapFileFault::RowsMissing, "", 4);
        row("cut off", {low, high.left(high.lastIndexOf('\n', -2) + 1)}, MapFileFault::RowUnfinished, "", 6);
        row("cut off in a line", {low, high.left(high.size() - 20)}, MapFileFault::FieldCount, "", 10);
        row("empty file", {QByteArray()}, MapFileFault::NotAMap);
        row("header alone", {low.left(low.indexOf('\n') + 1)}, MapFileFault::Empty);
        row("another file", {"time,pins\n1,2\n"}, MapFileFault::NotAMap);
        row("no number", {changed(low, "-0.16", "left"), high}, MapFileFault::NotANumber, "offset_m", 2);
        row("strike without ten", {changed(low, ",8,0,", ",8,1,"), high}, MapFileFault::WrongValue, "strike");
    }
    void partsThatDoNotFit() {
        QFETCH(QList<QByteArray>, texts);
        QFETCH(int, fault);
        QFETCH(QString, column);
        QFETCH(int, place);
        std::vector<MapFile> files;
        for (const QByteArray& text : texts)
            files.push_back({"part-" + std::to_string(files.size() + 1) + ".csv", text});
        const auto merged = mergeMaps(files);
        const MapFileError* error = errorOf(merged);
        QVERIFY(error);
        QCOMPARE(int(error->fault), fault);
        QCOMPARE(QString::fromStdString(error->column), column);
        if (place > 0)
            QVERIFY2(error->line == place || error->row == place,
                     qPrintable(QString("%1 %2").arg(error->line).arg(error->row)));
    }

    // Not measured on a machine that does other things: only that a first picture does not wait for the
    // whole.
    void firstPictureComesSoon() {
        using Clock = std::chrono::steady_clock;
        const auto begin = Clock::now();
        double first = -1;
        std::stop_source source;
        MapWatch watch;
        watch.refined = [&](const StrikeMap& map) {
            first = std::chrono::duration<double>(Clock::now() - begin).count();
            QCOMPARE(map.stride, 16);
            source.request_stop();
        };
        computeStrikeMap(defaultMap(MapScene::Bowling), 2, watch, source.get_token());
        QVERIFY2(first > 0 && first < 1, qPrintable(QString::number(first)));
    }
};

QTEST_GUILESS_MAIN(TestStrikeMap)
#include "test_strike_map.moc"
