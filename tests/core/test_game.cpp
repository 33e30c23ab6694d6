// Games of several players: turns, undoing, putting right, statistics, and the file that keeps them.
#include "core/bowling/game.h"
#include "core/bowling/pinfall.h"
#include "core/bowling/score_notation.h"
#include "core/engine/engine.h"
#include "core/format/game_file.h"

#include <QTest>

#include <random>

using namespace thetalane;

namespace {

constexpr auto traditional = ScoringRules::Traditional;

Game twoPlayers(ScoringRules rules = traditional) {
    return newGame({{"지민", 0}, {"Ada \"X\"", 3}}, rules);
}

PlayedDelivery byHand(int pins, bool foul = false) {
    return {{.pins = pins, .foul = foul}};
}

// Appended; the test ends where it is refused.
void play(Game& game, const PlayedDelivery& d) {
    auto next = withDelivery(game, d);
    QVERIFY(std::holds_alternative<Game>(next));
    game = std::get<Game>(std::move(next));
}
void play(Game& game, std::initializer_list<int> pins) {
    for (const int p : pins)
        play(game, byHand(p));
}

Throw throwAt(double offset, double angle) {
    const Throw base{.speed = 8, .position = 0, .spin = 40};
    return *throwArriving(base, offset, angle, houseFriction());
}

Game randomGame(unsigned seed, int deliveries, bool thrown) {
    std::mt19937 random(seed);
    Game game = newGame({{"A", 0}, {"나", 1}, {"C", 7}}, ScoringRules(seed % 2));
    game.lane.restitution = 0.7;
    std::uniform_real_distribution<double> offset(-0.2, 0.2), angle(-0.05, 0.1);
    for (int k = 0; k < deliveries; ++k) {
        const auto turn = turnOf(game);
        if (!turn)
            break;
        if (thrown && random() % 4 != 0) {
            play(game, *playThrow(game, throwAt(offset(random), angle(random))));
        } else {
            play(game, byHand(int(random() % unsigned(turn->turn.standing + 1)), random() % 9 == 0));
        }
    }
    return game;
}

const GameError* errorOf(const std::variant<Game, GameError>& outcome) {
    return std::get_if<GameError>(&outcome);
}

} // namespace

class TestGame : public QObject {
    Q_OBJECT

private slots:
    void turnsGoFrameByFrame() {
        Game game = twoPlayers();
        const auto expect = [&](std::size_t player, int frame, int ball) {
            const auto turn = turnOf(game);
            QVERIFY(turn);
            QCOMPARE(turn->player, player);
            QCOMPARE(turn->turn.frame, frame);
            QCOMPARE(turn->turn.ball, ball);
        };
        expect(0, 1, 1);
        play(game, {7});
        expect(0, 1, 2);
        play(game, {2});
        expect(1, 1, 1);
        play(game, {10});
        expect(0, 2, 1);
        play(game, {10});
        expect(1, 2, 1);
        play(game, {0, 0});
        for (int frame = 3; frame <= 9; ++frame)
            play(game, {10, 10});
        expect(0, 10, 1);
        play(game, {10, 10, 10});
        expect(1, 10, 1);
        play(game, {4, 6});
        expect(1, 10, 3);
        play(game, {3});
        QVERIFY(!turnOf(game));
        QVERIFY(errorOf(withDelivery(game, byHand(1)))->fault == GameFault::GameOver);
        QCOMPARE(*cardOf(game, 0).total(), 9 + 9 * 30);
    }

    void wrongDeliveriesChangeNothing() {
        Game game = twoPlayers();
        play(game, {7});
        const auto outcome = withDelivery(game, byHand(4));
        QVERIFY(errorOf(outcome));
        QCOMPARE(int(errorOf(outcome)->fault), int(GameFault::WrongDelivery));
        QCOMPARE(int(errorOf(outcome)->delivery.fault), int(DeliveryFault::MoreThanStand));
        QCOMPARE(errorOf(outcome)->delivery.turn.standing, 3);
    }

    // Undone one by one, every game of the way comes back.
    void undoing() {
        std::vector<Game> way{newGame({{"A", 0}, {"B", 1}, {"C", 2}})};
        std::mt19937 random(11);
        while (const auto turn = turnOf(way.back())) {
            Game next = way.back();
            play(next, {int(random() % unsigned(turn->turn.standing + 1))});
            way.push_back(next);
        }
        QVERIFY(way.size() > 40);
        for (std::size_t k = way.size() - 1; k > 0; --k) {
            const auto before = withoutLast(way[k]);
            QVERIFY(before);
            QVERIFY(*before == way[k - 1]);
        }
        QVERIFY(!withoutLast(way[0]));
    }

    void throwsMeetWhatStands() {
        Game game = twoPlayers();
        const Throw first = throwAt(0.14, 0.02);
        const auto played = playThrow(game, first);
        QVERIFY(played && played->delivery.down && played->met == allPins);
        QVERIFY(played->delivery.pins > 0 && played->delivery.pins < 10);
        play(game, *played);
        const PinSet left = ~*played->delivery.down;
        const auto spare = playThrow(game, throwAt(-0.1, 0.01));
        QCOMPARE(spare->met, left);
        QVERIFY((*spare->delivery.down & ~left).none());
        const auto scene = replayScene(game, *spare);
        QCOMPARE(scene->bodies.size(), left.count() + 1); // what fell has been swept
        // The replay is the throw and nothing else: with details it comes to the same pins.
        const Run run = std::get<Run>(simulate(*scene, {}));
        QCOMPARE(fallenPins(run.scene, run.timeline), *spare->delivery.down);
        QVERIFY(!replayScene(game, byHand(3)));
    }

    void pinsWhereOnlyACountIsKnown() {
        Game game = twoPlayers();
        play(game, {7});
        const PinSet hindmost = pinsFor(turnOf(game)->turn);
        QCOMPARE(hindmost.to_string(), std::string("1110000000"));
        const auto played = playThrow(game, throwAt(0, 0));
        QVERIFY(!played->delivery.down);
        QVERIFY(std::holds_alternative<Game>(withDelivery(game, *played)));
    }

    void corrections() {
        Game game = twoPlayers();
        play(game, {7, 2, 10, 10, 3, 4, 5});
        const auto right = [&](std::size_t player, int frame, std::vector<Delivery> by) {
            return withFrame(game, player, frame, by);
        };
        auto changed = right(0, 1, {{.pins = 10}});
        QVERIFY(!errorOf(changed));
        Game better = std::get<Game>(changed);
        QCOMPARE(*cardOf(better, 0).frames()[0].points, 10 + 10 + 5);
        QVERIFY(cardOf(better, 0).frames()[0].corrected);
        QVERIFY(!cardOf(better, 0).frames()[1].corrected);
        QCOMPARE(turnOf(better)->player, turnOf(game)->player);
        changed = right(1, 1, {{.pins = 4}, {.pins = 4, .foul = true}});
        QVERIFY(!errorOf(changed));
        QCOMPARE(*cardOf(std::get<Game>(changed), 1).frames()[0].total, 4);
        // The last frame, begun: put right, or finished.
        QVERIFY(!errorOf(right(0, 3, {{.pins = 6}})));
        QVERIFY(!errorOf(right(0, 3, {{.pins = 6}, {.pins = 4}})));
        const auto fault = [&](std::size_t player, int frame, std::vector<Delivery> by) {
            const auto outcome = right(player, frame, by);
            return errorOf(outcome) ? int(errorOf(outcome)->fault) : -1;
        };
        QCOMPARE(fault(0, 1, {{.pins = 7}}), int(GameFault::FrameLeftOpen));
        QCOMPARE(fault(0, 1, {}), int(GameFault::FrameLeftOpen));
        QCOMPARE(fault(0, 1, {{.pins = 7}, {.pins = 4}}), int(GameFault::WrongDelivery));
        QCOMPARE(fault(0, 1, {{.pins = 10}, {.pins = 4}}), int(GameFault::WrongDelivery));
        QCOMPARE(fault(0, 1, {{.pins = 3}, {.pins = 4}, {.pins = 1}}), int(GameFault::WrongDelivery));
        QCOMPARE(fault(0, 3, {{.pins = 10}, {.pins = 1}}), int(GameFault::WrongDelivery));
        QCOMPARE(fault(0, 4, {{.pins = 1}}), int(GameFault::NoSuchFrame));
        QCOMPARE(fault(1, 0, {{.pins = 1}}), int(GameFault::NoSuchFrame));
    }

    void aCorrectedTenthFrame() {
        Game game = newGame({{"A", 0}});
        for (int k = 0; k < 9; ++k)
            play(game, {0, 0});
        play(game, {10, 3, 4});
        const auto open = withFrame(game, 0, 10, {{.pins = 3}, {.pins = 4}});
        QVERIFY(!errorOf(open));
        QCOMPARE(*cardOf(std::get<Game>(open), 0).total(), 7);
        QVERIFY(errorOf(withFrame(game, 0, 10, {{.pins = 10}, {.pins = 4}})));
        QVERIFY(errorOf(withFrame(game, 0, 10, {{.pins = 1}, {.pins = 4}, {.pins = 4}})));
    }

    void pockets() {
        QVERIFY(isPocketHit({0.0676, 0.1, 7}));
        QVERIFY(isPocketHit({-0.0676, -0.1, 7})); // a left-hander's
        QVERIFY(isPocketHit({0.05, 0, 7}));
        QVERIFY(!isPocketHit({0.0676, -0.05, 7})); // from the wrong side
        QVERIFY(!isPocketHit({0, 0.1, 7}));
        QVERIFY(!isPocketHit({0.1, 0.1, 7}));
    }

    void statistics() {
        Game game = newGame({{"A", 0}});
        play(game, *playThrow(game, throwAt(0.0676, 0.1))); // a pocket hit
        while (turnOf(game)->turn.frame == 1)
            play(game, {0});
        play(game, *playThrow(game, throwAt(-0.16, 0)));
        while (turnOf(game)->turn.frame == 2)
            play(game, {0});
        const int first = game.deliveries[0][0].delivery.pins;
        for (int k = 0; k < 7; ++k)
            play(game, {9, 1});
        play(game, {9, 0});
        const Statistics s = statisticsOf(game, 0);
        QCOMPARE(s.games, 1);
        QCOMPARE(*s.average(), double(*cardOf(game, 0).total()));
        QCOMPARE(s.pocketChances, 2);
        QCOMPARE(s.pocketHits, 1);
        QCOMPARE(s.spares, 7);
        QCOMPARE(s.firstBalls, 10);
        QVERIFY(s.firstBallPins >= 72 + first);
        Statistics sum = s;
        sum += s;
        QCOMPARE(sum.games, 2);
        QCOMPARE(*sum.average(), *s.average());
        QCOMPARE(sum.best, s.best);
        QVERIFY(!Statistics{}.average());
        QVERIFY(!Statistics{}.firstBallAverage());
    }

    void filesReadBack() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            Game game = randomGame(seed, int(seed * 3), seed % 4 == 0);
            if (seed % 3 == 0)
                game.lane.friction.reset();
            if (seed % 4 != 0 && !game.deliveries[0].empty()) {
                const auto corrected = withFrame(game, 0, 1, {{.pins = 4}, {.pins = 5}});
                if (!errorOf(corrected))
                    game = std::get<Game>(corrected);
            }
            const QByteArray file = writeGame(game);
            const auto read = readGame(file);
            QVERIFY2(std::holds_alternative<Game>(read), file.constData());
            QVERIFY(std::get<Game>(read) == game);
            QCOMPARE(writeGame(std::get<Game>(read)), file);
        }
    }

    // Whatever is cut off, the reader says so, and does not fall over.
    void damagedFiles() {
        const QByteArray file = writeGame(randomGame(4, 30, true));
        for (qsizetype length = 0; length < file.size() - 2; ++length)
            QVERIFY(std::holds_alternative<GameFileError>(readGame(file.left(length))));
    }

    void wrongFiles_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<int>("fault");
        QTest::addColumn<QString>("path");
        const auto row = [](const char* from, const char* to, GameFileFault fault, const char* path = "") {
            QTest::addRow("%s -> %s", from, to) << QByteArray(from) << QByteArray(to) << int(fault) << path;
        };
        using enum GameFileFault;
        row("thetalane-game", "thetalane-scene", WrongFormat, "format");
        row("\"version\": 1", "\"version\": 2", WrongVersion, "version");
        row("\"version\": 1, ", "", Shape);
        row("\"version\": 1", "\"versoin\": 1", Shape);
        row("traditional", "old", WrongRules, "rules");
        row("\"restitution\": 0.75", "\"restitution\": 1.5", Shape);
        row("\"name\": \"A\"", "\"name\": \" \"", NoName, "players[0].name");
        row("\"name\": \"A\"", "\"name\": 3", Shape);
        row("\"colour\": 0", "\"colour\": 8", Colour, "players[0].colour");
        row("\"pins\": 7", "\"pins\": 11", TooManyPins, "players[0].deliveries[0].pins");
        row("\"pins\": 7", "\"pins\": -1", NegativePins, "players[0].deliveries[0].pins");
        row("\"pins\": 7", "\"pins\": 6.5", NotWhole, "players[0].deliveries[0].pins");
        row("\"pins\": 7", "\"pins\": \"7\"", Shape);
        row("\"pins\": 7", "\"pins\": 10", OutOfTurn, "players[0].deliveries");
        row("\"pins\": 7", "\"pins\": 7, \"down\": [1, 2]", CountDiffers, "players[0].deliveries[0].pins");
        row("\"pins\": 7", "\"pins\": 7, \"down\": [1, 2, 3, 4, 5, 6, 11]", PinNumber,
            "players[0].deliveries[0].down[6]");
        row("\"pins\": 7", "\"pins\": 7, \"down\": [1, 2, 3, 4, 5, 6, 6]", PinTwice,
            "players[0].deliveries[0].down[6]");
        row("\"pins\": 7", "\"pins\": 7, \"foul\": 1", NotABool, "players[0].deliveries[0].foul");
        row("\"pins\": 7", "\"pins\": 7, \"spare\": true", Shape);
        row("\"pins\": 7", "\"pins\": 7, \"pins\": 7", Shape);
        row("\"pins\": 7", "\"pins\": 7, \"throw\": {}", Shape);
        row("{\"pins\": 7}, {\"pins\": 2}", "{\"pins\": 7}, {\"pins\": 2}, {\"pins\": 7}, {\"pins\": 2}",
            OutOfTurn, "players[0].deliveries");
    }
    void wrongFiles() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(int, fault);
        QFETCH(QString, path);
        QByteArray file = R"({"format": "thetalane-game", "version": 1, "rules": "traditional",
            "lane": {"restitution": 0.75}, "players": [
            {"name": "A", "colour": 0, "deliveries": [{"pins": 7}, {"pins": 2}]},
            {"name": "B", "colour": 1, "deliveries": []}]})";
        QVERIFY(std::holds_alternative<Game>(readGame(file)));
        QVERIFY(file.contains(from));
        file.replace(from, to);
        const auto read = readGame(file);
        QVERIFY(std::holds_alternative<GameFileError>(read));
        QCOMPARE(int(std::get<GameFileError>(read).fault), fault);
        QCOMPARE(QString::fromStdString(std::get<GameFileError>(read).path), path);
    }

    void throwsInFilesAreChecked() {
        Game game = newGame({{"A", 0}});
        play(game, *playThrow(game, throwAt(0.14, 0.02)));
        play(game, *playThrow(game, throwAt(0.14, 0.02)));
        const QByteArray file = writeGame(game);
        QVERIFY(std::holds_alternative<Game>(readGame(file)));
        const auto fault = [&](const char* from, const char* to) {
            QByteArray text = file;
            text.replace(text.lastIndexOf(from), qsizetype(qstrlen(from)), to);
            const auto read = readGame(text);
            return std::holds_alternative<Game>(read) ? -1 : int(std::get<GameFileError>(read).fault);
        };
        QCOMPARE(fault("\"mass_kg\": 6.8", "\"mass_kg\": -1"), int(GameFileFault::Shape));
        QCOMPARE(fault("\"position_m\": 0", "\"position_m\": 3"), int(GameFileFault::Shape));
        QCOMPARE(fault("\"standing\": [", "\"standing\": [1, "), int(GameFileFault::NotMet));
    }
};

QTEST_GUILESS_MAIN(TestGame)
#include "test_game.moc"
