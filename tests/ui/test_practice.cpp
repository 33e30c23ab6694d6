// Practice as a user meets it: pins picked by mouse and keys, tries counted, one attribute varied.
#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"
#include "panel_bench.h"
#include "ui/panels/pin_deck.h"
#include "ui/practice/leaves.h"
#include "ui/practice/practice_panel.h"
#include "ui/practice/spare_box.h"
#include "ui/practice/vary_box.h"

#include <QComboBox>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableView>

#include <cmath>
#include <numbers>

using namespace thetalane;

namespace {

constexpr int patience = 60'000; // on a busy machine [ms]

PinSet pins(std::initializer_list<int> numbers) {
    PinSet set;
    for (const int n : numbers)
        set.set(std::size_t(n - 1));
    return set;
}

struct Bench : PanelBench {
    PracticePanel panel{context};

    PinDeck& deck() { return *panel.findChild<PinDeck*>("spareDeck"); }
    QTableView& table() { return *panel.findChild<QTableView*>("varyTable"); }
    QString text(const char* name) { return panel.findChild<QLabel*>(name)->text(); }
    void open(QSize size = {400, 1400}) { showPanel(panel, size); }
    void clickPin(int number) {
        QTest::mouseClick(&deck(), Qt::LeftButton, {},
                          deckPinCentre(QRectF(deck().rect()).adjusted(4, 4, -4, -4), number - 1).toPoint());
    }
    void settle() {
        QVERIFY(QTest::qWaitFor([&] { return !panel.varied().running(); }, patience));
        QCoreApplication::processEvents();
    }
    void seek(QWidget* w) { panel.findChild<QScrollArea*>()->ensureWidgetVisible(w); }
    void playToTheEnd() {
        for (int k = 0; k < 100'000 && playhead.playing(); ++k)
            playhead.advance(0.1);
    }
};

} // namespace

class TestPractice : public QObject {
    Q_OBJECT

private slots:
    void pinsArePickedByMouse() {
        Bench b;
        b.session.openBuiltin("bowling");
        b.open();
        QCOMPARE(b.deck().standing(), allPins);
        for (const int number : {1, 2, 3, 4, 5, 6, 8, 9})
            b.clickPin(number);
        QCOMPARE(b.deck().standing(), pins({7, 10}));
        QCOMPARE(b.session.standing(), pins({7, 10}));
        QCOMPARE(b.session.scene().bodies.size(), std::size_t(3));
        b.clickPin(5);
        QCOMPARE(b.session.standing(), pins({5, 7, 10}));
        QTest::mouseClick(&b.deck(), Qt::LeftButton, {}, {2, b.deck().height() - 3}); // beside all pins
        QCOMPARE(b.session.standing(), pins({5, 7, 10}));
    }

    void pinsArePickedByKeys() {
        Bench b;
        b.session.openBuiltin("bowling");
        b.open();
        b.deck().setFocus();
        for (const Qt::Key key : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_0})
            QTest::keyClick(&b.deck(), key);
        QCOMPARE(b.session.standing(), pins({4, 5, 6, 7, 8, 9}));
        // From pin 10 in the back row to the left, then down to the row before.
        QCOMPARE(b.deck().current(), 9);
        QTest::keyClick(&b.deck(), Qt::Key_Left);
        QCOMPARE(b.deck().current(), 8);
        QTest::keyClick(&b.deck(), Qt::Key_Right);
        QTest::keyClick(&b.deck(), Qt::Key_Right); // nothing further
        QCOMPARE(b.deck().current(), 9);
        QTest::keyClick(&b.deck(), Qt::Key_Down);
        QCOMPARE(b.deck().current(), 5);
        QTest::keyClick(&b.deck(), Qt::Key_Space);
        QCOMPARE(b.session.standing(), pins({4, 5, 7, 8, 9}));
        QTest::keyClick(&b.deck(), Qt::Key_Down);
        QTest::keyClick(&b.deck(), Qt::Key_Down);
        QCOMPARE(b.deck().current(), 0);
        QTest::keyClick(&b.deck(), Qt::Key_Up);
        QVERIFY(b.deck().current() == 1 || b.deck().current() == 2);
    }

    // Every classic leave has a button that sets just these pins up, with the throw as it was.
    void leaves() {
        Bench b;
        Throw t;
        t.speed = 7.5;
        b.session.setDelivery(t, allPins, {});
        b.open();
        const std::pair<const char*, PinSet> expected[] = {
            {"leaf10", pins({10})},
            {"leaf7", pins({7})},
            {"leaf7-10", pins({7, 10})},
            {"leaf3-10", pins({3, 10})},
            {"leaf6-7-10", pins({6, 7, 10})},
            {"leaf4-6-7-10", pins({4, 6, 7, 10})},
            {"leaf5-7", pins({5, 7})},
            {"leaf2-4-5-8", pins({2, 4, 5, 8})},
            {"leaf3-5-6-9", pins({3, 5, 6, 9})},
            {"leaf1-2-4-10", pins({1, 2, 4, 10})},
            {"leaf6-10", pins({6, 10})},
            {"leaf4-7", pins({4, 7})},
        };
        for (const auto& [name, standing] : expected) {
            click(b.panel, name);
            QCOMPARE(b.session.standing(), standing);
            QCOMPARE(b.deck().standing(), standing);
            QCOMPARE(b.session.currentThrow(), std::optional(t));
            QVERIFY(b.panel.findChild<LeafButton*>(name)->isChecked());
            QCOMPARE(b.session.scene().bodies.size(), standing.count() + 1);
        }
    }

    // A try counts when it has come to its end, made or missed as a run of its own says.
    void triesAreCounted() {
        Bench b;
        Throw straight;
        straight.position = 0;
        straight.direction = std::atan(0.4572 / (18.288 + 0.7919)); // straight at pin 10
        b.session.setDelivery(straight, allPins, {});
        b.open();
        click(b.panel, "leaf10");
        click(b.panel, "spareThrow");
        QVERIFY(b.playhead.playing());
        QCOMPARE(b.panel.spares().countOf(pins({10})).tries, 0); // on its way
        b.playToTheEnd();
        QCOMPARE(b.panel.spares().countOf(pins({10})).tries, 1);
        QCOMPARE(b.panel.spares().countOf(pins({10})).made, 1);
        QCOMPARE(b.text("spareResult"), QString("Made!"));
        click(b.panel, "leaf7");
        click(b.panel, "spareThrow"); // the same throw passes it by
        b.playToTheEnd();
        QCOMPARE(b.panel.spares().countOf(pins({7})).tries, 1);
        QCOMPARE(b.panel.spares().countOf(pins({7})).made, 0);
        QVERIFY(b.text("spareResult").contains("7"));
        click(b.panel, "leaf10");
        QVERIFY(b.text("spareCount").contains("1 of 1"));
        QVERIFY(b.text("spareCount").contains("1 of 2"));
        click(b.panel, "spareThrow");
        click(b.panel, "spareThrow"); // again before it came to its end: it counts all the same
        QCOMPARE(b.panel.spares().countOf(pins({10})).tries, 2);
    }

    // The window may show a throw up to its first contact alone; a try is the whole of it.
    void triesAreWhole() {
        Bench b;
        Throw straight;
        straight.position = 0;
        straight.direction = 0;
        b.session.setForesight(Foresight::FirstContact);
        b.session.setDelivery(straight, pins({1}), {});
        b.open();
        click(b.panel, "spareThrow");
        b.playToTheEnd();
        QCOMPARE(b.panel.spares().countOf(pins({1})).made, 1);
    }

    // The advised line makes the spare, by a run of its own; straight or with a hook.
    void aLineThatMakesIt_data() {
        QTest::addColumn<double>("spin");
        QTest::newRow("straight") << 0.0;
        QTest::newRow("hook") << 42.0;
    }
    void aLineThatMakesIt() {
        QFETCH(double, spin);
        Bench b;
        b.session.setDelivery({.speed = 8, .position = 0, .spin = spin, .axis = 0.5}, allPins, {});
        b.open();
        click(b.panel, "leaf3-10");
        click(b.panel, "spareAdvice");
        QVERIFY(QTest::qWaitFor([&] { return !b.panel.spares().searching(); }, patience));
        QCOMPARE(b.session.standing(), pins({3, 10}));
        const Run run = std::get<Run>(simulate(
            bowlingScene(*b.session.currentThrow(), defaultPinRestitution, houseFriction(), pins({3, 10})),
            {}));
        QCOMPARE(fallenPins(run.scene, run.timeline), pins({3, 10}));
        QVERIFY(b.text("spareLine").contains("°"));
        b.session.setDelivery({.mass = 6.8, .speed = 7}, pins({3, 10}), {}); // it was about another
        QVERIFY(b.text("spareLine").isEmpty());
    }

    // Each row is the run of that throw; the present value is among them and marked.
    void whatChangesIf_data() {
        QTest::addColumn<int>("quantity");
        for (int q = 0; q < throwQuantities; ++q)
            QTest::newRow(qPrintable(QString::number(q))) << q;
    }
    void whatChangesIf() {
        QFETCH(int, quantity);
        Bench b;
        const Throw t{6.8, 8, 0.012, -0.2, 31.5, 0.4};
        b.session.setDelivery(t, allPins, {});
        b.open();
        auto* box = b.panel.findChild<QComboBox*>("varyQuantity");
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int k = 0; k < quantity; ++k)
            QTest::keyClick(box, Qt::Key_Down);
        QCOMPARE(box->currentIndex(), quantity);
        b.settle();
        const auto& model = *b.table().model();
        QVERIFY(model.rowCount() >= 13);
        int present = 0;
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex at = model.index(row, 0);
            const double shown = at.data().toString().replace(QChar(0x2212), u'-').toDouble();
            Throw varied = t;
            constexpr double degree = std::numbers::pi / 180;
            switch (quantity) {
            case 0:
                varied.mass = shown;
                break;
            case 1:
                varied.speed = shown;
                break;
            case 2:
                varied.direction = shown * degree;
                break;
            case 3:
                varied.position = shown / 100;
                break;
            case 4:
                varied.spin = shown * 2 * std::numbers::pi / 60;
                break;
            default:
                varied.axis = shown * degree;
            }
            const bool marked = at.data(Qt::UserRole + 3).toBool();
            present += marked;
            if (marked)
                varied = t;                             // four digits are shown of it
            const bool exact = marked || quantity != 2; // directions are shown rounded
            if (!exact)
                continue;
            const Run run =
                std::get<Run>(simulate(bowlingScene(varied, defaultPinRestitution, houseFriction()), {}));
            const PinSet left = ~fallenPins(run.scene, run.timeline);
            if (varied == t || std::abs(shown * 4 - std::round(shown * 4)) < 1e-9)
                QCOMPARE(PinSet(at.data(Qt::UserRole + 1).toUInt()), left);
        }
        QCOMPARE(present, 1);
    }

    // A click on a row makes it the throw, at the same pins; the row is then the present one.
    void aRowBecomesTheThrow() {
        Bench b;
        b.session.setDelivery(Throw{}, pins({1, 3, 5}), {});
        b.open();
        b.settle();
        auto& model = *b.table().model();
        const auto presentRow = [&] {
            for (int row = 0; row < model.rowCount(); ++row)
                if (model.index(row, 0).data(Qt::UserRole + 3).toBool())
                    return row;
            return -1;
        };
        const int before = presentRow();
        QVERIFY(before >= 0);
        const int wanted = before == 2 ? 3 : 2;
        const double speed = model.index(wanted, 0).data().toString().toDouble();
        b.seek(&b.table());
        QTest::mouseClick(b.table().viewport(), Qt::LeftButton, {},
                          b.table().visualRect(model.index(wanted, 3)).center());
        QCOMPARE(b.session.currentThrow()->speed, speed);
        QCOMPARE(b.session.standing(), pins({1, 3, 5}));
        QVERIFY(
            QTest::qWaitFor([&] { return !b.panel.varied().running() && presentRow() == wanted; }, patience));
        b.table().setFocus();
        QTest::keyClick(&b.table(), Qt::Key_Down);
        QTest::keyClick(&b.table(), Qt::Key_Return);
        QVERIFY(b.session.currentThrow()->speed > speed);
    }

    void rangesAreTyped() {
        Bench b;
        b.session.openBuiltin("bowling");
        b.open();
        b.settle();
        type(b.panel, "varyFrom", "7");
        type(b.panel, "varyTo", "9");
        b.settle();
        const auto& model = *b.table().model();
        QCOMPARE(model.index(0, 0).data().toString(), QString("7"));
        QCOMPARE(model.index(model.rowCount() - 1, 0).data().toString(), QString("9"));
        type(b.panel, "varyFrom", "9.5");
        QVERIFY(!message(b.panel, "varyMessage").isEmpty());
        type(b.panel, "varyFrom", "-1"); // a throw that cannot be
        b.settle();
        QVERIFY(message(b.panel, "varyMessage").isEmpty());
        QCOMPARE(model.index(0, 2).data().toString(), QString("—"));
    }

    // The table keeps up with the lane, and a lane that is shaken does not hold the window up.
    void itFollowsTheSession() {
        Bench b;
        b.session.openBuiltin("bowling");
        b.open();
        b.settle();
        Throw t;
        for (int k = 0; k < 40; ++k) {
            t.position = -0.3 + 0.01 * k;
            b.session.setDelivery(t, allPins, {});
        }
        QVERIFY(QTest::qWaitFor(
            [&] {
                const Run run = std::get<Run>(simulate(b.session.scene(), {}));
                const auto& model = *b.table().model();
                for (int row = 0; row < model.rowCount(); ++row)
                    if (model.index(row, 0).data(Qt::UserRole + 3).toBool())
                        return PinSet(model.index(row, 0).data(Qt::UserRole + 1).toUInt()) ==
                               ~fallenPins(run.scene, run.timeline);
                return false;
            },
            patience));
    }

    void words_data() { addLanguages(); }
    void words() {
        QFETCH(bool, korean);
        Bench b;
        Language language;
        b.session.openBuiltin("bowling");
        b.open();
        useLanguage(language, korean);
        b.settle();
        QCOMPARE(b.text("spareTitle"), korean ? "스페어 연습" : "Spare practice");
        QCOMPARE(b.panel.findChild<LeafButton*>("leaf3-10")->toolTip(),
                 korean ? "베이비 스플릿 3-10" : "Baby split 3-10");
        QVERIFY(!b.deck().accessibleDescription().isEmpty());
        QVERIFY(!b.text("varySentence").contains("%"));
        language.use(Language::Code::English);
    }
};

QTEST_MAIN(TestPractice)
#include "test_practice.moc"
