// Who hit whom as a user meets it: the drawn tree against a slow walk through the collisions, by mouse and
// keys.
#include "core/bowling/pinfall.h"
#include "core/study/strike_map.h"
#include "panel_bench.h"
#include "ui/panels/pin_deck.h"
#include "ui/who/collision_tree_panel.h"
#include "ui/who/hit_tree_view.h"
#include "ui/words/worked_steps.h"

#include <QListWidget>
#include <QScrollArea>
#include <QSignalSpy>

#include <numbers>

using namespace thetalane;

namespace {

constexpr double degree = std::numbers::pi / 180;

struct Bench : PanelBench {
    CollisionTreePanel panel{context};
    HitTreeView& tree() { return *panel.findChild<HitTreeView*>("hitTree"); }
    QListWidget& later() { return *panel.findChild<QListWidget*>("laterHits"); }
    QString text(const char* name) {
        return panel.findChild<QLabel*>(name)->text().replace(QChar(0x00A0), u' ');
    }
    bool shows(const char* name) { return panel.findChild<QWidget*>(name)->isVisible(); }
    void open(QSize size = {344, 720}) {
        playhead.setPlaying(false);
        showPanel(panel, size);
    }
    void clickArrow(std::size_t node) {
        panel.findChild<QScrollArea*>("treeScroll")
            ->ensureVisible(int(tree().arrowMiddle(node).x()), int(tree().arrowMiddle(node).y()));
        QTest::mouseClick(&tree(), Qt::LeftButton, {}, tree().arrowMiddle(node).toPoint());
    }
    Throw pocket() { // a right-hander's, 6.8 cm at 5°
        return *throwArriving({.speed = 8, .position = 0, .spin = 42}, 0.068, 5.5 * degree, houseFriction());
    }
};

std::size_t nodeOf(const HitTreeView& tree, int body) {
    const auto& nodes = tree.layoutOfTree().nodes;
    for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k].body == body)
            return k;
    qFatal("body %d is not drawn", body);
}

} // namespace

class TestWho : public QObject {
    Q_OBJECT

private slots:
    // Every pin hangs on the body that its first contact in the run was with, and a click opens that contact.
    void theTreeIsTheRuns() {
        Bench b;
        QVERIFY(b.session.setDelivery(b.pocket(), allPins, {}).empty());
        b.open({560, 720});
        const auto all = b.session.timeline().collisions();
        const auto& nodes = b.tree().layoutOfTree().nodes;
        int pins = 0;
        for (int body = 1; body <= 10; ++body) {
            std::size_t first = 0;
            while (first < all.size() && (all[first].isWall() || !all[first].involves(body)))
                ++first;
            if (first == all.size())
                continue;
            ++pins;
            const int by = all[first].first == body ? all[first].second : all[first].first;
            const std::size_t node = nodeOf(b.tree(), body);
            QCOMPARE(nodes[std::size_t(nodes[node].parent)].body, by);
            b.clickArrow(node);
            QCOMPARE(b.playhead.selected(), std::optional(first));
            QCOMPARE(b.playhead.time(), all[first].time);
            QVERIFY(b.tree().accessibleDescription().contains(QString::number(all[first].time, 'f', 4)));
        }
        QVERIFY(pins >= 9);
        QCOMPARE(nodes.size(), std::size_t(pins + 1));
    }

    // No two discs or labels stand in the same place, and the first hits of each run along one line.
    void nothingIsDrawnOverAnother() {
        Bench b;
        b.session.setDelivery(b.pocket(), allPins, {});
        b.open();
        for (const bool projector : {false, true}) {
            b.appearance.setProjector(projector);
            QCoreApplication::processEvents();
            const auto& nodes = b.tree().layoutOfTree().nodes;
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                QVERIFY(b.tree().rect().contains(b.tree().nodeRect(k).toAlignedRect()));
                for (std::size_t m = 0; m < k; ++m)
                    QVERIFY(!b.tree().nodeRect(k).intersects(b.tree().nodeRect(m)));
                if (nodes[k].parent >= 0)
                    QVERIFY(b.tree().nodeRect(k).left() >
                            b.tree().nodeRect(std::size_t(nodes[k].parent)).right() + 20);
            }
        }
    }

    void thePerfectStrikeIsSaid_data() { addLanguages(); }
    void thePerfectStrikeIsSaid() {
        QFETCH(bool, korean);
        Bench b;
        Language language;
        useLanguage(language, korean);
        b.session.open(rackScene(0.0676, -6 * degree, 6.8));
        b.open();
        QVERIFY(b.shows("chainText"));
        QVERIFY(b.text("chainText").contains("1 → 2 → 4 → 7"));
        QVERIFY(b.text("chainText").contains(korean ? "퍼펙트" : "Perfect strike"));
        QVERIFY(b.text("leftText").contains(korean ? "남은 핀이 없습니다" : "No pin"));
        b.session.open(rackScene(-0.0676, 6 * degree, 6.8));
        QVERIFY(b.text("chainText").contains("1 → 3 → 6 → 10"));
        b.session.open(rackScene(0.01, 0, 6.8));
        QVERIFY(!b.text("chainText").contains("1 → 2"));
        b.session.openBuiltin("two-balls");
        QVERIFY(!b.shows("chainText"));
        QVERIFY(!b.shows("standingDeck"));
        language.use(Language::Code::English);
    }

    void greyUntilItHappens() {
        Bench b;
        b.session.open(rackScene(0.0676, -6 * degree, 6.8));
        b.playhead.setTime(0);
        b.open();
        const auto& nodes = b.tree().layoutOfTree().nodes;
        const auto before = b.tree().grab().toImage();
        const auto all = b.session.timeline().collisions();
        for (const double t : {0.0, all[0].time, all[3].time, all.back().time}) {
            b.playhead.setTime(t);
            for (std::size_t k = 1; k < nodes.size(); ++k) {
                const Collision* first = nullptr;
                for (const Collision& c : all)
                    if (!first && c.involves(nodes[k].body))
                        first = &c;
                QCOMPARE(b.tree().happened(k), first->time <= t);
            }
        }
        QVERIFY(b.tree().grab().toImage() != before);
    }

    // Along the chain with the right arrow, back with the left, to the ball's other hits with up and down.
    void keysGoAlongTheArrows() {
        Bench b;
        b.session.open(rackScene(0.0676, -6 * degree, 6.8));
        b.open();
        b.tree().setFocus();
        const auto at = [&] {
            const Collision& c = b.session.timeline().collisions()[*b.playhead.selected()];
            return std::pair(c.first, c.second);
        };
        QTest::keyClick(&b.tree(), Qt::Key_Right);
        QCOMPARE(at(), std::pair(0, 1));
        for (const auto& hit : {std::pair(1, 2), std::pair(2, 4), std::pair(4, 7)}) {
            QTest::keyClick(&b.tree(), Qt::Key_Right);
            QCOMPARE(at(), hit);
        }
        QTest::keyClick(&b.tree(), Qt::Key_Right); // nothing further
        QCOMPARE(at(), std::pair(4, 7));
        for (int k = 0; k < 3; ++k)
            QTest::keyClick(&b.tree(), Qt::Key_Left);
        QCOMPARE(at(), std::pair(0, 1));
        QTest::keyClick(&b.tree(), Qt::Key_Down);
        QCOMPARE(at(), std::pair(0, 3));
        QTest::keyClick(&b.tree(), Qt::Key_Up);
        QCOMPARE(at(), std::pair(0, 1));
        b.playhead.clearSelection();
        QTest::keyClick(&b.tree(), Qt::Key_Return);
        QCOMPARE(at(), std::pair(0, 1));
    }

    void laterHitsOpenToo() {
        Bench b;
        b.session.open(rackScene(0.0676, -4 * degree, 6.8));
        b.open();
        const HitTree tree = hitTree(b.session.scene(), b.session.timeline());
        QVERIFY(!tree.later.empty());
        QCOMPARE(std::size_t(b.later().count()), tree.later.size());
        for (std::size_t k = 0; k < std::min<std::size_t>(4, tree.later.size()); ++k) {
            b.later().scrollToItem(b.later().item(int(k)));
            QTest::mouseClick(b.later().viewport(), Qt::LeftButton, {},
                              b.later().visualItemRect(b.later().item(int(k))).center());
            QCOMPARE(b.playhead.selected(), std::optional(tree.later[k].collision));
        }
        b.playhead.select(tree.edges[0].collision); // from elsewhere: the list lets go
        QCOMPARE(b.later().currentRow(), -1);
    }

    void whatIsLeftStanding() {
        Bench b;
        const PinSet leave(0b1000000100); // 3-10
        Throw t;
        t.position = 0.4;
        t.direction = 0;
        QVERIFY(b.session.setDelivery(t, leave, {}).empty());
        b.open();
        const Timeline& timeline = b.session.timeline();
        PinSet left = leave;
        for (const int body : pinsDown(b.session.scene(), timeline, timeline.endTime()))
            left.reset(std::size_t(std::stoi(b.session.scene().bodies[std::size_t(body)].id) - 1));
        auto* deck = b.panel.findChild<PinDeck*>("standingDeck");
        QVERIFY(deck->isVisible());
        QCOMPARE(deck->standing(), left);
        t.position = -0.5; // into the gutter: nobody hits anybody
        t.direction = -3 * degree;
        b.session.setDelivery(t, leave, {});
        QCOMPARE(deck->standing(), leave);
        QVERIFY(b.shows("noHits"));
        QVERIFY(!b.shows("treeScroll"));
    }

    // A gas: the first so many hits, and it says so. Nothing is made while nobody looks.
    void longRuns() {
        Bench b;
        b.session.openBuiltin("gas-1000");
        QVERIFY(b.tree().layoutOfTree().nodes.empty());
        b.open();
        QVERIFY(b.tree().layoutOfTree().notDrawn > 0);
        QVERIFY(b.shows("leftOutText"));
        QVERIFY(b.text("leftOutText").contains(QString::number(HitTreeView::mostDrawn)));
        QVERIFY(b.later().count() <= 200);
        const auto& nodes = b.tree().layoutOfTree().nodes;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (nodes[k].edge >= 0) {
                b.clickArrow(k);
                QVERIFY(b.playhead.selectedNumber().has_value());
                break;
            }
    }

    void wordsAreThere_data() { addLanguages(); }
    void wordsAreThere() {
        QFETCH(bool, korean);
        Bench b;
        Language language;
        b.session.openBuiltin("bowling");
        b.open();
        useLanguage(language, korean);
        QCOMPARE(b.tree().accessibleName(), korean ? "누가 누구를 맞혔나" : "Who hit whom");
        for (const char* name : {"hitTree", "laterHits", "standingDeck"})
            QVERIFY2(!b.panel.findChild<QWidget*>(name)->accessibleName().isEmpty(), name);
        QVERIFY(!b.text("treeKey").isEmpty());
        language.use(Language::Code::English);
    }
};

QTEST_MAIN(TestWho)
#include "test_who.moc"
