// A game as players meet it: real clicks and keys, the score against a scorer of its own, the file against
// the game after every delivery.
#include "core/bowling/pinfall.h"
#include "panel_bench.h"
#include "tests/core/slow_scorer.h"
#include "ui/game/game_panel.h"
#include "ui/game/game_words.h"
#include "ui/game/score_sheet.h"
#include "ui/game/score_table.h"
#include "ui/game/statistics_panel.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QInputMethodEvent>
#include <QListWidget>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QVBoxLayout>

#include <memory>

#ifdef Q_OS_UNIX
#include <csignal>
#include <sys/resource.h>
#endif

using namespace thetalane;

namespace {

using Phase = Alley::Phase;

// The window of a game: the sheet over the panel, as in the program.
struct GameBench : PanelBench {
    explicit GameBench(const QString& directory)
        : alley(session, playhead, directory)
        , sheet(new ScoreSheet(context, alley, &window))
        , panel(new GamePanel(context, alley, &window))
        , statistics(new StatisticsPanel(context, alley, &window)) {
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(sheet);
        layout->addWidget(panel, 1);
        layout->addWidget(statistics, 1);
        showPanel(window, {1024, 900});
    }

    Alley alley;
    QWidget window;
    ScoreSheet* sheet;
    GamePanel* panel;
    StatisticsPanel* statistics;

    QPushButton& go() { return *panel->findChild<QPushButton*>("goOn"); }
    ScoreTable& table() { return *sheet->findChild<ScoreTable*>(); }
    QString textOf(const char* name) { return panel->findChild<QLabel*>(QLatin1String(name))->text(); }

    void start(std::vector<Player> players, ScoringRules rules = ScoringRules::Traditional) {
        alley.start(std::move(players), rules, {});
    }
    // Aimed as the lane or the panel would: by the session's throw.
    void aim(const Throw& t) { session.setThrow(t, session.scene().restitution); }
    void rollOut() { playhead.advance(100); }
    void press(Qt::Key key) {
        window.setFocus();
        QTest::keyClick(&window, key);
    }
    void clickSheet(std::size_t player, int frame, std::optional<int> roll) {
        const SheetLayout layout = table().sheetLayout();
        const QRectF where = roll ? layout.roll(player, frame, *roll) : layout.frameTotal(player, frame);
        QTest::mouseClick(&table(), Qt::LeftButton, {}, where.center().toPoint());
    }
};

Throw at(double position, double direction) {
    Throw t;
    t.position = position;
    t.direction = direction * std::numbers::pi / 180;
    return t;
}

// How many pins of `standing` a throw takes on the house lane.
PinSet takenBy(const Throw& t, const PinSet& standing) {
    Game game = newGame({{"x", 0}});
    const auto scene = replayScene(game, {{}, t, standing});
    const auto outcome = simulate(*scene, {});
    const Run& run = std::get<Run>(outcome);
    return fallenPins(run.scene, run.timeline);
}

// A straight throw that takes all that stand, or the best that was found; and one that takes some.
Throw throwFor(const PinSet& standing, bool all) {
    Throw best = at(0, 0);
    std::size_t most = 0;
    for (int k = -52; k <= 52; ++k) {
        const Throw t = at(k / 100.0, 0);
        const std::size_t down = takenBy(t, standing).count();
        if (all ? down == standing.count() : down > 0 && down < standing.count())
            return t;
        if (down > most) {
            most = down;
            best = t;
        }
    }
    return best;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool isInFile(const Alley& alley) {
    const auto read = readGame(contents(alley.path()));
    const auto* game = std::get_if<Game>(&read);
    return game && *game == alley.game();
}

std::vector<int> rollsOf(const Game& game, std::size_t player) {
    std::vector<int> rolls;
    for (const PlayedDelivery& d : game.deliveries[player])
        rolls.push_back(d.delivery.foul ? slow::foul : d.delivery.pins);
    return rolls;
}

bool agreesWithSlowScorer(const Game& game) {
    for (std::size_t k = 0; k < game.players.size(); ++k) {
        const auto expected = slow::score(rollsOf(game, k), game.rules == ScoringRules::CurrentFrame);
        const Scorecard card = cardOf(game, k);
        if (!expected.legal && expected.over)
            return false;
        for (std::size_t f = 0; f < card.frames().size(); ++f)
            if (f >= expected.totals.size() || card.frames()[f].total != expected.totals[f])
                return false;
    }
    return true;
}

const std::vector<Player> two{{"민수", 0}, {"Anna", 1}};

} // namespace

class TestGame : public QObject {
    Q_OBJECT

    Language m_language;

private slots:
    void initTestCase_data() { addLanguages(); }
    void init() {
        QFETCH_GLOBAL(bool, korean);
        useLanguage(m_language, korean);
    }

    // Typed names, clicked choices; strikes, spares, opens and gutter balls by aiming; Enter or the button.
    void aGameOfTwoIsPlayedByMouseAndKeys() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        QVERIFY(!b.sheet->isVisible());
        QInputMethodEvent korean; // as a Korean keyboard enters it
        korean.setCommitString(QStringLiteral("민수"));
        QCoreApplication::sendEvent(&field(*b.panel, "playerName1"), &korean);
        type(*b.panel, "playerName2", QStringLiteral("Anna"));
        click(*b.panel, "startGame");
        QCOMPARE(b.alley.phase(), Phase::Aim);
        QVERIFY(b.sheet->isVisible());
        QCOMPARE(b.textOf("turnName"), QStringLiteral("민수"));
        const Throw strike = throwFor(allPins, true), gutter = at(-0.5, -3);
        QCOMPARE(int(takenBy(strike, allPins).count()), 10);
        QCOMPARE(int(takenBy(gutter, allPins).count()), 0);
        QSet<QString> told;
        int throws = 0;
        for (; b.alley.turn() && throws < 50; ++throws) {
            const GameTurn turn = *b.alley.turn();
            QCOMPARE(b.session.foresight(), Foresight::FirstContact);
            QVERIFY(b.session.timeline().collisions().size() <= 1);
            QCOMPARE(b.session.standing(), pinsFor(turn.turn));
            // Player 1: gutters, opens and strikes in turn; player 2: spares and strikes.
            const int f = turn.turn.frame;
            const bool wantsAll = turn.player == 0 ? f >= 8 : f <= 2 || turn.turn.ball > 1;
            const bool gutterBall = turn.player == 0 && f == 1;
            b.aim(gutterBall ? gutter : throwFor(pinsFor(turn.turn), wantsAll));
            const Game before = b.alley.game();
            if (throws % 2)
                b.press(Qt::Key_Return);
            else
                QTest::mouseClick(&b.go(), Qt::LeftButton);
            QCOMPARE(b.alley.phase(), Phase::Rolling);
            QCOMPARE(b.alley.shown(), before); // nothing is told yet
            QVERIFY(isInFile(b.alley));        // and all is kept
            const PlayedDelivery& played = b.alley.game().deliveries[turn.player].back();
            QCOMPARE(fallenPins(b.session.scene(), b.session.timeline()), *played.delivery.down);
            QVERIFY(b.playhead.playing());
            b.rollOut();
            QVERIFY(b.alley.phase() == Phase::Result || b.alley.phase() == Phase::Over);
            QCOMPARE(b.alley.shown(), b.alley.game());
            told << b.textOf("announcement");
            QVERIFY(agreesWithSlowScorer(b.alley.game()));
            if (b.alley.phase() == Phase::Result)
                b.press(Qt::Key_Enter);
        }
        QCOMPARE(b.alley.phase(), Phase::Over);
        const Statistics all = [&] {
            Statistics s = statisticsOf(b.alley.game(), 0);
            return s += statisticsOf(b.alley.game(), 1);
        }();
        QVERIFY(all.strikes > 0 && all.spares > 0 && all.opens > 0 && all.games == 2);
        QVERIFY(told.contains(GameText("Gutter ball")));
        QVERIFY(told.contains(GameText("Strike!")));
        QVERIFY(told.contains(GameText("Spare!")));
        QVERIFY(told.contains(GameText("Turkey!")));
        QVERIFY(told.contains(GameText("Open frame")));
        const auto table = b.statistics->findChild<QTableWidget*>("statisticsTable");
        QCOMPARE(table->columnCount(), 3);
        QCOMPARE(table->item(3, 2)->text(), QStringLiteral("%1/%2").arg(all.strikes).arg(all.firstBalls));
        QVERIFY(b.textOf("announcementDetail").contains(winnerText(b.alley.game())));
    }

    // Everything that lies on the disk while a game goes on, opened as after a crash.
    void aKillAtAnyMomentLosesAtMostTheDeliveryInFlight() {
        QTemporaryDir dir, copies;
        static std::vector<GameBench*> left; // no shutdown code runs
        auto* b = new GameBench(dir.path());
        left.push_back(b);
        b->start(two);
        for (int k = 0; k < 7; ++k) {
            b->aim(at(0.08 * k - 0.3, 0.5));
            b->alley.throwBall();
            const Game thrown = b->alley.game(); // in flight
            for (const int moment : {0, 1, 2}) {
                if (moment == 1)
                    b->rollOut();
                if (moment == 2)
                    b->alley.next();
                const QString copy = copies.filePath("game.json");
                QFile::remove(copy);
                QVERIFY(QFile::copy(b->alley.path(), copy));
                PanelBench fresh;
                Alley alley(fresh.session, fresh.playhead, copies.path());
                QVERIFY(alley.continueLatest());
                QCOMPARE(alley.game(), thrown);
                QCOMPARE(alley.phase(), Phase::Aim);
            }
        }
        b->window.hide();
    }

#ifdef Q_OS_UNIX
    void aWriteThatFailsLeavesTheOldFileAndSaysSo() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        b.start(two);
        b.alley.throwBall();
        const QByteArray before = contents(b.alley.path());
        QVERIFY(!before.isEmpty());
        rlimit usual{};
        getrlimit(RLIMIT_FSIZE, &usual);
        rlimit tight = usual;
        tight.rlim_cur = 16; // bytes
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &tight);
        b.alley.next();
        b.alley.throwBall();
        setrlimit(RLIMIT_FSIZE, &usual);
        std::signal(SIGXFSZ, handler);
        QVERIFY(!b.alley.saveFault().isEmpty());
        QVERIFY(b.textOf("saveFault").contains(b.alley.saveFault()));
        QCOMPARE(contents(b.alley.path()), before);
        b.alley.next();
        b.alley.throwBall(); // the next one is kept again, with all before
        QVERIFY(b.alley.saveFault().isEmpty());
        QVERIFY(isInFile(b.alley));
    }
#endif

    void aDamagedFileIsToldAndLeftAlone() {
        QTemporaryDir dir;
        const QByteArray damaged = "{\"format\": \"thetalane-game\", \"version\": 1, \"rules\": \"mine\", "
                                   "\"players\": []}";
        for (const auto& [name, text] :
             {std::pair("a.json", damaged), std::pair("b.json", QByteArray("{"))}) {
            QFile file(dir.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        }
        GameBench b(dir.path());
        auto* list = b.panel->findChild<QListWidget*>("savedGames");
        QCOMPARE(list->count(), 2);
        for (int row = 0; row < 2; ++row) {
            list->scrollToItem(list->item(row));
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                              list->visualItemRect(list->item(row)).center());
            QCOMPARE(b.alley.phase(), Phase::NoGame);
            QVERIFY(b.textOf("savedGamesMessage").contains(".json"));
        }
        QVERIFY(!b.alley.continueLatest());
        QCOMPARE(contents(dir.filePath("a.json")), damaged);
        QCOMPARE(contents(dir.filePath("b.json")), QByteArray("{"));
    }

    void undoFoulAndCorrection() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        b.start(two);
        const Throw some = throwFor(allPins, false);
        b.aim(some);
        b.press(Qt::Key_Return);
        b.rollOut();
        const Game first = b.alley.game();
        const int pins = first.deliveries[0][0].delivery.pins;
        QVERIFY(pins > 0 && pins < 10);
        click(*b.panel, "markFoul");
        QVERIFY(b.alley.game().deliveries[0][0].delivery.foul);
        QVERIFY(isInFile(b.alley));
        b.press(Qt::Key_Return);
        QCOMPARE(b.session.standing(), allPins); // set up again
        click(*b.panel, "markFoul");
        QCOMPARE(b.alley.game(), first);
        QCOMPARE(b.session.standing(), pinsFor(b.alley.turn()->turn));
        b.press(Qt::Key_Return);
        click(*b.panel, "undoDelivery"); // while it rolls
        QCOMPARE(b.alley.game(), first);
        QCOMPARE(b.alley.phase(), Phase::Aim);
        QVERIFY(isInFile(b.alley));

        // By hand, typed: a spare; the frame is marked, and it is the other player's turn.
        b.clickSheet(0, 0, std::nullopt);
        auto* rolls = b.window.findChild<QLineEdit*>("frameRolls");
        QVERIFY(rolls && rolls->isVisible());
        QTest::keyClick(rolls, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(rolls, "55");
        QVERIFY(!b.window.findChild<QPushButton*>("applyFrame")->isEnabled());
        QVERIFY(b.window.findChild<QLabel*>("frameMessage")->isVisible());
        QTest::keyClick(rolls, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(rolls, "8/");
        QTest::keyClick(rolls, Qt::Key_Return);
        QVERIFY(!rolls->isVisible());
        QCOMPARE(b.alley.game().deliveries[0].size(), std::size_t(2));
        QVERIFY(cardOf(b.alley.game(), 0).frames()[0].corrected);
        QCOMPARE(cardOf(b.alley.game(), 0).frames()[0].mark, FrameMark::Spare);
        QCOMPARE(b.alley.turn()->player, std::size_t(1));
        QVERIFY(isInFile(b.alley));
        // Pin by pin, by the keyboard from F2 on: 7 and 10 are left, a split.
        b.table().setFocus();
        QTest::keyClick(&b.table(), Qt::Key_Home);
        QTest::keyClick(&b.table(), Qt::Key_Up);
        QTest::keyClick(&b.table(), Qt::Key_F2);
        QVERIFY(rolls->isVisible());
        auto* deck = b.window.findChild<QWidget*>("frameDeck1");
        deck->setFocus();
        for (const char digit : {'1', '2', '3', '4', '5', '6', '8', '9'})
            QTest::keyClick(deck, digit);
        QCOMPARE(rolls->text(), QStringLiteral("8/"));
        QTest::keyClick(deck, Qt::Key_Return); // the editor's, not the game's
        QCOMPARE(b.alley.phase(), Phase::Aim);
        QVERIFY(!rolls->isVisible());
        QVERIFY(cardOf(b.alley.game(), 0).frames()[0].split);
        QVERIFY(isInFile(b.alley));
    }

    void anyDeliveryIsSeenAgain() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        b.start(two);
        for (int k = 0; k < 4; ++k) {
            b.aim(at(0.1 * k - 0.2, 0));
            b.alley.throwBall();
            b.rollOut();
            b.alley.next();
        }
        const Game game = b.alley.game();
        const Subject turn = b.session.subject();
        b.clickSheet(0, 0, 0);
        if (cardOf(game, 0).deliveries()[0].strike)
            b.clickSheet(0, 0, 1);
        QCOMPARE(b.alley.phase(), Phase::Replay);
        QCOMPARE(b.session.currentThrow(), game.deliveries[0][0].thrown);
        QCOMPARE(fallenPins(b.session.scene(), b.session.timeline()), *game.deliveries[0][0].delivery.down);
        QVERIFY(b.playhead.playing());
        b.playhead.stepFrames(-5); // forward and back as any run
        b.press(Qt::Key_Return);
        QCOMPARE(b.alley.phase(), Phase::Aim);
        QCOMPARE(b.session.subject(), turn);
        QCOMPARE(b.alley.game(), game);
        auto* list = b.panel->findChild<QListWidget*>("deliveries");
        QCOMPARE(list->count(), 4);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
        QCOMPARE(b.alley.phase(), Phase::Replay);
        QCOMPARE(*b.alley.replayed(), *lastDelivery(game));
    }

    void aSceneFromElsewhereOnlyMakesTheGameWait() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        b.start(two);
        b.aim(at(-0.2, 0.3));
        const Subject turn = b.session.subject();
        b.session.openBuiltin("two-balls");
        QCOMPARE(b.alley.phase(), Phase::Elsewhere);
        QCOMPARE(b.session.foresight(), Foresight::Whole);
        b.alley.throwBall();
        QVERIFY(!lastDelivery(b.alley.game()));
        b.press(Qt::Key_Return);
        QCOMPARE(b.session.subject(), turn); // the aim is remembered
        b.session.setThrow(at(0, 0), 0.3);   // another lane than the game's
        QCOMPARE(b.alley.phase(), Phase::Elsewhere);
        b.alley.goOn();
        b.alley.throwBall();
        b.aim(at(0.1, 0)); // what would have happened if, while the ball rolls
        QCOMPARE(b.alley.phase(), Phase::Elsewhere);
        b.session.restore(turn); // what an undo of another room does
        QCOMPARE(b.alley.phase(), Phase::Elsewhere);
        QCOMPARE(b.alley.shown(), b.alley.game());
        QVERIFY(isInFile(b.alley));
        b.alley.goOn();
        QCOMPARE(b.alley.phase(), Phase::Aim);
        // The paper's loop finds other pins: what is thrown and shown is the exact engine's all the same.
        QVERIFY(!b.session.setEngine({.kind = EngineKind::Stepped}));
        b.alley.throwBall();
        QVERIFY(!b.alley.isOtherEngine());
        QCOMPARE(fallenPins(b.session.scene(), b.session.timeline()),
                 *b.alley.game().deliveries[b.alley.turn()->player].back().delivery.down);
    }

    void eightPlayersTakeTurns() {
        QTemporaryDir dir;
        GameBench b(dir.path());
        for (int k = 0; k < 6; ++k)
            click(*b.panel, "addPlayer");
        QVERIFY(!b.panel->findChild<QPushButton*>("addPlayer")->isVisible());
        b.panel->findChild<QComboBox*>("rulesChoice")->setCurrentIndex(1);
        click(*b.panel, "startGame");
        QCOMPARE(b.alley.game().players.size(), mostPlayers);
        QCOMPARE(b.alley.game().rules, ScoringRules::CurrentFrame);
        QSet<int> colours;
        for (const Player& p : b.alley.game().players)
            colours << p.colour;
        QCOMPARE(colours.size(), int(mostPlayers));
        for (int k = 0; k < 200 && b.alley.turn(); ++k) {
            if (k < 20) { // the row of now can be seen, though four of the eight can
                QCoreApplication::processEvents();
                const GameTurn now = *b.alley.turn();
                const QRectF frame = b.table().sheetLayout().frame(now.player, now.turn.frame - 1);
                QVERIFY(b.table().visibleRegion().contains(frame.toRect().adjusted(2, 2, -2, -2)));
            }
            b.alley.throwBall();
            b.alley.next();
        }
        QCOMPARE(b.alley.phase(), Phase::Over);
        QVERIFY(agreesWithSlowScorer(b.alley.game()));
        QVERIFY(isInFile(b.alley));
    }

    void theHandIsUnsteadyByASeed() {
        const Throw aim = at(-0.3, 1);
        QCOMPARE(released(aim, Release::None, 7, 0, 0), aim);
        for (const Release release : {Release::Steady, Release::League, Release::Beginner}) {
            QCOMPARE(released(aim, release, 7, 1, 2), released(aim, release, 7, 1, 2));
            QVERIFY(!(released(aim, release, 7, 1, 2) == released(aim, release, 7, 1, 3)));
            double sum = 0, squares = 0;
            constexpr int draws = 4000;
            for (int k = 0; k < draws; ++k) {
                const double off = released(aim, release, std::uint32_t(k), 0, 0).direction - aim.direction;
                sum += off;
                squares += off * off;
            }
            const double sigma = spreadOf(release).direction;
            QVERIFY(std::abs(sum / draws) < 4 * sigma / std::sqrt(double(draws)));
            QVERIFY(std::abs(std::sqrt(squares / draws) / sigma - 1) < 0.05);
        }
        QTemporaryDir dir;
        GameBench b(dir.path());
        b.alley.setRelease(Release::Beginner, 5);
        b.start(two);
        b.aim(aim);
        b.alley.throwBall();
        const Throw thrown = *b.alley.game().deliveries[0][0].thrown;
        QVERIFY(!(thrown == aim));
        QCOMPARE(*b.session.currentThrow(), thrown); // what is seen is what was recorded
        b.alley.undo();
        QCOMPARE(*b.session.currentThrow(), aim);
        b.alley.throwBall();
        QCOMPARE(*b.alley.game().deliveries[0][0].thrown, thrown); // no second chance
    }

    // Whatever is pressed: the game in memory is the one in the file, and scored right.
    void randomIntentsKeepTheFileAndTheGameTogether() {
        QFETCH_GLOBAL(bool, korean);
        QTemporaryDir dir;
        GameBench b(dir.path());
        QRandomGenerator random(korean ? 3 : 4);
        const auto chance = [&](int n) { return int(random.bounded(n)); };
        b.start({{"a", 0}, {"b", 1}, {"c", 2}});
        for (int k = 0; k < 250; ++k) {
            switch (chance(13)) {
            case 0:
                b.alley.undo();
                break;
            case 1:
                b.alley.setFoul(chance(2) == 0);
                break;
            case 2: {
                std::vector<Delivery> frame(std::size_t(1 + chance(3)));
                for (Delivery& d : frame)
                    d = {.pins = chance(11), .foul = chance(8) == 0};
                b.alley.correct(std::size_t(chance(4)), 1 + chance(10), frame);
                break;
            }
            case 3:
                b.alley.replay({std::size_t(chance(3)), std::size_t(chance(12))});
                break;
            case 4:
                b.session.openBuiltin(chance(2) ? "bowling" : "two-balls");
                break;
            case 5:
                b.aim(at(chance(100) / 100.0 - 0.5, chance(40) / 10.0 - 2));
                break;
            case 6:
                b.rollOut();
                break;
            case 7:
                b.clickSheet(std::size_t(chance(3)), chance(10),
                             chance(3) ? std::optional(chance(2)) : std::nullopt);
                break;
            case 8:
                QVERIFY(!b.alley.openSaved(QString(b.alley.path())));
                break;
            default:
                b.press(Qt::Key_Return);
            }
            QVERIFY(isInFile(b.alley));
            QVERIFY(agreesWithSlowScorer(b.alley.game()));
            if (b.alley.phase() == Phase::Aim) {
                QCOMPARE(b.session.standing(), pinsFor(turnOf(b.alley.game())->turn));
                QCOMPARE(b.session.laneConditions(), b.alley.game().lane);
            }
        }
    }

    void savedGamesAreListedAndAddedUp() {
        QTemporaryDir dir;
        {
            GameBench b(dir.path());
            b.start(two);
            b.alley.throwBall();
            click(*b.panel, "leaveGame");
            b.start(two); // nothing thrown: no file stays
            click(*b.panel, "leaveGame");
            QCOMPARE(QDir(dir.path()).entryList(QDir::Files).size(), 1);
        }
        GameBench b(dir.path());
        auto* goesOn = b.panel->findChild<QPushButton*>("continueGame");
        QVERIFY(goesOn->isVisible());
        b.statistics->findChild<QComboBox*>("statisticsOf")->setCurrentIndex(1);
        const auto* table = b.statistics->findChild<QTableWidget*>("statisticsTable");
        QCOMPARE(table->columnCount(), 3);
        QCOMPARE(table->horizontalHeaderItem(1)->text(), QStringLiteral("민수"));
        QTest::mouseClick(goesOn, Qt::LeftButton);
        QCOMPARE(b.alley.phase(), Phase::Aim);
        QVERIFY(lastDelivery(b.alley.game()).has_value());
    }

private:
    static QString GameText(const char* source) {
        return QCoreApplication::translate("GameWords", source);
    }
};

QTEST_MAIN(TestGame)
#include "test_game.moc"
