// The strike map as a user meets it: pointed at, thrown from, cancelled, saved; every place is the throw it
// says.
#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"
#include "core/format/map_csv.h"
#include "panel_bench.h"
#include "ui/map/map_panel.h"
#include "ui/panels/pin_deck.h"
#include "ui/plot/strike_map_figure.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QProgressBar>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>

#include <cmath>
#include <numbers>

using namespace thetalane;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int patience = 120'000; // on a busy machine [ms]

struct Bench : PanelBench {
    MapPanel panel;

    explicit Bench(int cells = 24)
        : panel(context, nullptr, cells) {}

    MapView& view() { return *panel.findChild<MapView*>("mapView"); }
    PinDeck& deck() { return *panel.findChild<PinDeck*>("mapDeck"); }
    QString text(const char* name) { return panel.findChild<QLabel*>(name)->text(); }

    void open() {
        showPanel(panel, {400, 900});
        finish();
    }
    void finish() {
        QVERIFY(QTest::qWaitFor([&] { return panel.map() && !panel.running(); }, patience));
        QCoreApplication::processEvents();
    }
    // As a user does: the list is opened, gone through by keys, and closed.
    void choose(const char* name, int data) {
        auto* box = panel.findChild<QComboBox*>(name);
        QVERIFY2(box && box->isEnabled(), name);
        const int wanted = box->findData(data);
        QVERIFY2(wanted >= 0, name);
        box->setFocus();
        while (box->currentIndex() != wanted)
            QTest::keyClick(box, box->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
        QCoreApplication::processEvents();
    }
    void pointAt(MapView::Place place) { QTest::mouseMove(&view(), view().pointOf(place).toPoint()); }
};

PinSet leftBy(const Scene& scene) {
    const Run run = std::get<Run>(simulate(scene, {}));
    PinSet left = allPins;
    for (const int body : pinsDown(run.scene, run.timeline, run.timeline.endTime()))
        left.reset(std::size_t(std::stoi(run.scene.bodies[std::size_t(body)].id) - 1));
    return left;
}

} // namespace

class TestMapPanel : public QObject {
    Q_OBJECT

private slots:
    void scenes_data() {
        QTest::addColumn<int>("scene");
        QTest::newRow("rack") << int(MapScene::Rack);
        QTest::newRow("bowling") << int(MapScene::Bowling);
    }

    // A place pointed at shows what the throw of its scene leaves standing.
    void placesAreTheThrowsTheySay_data() { scenes_data(); }
    void placesAreTheThrowsTheySay() {
        QFETCH(int, scene);
        Bench b;
        b.open();
        b.choose("mapScene", scene);
        b.finish();
        QCOMPARE(int(b.panel.map()->settings.scene), scene);
        QVERIFY(b.panel.map()->whole());
        for (const MapView::Place place :
             {MapView::Place{3, 4}, {17, 20}, {11, 12}, {22, 2}, {0, 23}, {23, 0}}) {
            b.pointAt(place);
            QCOMPARE(b.view().pointed(), std::optional(place));
            const auto cellScene = mapScene(b.panel.map()->settings, place.column, place.row);
            if (!cellScene) {
                QVERIFY(!b.deck().isVisible());
                continue;
            }
            const PinSet left = leftBy(*cellScene);
            QCOMPARE(b.deck().standing(), left);
            const QString said = b.text("mapPointed");
            QVERIFY2(left.none() ? said.contains("strike")
                                 : said.contains(QString::number(10 - left.count())),
                     qPrintable(said));
            QVERIFY(left.none() || said.contains(pinsText(left)));
            QCOMPARE(b.view().accessibleDescription(), said);
        }
    }

    // The colour on the screen is that of the cell.
    void theColoursAreTheCells() {
        Bench b;
        b.open();
        QCoreApplication::processEvents();
        const QImage image = b.view().grab().toImage();
        const StrikeMap& map = *b.panel.map();
        int compared = 0;
        for (int row = 0; row < map.rows(); row += 3)
            for (int column = 0; column < map.columns(); column += 3) {
                const MapCell& cell = map.at(column, row);
                // Beside the middle, where stripes, marks and circles may be.
                const QPoint at = b.view().pointOf(MapView::Place{column, row}).toPoint() + QPoint(3, 3);
                if (!cell.known() || cell.strike())
                    continue;
                const QColor seen = image.pixelColor(at);
                compared += seen == pinsDownColour(cell.pinsDown());
            }
        QVERIFY2(compared > 30, qPrintable(QString::number(compared)));
    }

    void aClickThrowsThatBall_data() { scenes_data(); }
    void aClickThrowsThatBall() {
        QFETCH(int, scene);
        Bench b;
        b.open();
        b.choose("mapScene", scene);
        b.finish();
        QSignalSpy thrown(&b.panel, &MapPanel::thrown);
        const MapView::Place place{18, 20};
        QTest::mouseClick(&b.view(), Qt::LeftButton, {}, b.view().pointOf(place).toPoint());
        QCOMPARE(thrown.count(), 1);
        const auto expected = mapScene(b.panel.map()->settings, place.column, place.row);
        QVERIFY(expected);
        QCOMPARE(b.session.scene().bodies, expected->bodies);
        QCOMPARE(b.session.scene().restitution, expected->restitution);
        QVERIFY(b.playhead.playing());
        QVERIFY(b.playhead.time() < 0.5);
        b.playhead.setPlaying(false);
        if (scene != int(MapScene::Bowling))
            return;
        const auto entry = entryOf(*b.session.currentThrow(), b.session.scene().friction);
        QVERIFY(std::abs(entry->offset - b.panel.map()->settings.across.at(place.column)) < 1e-9);
        QVERIFY(std::abs(entry->angle - b.panel.map()->settings.up.at(place.row)) < 1e-9);
        // The mark of the present throw lies where it was thrown from.
        const QImage image = b.view().grab().toImage();
        QVERIFY(!image.isNull());
    }

    void keysPointAndThrow() {
        Bench b;
        b.open();
        b.view().setFocus();
        QTest::keyClick(&b.view(), Qt::Key_Right);
        QCOMPARE(b.view().pointed(), std::optional(MapView::Place{12, 12}));
        QTest::keyClick(&b.view(), Qt::Key_Right);
        QTest::keyClick(&b.view(), Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(b.view().pointed(), std::optional(MapView::Place{13, 22}));
        for (int k = 0; k < 5; ++k)
            QTest::keyClick(&b.view(), Qt::Key_Up);
        QCOMPARE(b.view().pointed(), std::optional(MapView::Place{13, 23}));
        QTest::keyClick(&b.view(), Qt::Key_Return);
        const auto expected = mapThrow(b.panel.map()->settings, 13, 23);
        QCOMPARE(b.session.currentThrow(), expected);
        b.playhead.setPlaying(false);
    }

    // Deliveries stand at the pixels of their numbers: of the widths, by hand.
    void deliveriesAreDots() {
        Bench b;
        b.open();
        const std::vector<Entry> entries{{0.0, 0, 8}, {0.08, 4 * degree, 8}, {-0.12, -6 * degree, 8}};
        const QImage before = b.view().grab().toImage();
        b.panel.setDots(entries);
        const QImage after = b.view().grab().toImage();
        const QRectF cells = b.view().cells();
        for (const Entry& entry : entries) {
            // 24 cells from -16 to 16 cm: the first centred on -16, the last on 16.
            const double column = (entry.offset + 0.16) / 0.32 * 23 + 0.5;
            const double row = (entry.angle / degree + 8) / 16 * 23 + 0.5;
            const QPoint at(int(std::lround(cells.left() + column / 24 * cells.width())),
                            int(std::lround(cells.bottom() - row / 24 * cells.height())));
            QCOMPARE(after.pixelColor(at), b.appearance.ink(Ink::Second));
            QVERIFY(before.pixelColor(at) != after.pixelColor(at));
        }
        b.panel.setDots({});
        QCOMPARE(b.view().grab().toImage(), before);
    }

    void thePresentThrowIsMarked() {
        Bench b;
        const auto t =
            throwArriving({.speed = 8, .position = 0, .spin = 42}, 0.05, 3 * degree, houseFriction());
        QVERIFY(t);
        b.session.setDelivery(*t, allPins, {});
        b.open();
        const QPointF at = b.view().pointOf(MapView::Values{0.05, 3 * degree});
        const QImage with = b.view().grab().toImage();
        b.session.openBuiltin("two-balls");
        QCoreApplication::processEvents();
        const QImage without = b.view().grab().toImage();
        const QPoint arm = (at + QPointF(8, 0)).toPoint();
        QVERIFY(with.pixelColor(arm) != without.pixelColor(arm));
        const QPoint far = (at + QPointF(60, 40)).toPoint();
        QCOMPARE(with.pixelColor(far), without.pixelColor(far));
    }

    // Whatever is asked for, one quantity is never on both axes, and the rack knows no spin.
    void otherQuantities() {
        Bench b(8);
        b.open();
        b.choose("mapAcross", int(MapQuantity::Speed));
        b.finish();
        b.choose("mapUp", int(MapQuantity::Speed));
        b.finish();
        QCOMPARE(int(b.panel.map()->settings.up.quantity), int(MapQuantity::Speed));
        QVERIFY(b.panel.map()->settings.across.quantity != MapQuantity::Speed);
        b.choose("mapAcross", int(MapQuantity::Spin));
        b.finish();
        QCOMPARE(int(b.panel.map()->settings.across.quantity), int(MapQuantity::Spin));
        const auto row = mapThrow(b.panel.map()->settings, 7, 3);
        QVERIFY(row && row->spin > 60);
        QVERIFY(!b.panel.findChild<QAbstractButton*>("mapCsv")->isEnabled());
        b.choose("mapScene", int(MapScene::Rack));
        b.finish();
        QVERIFY(b.panel.map()->settings.across.quantity != MapQuantity::Spin);
        QVERIFY(b.panel.findChild<QComboBox*>("mapAcross")->findData(int(MapQuantity::Spin)) < 0);
    }

    void restitutionIsAsked() {
        Bench b(8);
        b.open();
        type(b.panel, "mapRestitution", "0.4");
        b.finish();
        QCOMPARE(b.panel.map()->settings.restitution, 0.4);
        type(b.panel, "mapRestitution", "1.4");
        QVERIFY(message(b.panel, "mapMessage").contains("1.4"));
        QVERIFY(!b.panel.running());
        QCOMPARE(b.panel.map()->settings.restitution, 0.4);
    }

    // Coarse first, then finer; cancelled, what there is stays and it says so. The window goes on meanwhile.
    void cancelKeepsWhatThereIs() {
        Bench b(700);
        int beats = 0;
        QTimer beat;
        connect(&beat, &QTimer::timeout, &beat, [&] { ++beats; });
        showPanel(b.panel, {400, 900});
        QVERIFY(b.panel.running());
        QVERIFY(QTest::qWaitFor([&] { return b.panel.map() && b.panel.map()->stride <= 16; }, patience));
        beat.start(1);
        QTest::qWait(400);
        beat.stop();
        QVERIFY2(beats > 4, qPrintable(QString::number(beats))); // it answers
        QVERIFY(b.panel.running());
        QVERIFY(b.panel.findChild<QProgressBar*>("mapProgress")->isVisible());
        click(b.panel, "mapStop");
        b.finish();
        QVERIFY(!b.panel.map()->whole());
        QVERIFY2(b.text("mapState").contains("Cancelled"), qPrintable(b.text("mapState")));
        QVERIFY(b.text("mapState").contains(QString::number(b.panel.map()->stride)));
        // A place of the coarse map is a throw that was thrown.
        const int stride = b.panel.map()->stride;
        b.pointAt({350, 500});
        const auto at = b.view().pointed();
        QVERIFY(at && at->column % stride == 0 && at->row % stride == 0);
        const auto scene = mapScene(b.panel.map()->settings, at->column, at->row);
        if (scene)
            QCOMPARE(b.deck().standing(), leftBy(*scene));
        QVERIFY(!b.panel.findChild<QAbstractButton*>("mapPicture")->isEnabled());
    }

    void saved() {
        Bench b;
        b.open();
        QTemporaryDir dir;
        const QString csv = dir.filePath("map.csv"), png = dir.filePath("map.png");
        QVERIFY(b.panel.saveCsv(csv));
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), mapCsv(*b.panel.map()));
        QVERIFY(b.panel.savePicture(png));
        QVERIFY(b.text("mapSaved").contains("map.png"));
        const QImage image(png);
        QCOMPARE(image.size(), QSize(1380, 1020));
        QVERIFY(!b.panel.saveCsv(dir.filePath("none/map.csv")));
        QVERIFY(b.text("mapSaved").contains("cannot be written"));
        // What was saved is a map that the command line takes back.
        const std::vector<MapFile> parts{{"map.csv", mapCsv(*b.panel.map())}};
        const auto merged = mergeMaps(parts);
        QVERIFY(std::holds_alternative<StrikeMap>(merged));
        QVERIFY(std::get<StrikeMap>(merged).cells == b.panel.map()->cells);
    }

    // The ball of the present throw is followed, the way it is aimed is not: that is what the axes are.
    void theBallOfThisThrow() {
        Bench b(8);
        b.session.setDelivery({.mass = 5, .speed = 9, .position = 0.1, .spin = 40}, allPins, {});
        b.open();
        b.choose("mapBall", 1);
        b.finish();
        QCOMPARE(b.panel.map()->settings.base.mass, 5.0);
        QCOMPARE(b.panel.map()->settings.base.position, 0.1);
        b.session.setDelivery({.mass = 5, .speed = 9, .direction = 0.01, .position = 0.1, .spin = 40},
                              allPins, {});
        b.session.setDelivery({.mass = 6, .speed = 9, .direction = 0.01, .position = 0.1, .spin = 40},
                              allPins, {});
        QVERIFY(QTest::qWaitFor([&] { return b.panel.map()->settings.base.mass == 6; }, patience));
        b.finish();
        const auto now = b.panel.map();
        b.session.setDelivery(
            {.mass = 6, .speed = 9, .direction = 0.02, .position = 0.1, .spin = 40, .axis = 0.3}, allPins,
            {});
        QTest::qWait(400); // longer than the panel waits for a throw to settle
        QCOMPARE(b.panel.map(), now);
    }

    void words_data() { addLanguages(); }
    void words() {
        QFETCH(bool, korean);
        Bench b(8);
        Language language;
        b.open();
        useLanguage(language, korean);
        QVERIFY(b.text("mapNote").contains(korean ? "원판" : "discs"));
        QCOMPARE(b.panel.findChild<QComboBox*>("mapScene")->currentText(),
                 korean ? "레인 전체" : "Whole lane");
        QCOMPARE(b.panel.findChild<QComboBox*>("mapUp")->currentText(), korean ? "입사각" : "Entry angle");
        QCOMPARE(b.view().accessibleName(), korean ? "스트라이크 지도" : "Strike map");
        for (const char* name : {"mapStop", "mapCsv", "mapPicture"})
            QVERIFY(!b.panel.findChild<QAbstractButton*>(name)->toolTip().isEmpty());
        language.use(Language::Code::English);
    }
};

QTEST_MAIN(TestMapPanel)
#include "test_map_panel.moc"
