// A whole game in the whole window, by two players who have keys and a mouse and nothing else.
#include "core/format/game_file.h"
#include "tests/core/slow_scorer.h"
#include "tests/ui/whole_program.h"
#include "ui/game/alley.h"
#include "ui/lane/lane_view.h"
#include "ui/rail/rail_button.h"
#include "ui/rail/rooms.h"

#include <QLineEdit>
#include <QPushButton>

using namespace thetalane;
using namespace thetalane::testing;

namespace {

struct Program : WholeProgram {
    Program()
        : WholeProgram(Language::Code::English) {}
    Alley& alley() { return window.alley(); }
    LaneView& lane() { return *window.findChild<LaneView*>("laneView"); }
    QPushButton& button(const char* name) { return *window.findChild<QPushButton*>(QLatin1String(name)); }
    void click(const char* name) { QTest::mouseClick(&button(name), Qt::LeftButton); }
    const Throw& aim() const { return *session.currentThrow(); }

    // The part that the arrow keys move: the ball, the direction, the speed, the rotation come in turn.
    void press(Qt::Key key, int times) {
        for (int k = 0; k < times; ++k)
            QTest::keyClick(&lane(), key);
    }
    // A millimetre is a unit, y up.
    QPoint pixel(double x, double y) {
        return lane().viewportTransform().map(QPointF(1000 * x, -1000 * y)).toPoint();
    }
    void dragTheBall(int pixels) {
        lane().setFocus();
        QTest::keyClick(&lane(), Qt::Key_B);
        const QPoint from = pixel(aim().position, -18.288);
        QWidget* port = lane().viewport();
        QTest::mousePress(port, Qt::LeftButton, {}, from);
        const QPoint to = from + QPoint(pixels, 0);
        QMouseEvent move(QEvent::MouseMove, to, port->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(port, &move);
        QTest::mouseRelease(port, Qt::LeftButton, {}, to);
    }
};

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::vector<int> rollsOf(const Game& game, std::size_t player) {
    std::vector<int> rolls;
    for (const PlayedDelivery& d : game.deliveries[player])
        rolls.push_back(d.delivery.foul ? slow::foul : d.delivery.pins);
    return rolls;
}

} // namespace

class TestPlay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { keepSettingsIn(m_settings, "ThetaLanePlay"); }

    void twoPlayersPlayAGame() {
        Program p;
        QTest::mouseClick(p.window.findChild<RailButton*>(QString("room%1").arg(int(Room::Game))),
                          Qt::LeftButton);
        QTest::keyClicks(p.window.findChild<QLineEdit*>("playerName1"), "Ada");
        QTest::keyClicks(p.window.findChild<QLineEdit*>("playerName2"), "Ben");
        p.click("startGame");
        QCOMPARE(p.alley().phase(), Alley::Phase::Aim);
        QCOMPARE(p.alley().game().players[1].name, std::string("Ben"));

        int throws = 0, aimsChanged = 0;
        for (; p.alley().phase() != Alley::Phase::Over && throws < 60; ++throws) {
            QCOMPARE(p.alley().phase(), Alley::Phase::Aim);
            const Throw before = p.aim();
            const std::size_t player = p.alley().turn()->player;
            if (player == 0)
                p.dragTheBall(throws % 3 == 0 ? -14 : 9); // by the mouse
            else {
                p.lane().setFocus(); // by the keys: the direction
                p.press(Qt::Key_A, 2);
                p.press(throws % 4 < 2 ? Qt::Key_Right : Qt::Key_Left, 1 + throws % 3);
                p.press(Qt::Key_Escape, 1);
            }
            aimsChanged += !(p.aim() == before);
            const Throw aimed = p.aim();
            QVERIFY(p.session.part().collisionCount <= 1); // nothing is told before
            if (throws % 2)
                p.click("goOn");
            else
                QTest::keyClick(&p.lane(), Qt::Key_Return);
            QCOMPARE(p.alley().phase(), Alley::Phase::Rolling);
            const PlayedDelivery& last = p.alley().game().deliveries[player].back();
            QVERIFY(last.thrown == std::optional(aimed));
            // In the file at once, whole: whoever pulls the plug now loses nothing but the show.
            const auto read = readGame(contents(p.alley().path()));
            QVERIFY(std::holds_alternative<Game>(read) && std::get<Game>(read) == p.alley().game());
            QTest::keyClick(&p.lane(), Qt::Key_Return); // the score, and the next turn
        }
        QCOMPARE(p.alley().phase(), Alley::Phase::Over);
        QVERIFY(aimsChanged > throws / 2);
        for (std::size_t player = 0; player < 2; ++player) {
            const slow::Game expected = slow::score(rollsOf(p.alley().game(), player), false);
            QVERIFY(expected.legal && expected.over);
            QCOMPARE(cardOf(p.alley().game(), player).total(), expected.totals.back());
        }
        QVERIFY(QFile::remove(p.alley().path()));
    }

private:
    QTemporaryDir m_settings;
};

QTEST_MAIN(TestPlay)
#include "test_play.moc"
