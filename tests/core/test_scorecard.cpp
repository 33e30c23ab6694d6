// Known games, the published error cases, splits, and random rolls against a slow scorer that shares nothing.
#include "core/bowling/score_notation.h"
#include "tests/core/slow_scorer.h"

#include <QTest>

#include <random>

using namespace thetalane;

namespace {

constexpr auto traditional = ScoringRules::Traditional;
constexpr auto current = ScoringRules::CurrentFrame;

Scorecard cardOf(const std::string& rolls, ScoringRules rules = traditional) {
    const auto read = readRolls(rolls, rules);
    const auto* card = std::get_if<Scorecard>(&read);
    return card ? *card : Scorecard(rules);
}

std::string repeated(const std::string& frame, int times, const std::string& last = {}) {
    std::string text;
    for (int k = 0; k < times; ++k)
        text += frame + ' ';
    return text + last;
}

QString totalsText(const Scorecard& card) {
    QStringList texts;
    for (const FrameScore& f : card.frames())
        texts << (f.total ? QString::number(*f.total) : QString("?"));
    return texts.join(' ');
}

PinSet pins(std::initializer_list<int> numbers) {
    PinSet set;
    for (const int n : numbers)
        set.set(std::size_t(n - 1));
    return set;
}

} // namespace

class TestScorecard : public QObject {
    Q_OBJECT

private slots:
    void knownGames_data() {
        QTest::addColumn<QString>("rolls");
        QTest::addColumn<int>("rules");
        QTest::addColumn<QString>("totals");
        const auto row = [](const std::string& rolls, ScoringRules rules, const char* totals) {
            QTest::addRow("%s %d", rolls.c_str(), int(rules))
                << QString::fromStdString(rolls) << int(rules) << totals;
        };
        const char* const known = "30 57 76 85 95 104 124 143 152 180";
        row("X X X 72 8/ F9 X 7/ 9- XX8", traditional, known);
        row("XXX 72 8/ F9 X 7/ 9- XX8", traditional, known);
        row("xxx 72 8/ f9 x\t7/ 9-  X X 8 ", traditional, known);
        row("X X X X X X X X X XXX", traditional, "30 60 90 120 150 180 210 240 270 300");
        row("XXXXXXXXXXXX", traditional, "30 60 90 120 150 180 210 240 270 300");
        row("X X X X X X X X X X X X", traditional, "30 60 90 120 150 180 210 240 270 300");
        row(repeated("5/", 9, "5/5"), traditional, "15 30 45 60 75 90 105 120 135 150");
        row(repeated("5/", 10, "5"), traditional, "15 30 45 60 75 90 105 120 135 150");
        row(repeated("9/", 9, "9/9"), traditional, "19 38 57 76 95 114 133 152 171 190");
        row(repeated("--", 10), traditional, "0 0 0 0 0 0 0 0 0 0");
        row(repeated("9-", 10), traditional, "9 18 27 36 45 54 63 72 81 90");
        row(repeated("X 9/", 4, "X 9/X"), traditional, "20 40 60 80 100 120 140 160 180 200");
        row(repeated("--", 9, "X-/"), traditional, "0 0 0 0 0 0 0 0 0 20");
        row(repeated("--", 9, "F/X"), traditional, "0 0 0 0 0 0 0 0 0 20");
        row(repeated("--", 9, "XF/"), traditional, "0 0 0 0 0 0 0 0 0 20");
        row(repeated("--", 9, "X7F"), traditional, "0 0 0 0 0 0 0 0 0 17");
        row(repeated("--", 9, "-/F"), traditional, "0 0 0 0 0 0 0 0 0 10");
        row("F/ -/ 34", traditional, "10 23 30");
        row("", traditional, "");
        row("X", traditional, "?");
        row("X X", traditional, "? ?");
        row("X 9/", traditional, "20 ?");
        row("9/ 3", traditional, "13 ?");
        row("72 8/", traditional, "9 ?");
        row(repeated("--", 9, "X X"), traditional, "0 0 0 0 0 0 0 0 0 ?");
        row(repeated("--", 9, "9/"), traditional, "0 0 0 0 0 0 0 0 0 ?");
        row("X X X X X X X X X X", current, "30 60 90 120 150 180 210 240 270 300");
        row(repeated("5/", 10), current, "15 30 45 60 75 90 105 120 135 150");
        row("X X X 72 8/ F9 X 7/ 9- X", current, "30 60 90 99 117 126 156 173 182 212");
        row("F/ -/ 9/ 9-", current, "10 20 39 48");
        row("X 7", current, "30 ?");
    }
    void knownGames() {
        QFETCH(QString, rolls);
        QFETCH(int, rules);
        QFETCH(QString, totals);
        const auto read = readRolls(rolls.toStdString(), ScoringRules(rules));
        QVERIFY(std::holds_alternative<Scorecard>(read));
        const Scorecard& card = std::get<Scorecard>(read);
        QCOMPARE(totalsText(card), totals);
        const bool whole = card.frames().size() == 10 && !totals.contains('?');
        QCOMPARE(card.complete(), whole);
        QCOMPARE(card.total().has_value(), whole);
        if (whole)
            QCOMPARE(*card.total(), totals.section(' ', -1).toInt());
    }

    void rollsAreWrittenAgain() {
        const Scorecard card = cardOf("xxx 72 8/ f9 X 7/ 9- X X 8");
        QStringList written;
        for (std::size_t k = 0; k < card.frames().size(); ++k)
            written << QString::fromStdString(rollsText(card, k));
        QCOMPARE(written.join(' '), QString("X X X 72 8/ F9 X 7/ 9- XX8"));
    }

    void badRolls_data() {
        QTest::addColumn<QString>("rolls");
        QTest::addColumn<int>("rules");
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("frame");
        const auto row = [](const std::string& rolls, RollFault fault, int frame,
                            ScoringRules rules = traditional) {
            QTest::addRow("%s %d", rolls.c_str(), int(rules))
                << QString::fromStdString(rolls) << int(rules) << int(fault) << frame;
        };
        row("X 8A", RollFault::UnknownSymbol, 2);
        row("X 핀", RollFault::UnknownSymbol, 2);
        row("72, 9/", RollFault::FrameIsOver, 1);
        row("10", RollFault::Zero, 1);
        row("72 0/", RollFault::Zero, 2);
        row("7X", RollFault::StrikeNotFirst, 1);
        row("-X", RollFault::StrikeNotFirst, 1);
        row("FX", RollFault::StrikeNotFirst, 1);
        row("72 /3", RollFault::SpareFirst, 2);
        row("X/", RollFault::FrameIsOver, 1);
        row("56", RollFault::MorePins, 1);
        row("X X 99", RollFault::MorePins, 3);
        row("55", RollFault::SpareAsDigits, 1);
        row("7 8/", RollFault::FrameGoesOn, 1);
        row("7 / 8/", RollFault::FrameGoesOn, 1);
        row("729/", RollFault::FrameIsOver, 1);
        row("XX8 72", RollFault::FrameIsOver, 1);
        row(repeated("72", 11), RollFault::GameOver, 10);
        row("XXXXXXXXXXXXX", RollFault::GameOver, 10);
        row(repeated("--", 9, "725"), RollFault::GameOver, 10);
        row(repeated("--", 9, "9/XX"), RollFault::GameOver, 10);
        row(repeated("--", 9, "X56"), RollFault::MorePins, 10);
        row(repeated("--", 9, "X6X"), RollFault::StrikeNotFirst, 10);
        row(repeated("--", 9, "XX/"), RollFault::SpareFirst, 10);
        row(repeated("--", 9, "9//"), RollFault::SpareFirst, 10);
        row(repeated("--", 9, "X X X"), RollFault::GameOver, 10, current);
        row(repeated("--", 9, "9/5"), RollFault::GameOver, 10, current);
    }
    void badRolls() {
        QFETCH(QString, rolls);
        QFETCH(int, rules);
        QFETCH(int, fault);
        QFETCH(int, frame);
        const auto read = readRolls(rolls.toStdString(), ScoringRules(rules));
        QVERIFY(std::holds_alternative<RollError>(read));
        QCOMPARE(int(std::get<RollError>(read).fault), fault);
        QCOMPARE(std::get<RollError>(read).frame, frame);
    }

    // The cases of the public bowling exercise, with its numbers of pins.
    void publishedCases_data() {
        QTest::addColumn<QList<int>>("rolls");
        QTest::addColumn<int>("refused"); // which roll, or -1
        QTest::addColumn<int>("fault");
        QTest::addColumn<int>("total"); // -1: none yet
        const auto zeros = [](int n, QList<int> then = {}) { return QList<int>(n, 0) + then; };
        const auto row = [](const char* name, const QList<int>& rolls, int total) {
            QTest::newRow(name) << rolls << -1 << -1 << total;
        };
        const auto wrong = [](const char* name, const QList<int>& rolls, DeliveryFault fault) {
            QTest::newRow(name) << rolls << int(rolls.size()) - 1 << int(fault) << -1;
        };
        row("all zeros", zeros(20), 0);
        row("no strikes or spares", QList<int>{3, 6, 3, 6, 3, 6, 3, 6, 3, 6, 3, 6, 3, 6, 3, 6, 3, 6, 3, 6},
            90);
        row("spare then zeros", QList<int>{6, 4} + zeros(18), 10);
        row("spare and the roll after", QList<int>{6, 4, 3} + zeros(17), 16);
        row("consecutive spares", QList<int>{5, 5, 3, 7, 4} + zeros(15), 31);
        row("spare last, one fill", zeros(18, {7, 3, 7}), 17);
        row("single strike", QList<int>{10} + zeros(18), 10);
        row("strike and two rolls", QList<int>{10, 5, 3} + zeros(16), 26);
        row("consecutive strikes", QList<int>{10, 10, 10, 5, 3} + zeros(12), 81);
        row("strike last, two fills", zeros(18, {10, 7, 1}), 18);
        row("spare with the fills", zeros(18, {10, 7, 3}), 20);
        row("strikes as fills", zeros(18, {10, 10, 10}), 30);
        row("strikes until the last frame", QList<int>{10, 10, 10, 10, 10, 10, 10, 10, 10, 0, 1}, 242);
        row("spare last, a strike as fill", zeros(18, {7, 3, 10}), 20);
        row("perfect", QList<int>(12, 10), 300);
        row("two fills above ten after a strike", zeros(18, {10, 10, 6}), 26);
        row("not begun", {}, -1);
        row("incomplete", {0, 0}, -1);
        row("fills of a strike missing", zeros(18, {10}), -1);
        row("one of two fills missing", zeros(18, {10, 10}), -1);
        row("fill of a spare missing", zeros(18, {7, 3}), -1);
        wrong("more than ten", {11}, DeliveryFault::MoreThanStand);
        wrong("negative", {-7}, DeliveryFault::NegativePins);
        wrong("frame above ten", {5, 6}, DeliveryFault::MoreThanStand);
        wrong("fill above ten", zeros(18, {10, 11}), DeliveryFault::MoreThanStand);
        wrong("two fills above ten", zeros(18, {10, 5, 6}), DeliveryFault::MoreThanStand);
        wrong("second fill a strike, the first none", zeros(18, {10, 6, 10}), DeliveryFault::MoreThanStand);
        wrong("second fill above ten", zeros(18, {10, 10, 11}), DeliveryFault::MoreThanStand);
        wrong("roll after ten frames", zeros(20, {0}), DeliveryFault::GameOver);
        wrong("roll after the fill of a spare", zeros(18, {7, 3, 2, 2}), DeliveryFault::GameOver);
        wrong("roll after the fills of a strike", zeros(18, {10, 3, 2, 2}), DeliveryFault::GameOver);
    }
    void publishedCases() {
        QFETCH(QList<int>, rolls);
        QFETCH(int, refused);
        QFETCH(int, fault);
        QFETCH(int, total);
        Scorecard card;
        int at = -1, why = -1;
        for (qsizetype k = 0; k < rolls.size() && at < 0; ++k)
            if (const auto error = card.add({.pins = rolls[k]})) {
                why = int(error->fault);
                at = int(k);
            }
        QCOMPARE(at, refused);
        QCOMPARE(why, fault);
        if (refused < 0)
            QCOMPARE(card.total().value_or(-1), total);
    }

    void randomRolls_data() {
        QTest::addColumn<int>("rules");
        QTest::newRow("traditional") << int(traditional);
        QTest::newRow("current frame") << int(current);
    }
    // Legal games with wrong rolls thrown in: after each roll both scorers must say the same.
    void randomRolls() {
        QFETCH(int, rules);
        std::mt19937 random(20260705);
        const auto upTo = [&](int n) { return int(random() % unsigned(n + 1)); };
        int accepted = 0, refused = 0, over = 0;
        for (int game = 0; game < 20'000; ++game) {
            Scorecard card{ScoringRules(rules)};
            std::vector<int> rolls;
            const int strikesLiked = upTo(3);
            for (int k = 0; k < 26; ++k) {
                const auto turn = card.next();
                int pins = upTo(9) < strikesLiked && turn ? turn->standing : upTo(11);
                const bool foul = upTo(15) == 0;
                rolls.push_back(foul ? slow::foul : pins);
                const slow::Game expected = slow::score(rolls, rules == int(current));
                const auto error =
                    card.add({.pins = foul ? upTo(turn ? turn->standing : 10) : pins, .foul = foul});
                QCOMPARE(!error, expected.legal);
                if (error) {
                    ++refused;
                    rolls.pop_back();
                    continue;
                }
                ++accepted;
                QCOMPARE(card.frames().size(), expected.totals.size());
                for (std::size_t f = 0; f < expected.totals.size(); ++f)
                    QCOMPARE(card.frames()[f].total, expected.totals[f]);
                QCOMPARE(card.complete(), expected.over);
                over += expected.over;
                QVERIFY(card.highestPossible() >= card.runningTotal());
            }
        }
        QVERIFY(accepted > 200'000 && refused > 50'000 && over > 10'000);
    }

    // What can still be reached, against trying everything: the last frames of games, all continuations.
    void highestPossible() {
        QCOMPARE(Scorecard().highestPossible(), 300);
        QCOMPARE(Scorecard(current).highestPossible(), 300);
        QCOMPARE(cardOf("9").highestPossible(), 290);
        QCOMPARE(cardOf("9", current).highestPossible(), 289);
        QCOMPARE(cardOf("9-").highestPossible(), 279);
        QCOMPARE(cardOf("X X 9").highestPossible(), 279);
        std::mt19937 random(7);
        for (int k = 0; k < 300; ++k) {
            Scorecard card{ScoringRules(k % 2)};
            for (auto turn = card.next(); turn && (turn->frame < 10); turn = card.next())
                card.add({.pins = int(random() % unsigned(turn->standing + 1))});
            QCOMPARE(card.highestPossible(), bestOf(card));
        }
    }

    void splits_data() {
        QTest::addColumn<QString>("standing");
        QTest::addColumn<bool>("split");
        for (const char* s : {"7 10",     "7 9",    "3 10",       "5 6",   "4 5", "4 6",  "2 7",   "8 10",
                              "7 8",      "9 10",   "4 10",       "6 7",   "5 7", "5 10", "4 9",   "6 8",
                              "4 6 7 10", "4 7 10", "4 6 7 9 10", "2 3",   "8 9", "2 10", "3 7",   "5 7 10",
                              "4 7 9",    "6 7 10", "2 4 10",     "4 5 8", "2 9", "3 8",  "7 8 10"})
            QTest::newRow(s) << s << true;
        for (const char* s : {"",        "7",      "10",    "1 2 4 10", "1 7 10", "2 8",  "3 9", "2 4 5 8",
                              "3 5 6 9", "3 6 10", "2 4 7", "6 10",     "4 7",    "2 4",  "2 5", "3 6",
                              "5 8",     "5 9",    "4 8",   "6 9",      "3 5",    "2 4 8"})
            QTest::newRow(s) << s << false;
    }
    void splits() {
        QFETCH(QString, standing);
        QFETCH(bool, split);
        PinSet set;
        for (const QString& n : standing.split(' ', Qt::SkipEmptyParts))
            set.set(std::size_t(n.toInt() - 1));
        QCOMPARE(isSplit(set), split);
        // On the card: first balls only, never of a foul.
        Scorecard card;
        const PinSet down = ~set;
        QVERIFY(!card.add({.pins = int(down.count()), .down = down}));
        QCOMPARE(card.frames()[0].split, split);
        QCOMPARE(card.splits(), int(split));
        Scorecard fouled;
        QVERIFY(!fouled.add({.pins = int(down.count()), .down = down, .foul = true}));
        QCOMPARE(fouled.splits(), 0);
    }

    void whichPinsStand() {
        Scorecard card;
        QVERIFY(!card.add({.pins = 8, .down = ~pins({7, 10})}));
        QCOMPARE(*card.next()->pins, pins({7, 10}));
        const auto error = card.errorOf({.pins = 1, .down = pins({1})});
        QVERIFY(error && error->fault == DeliveryFault::PinNotStanding && error->pins == 1);
        QVERIFY(card.errorOf({.pins = 2, .down = pins({7})})->fault == DeliveryFault::CountDiffers);
        QVERIFY(!card.add({.pins = 2, .down = pins({7, 10})}));
        QCOMPARE(card.spares(), 1);
        QCOMPARE(*card.next()->pins, allPins);
        QVERIFY(!card.add({.pins = 3, .down = pins({1, 2, 3}), .foul = true}));
        QCOMPARE(card.next()->standing, 10); // set up again
        QVERIFY(!card.next()->firstOnRack);
        QVERIFY(!card.add({.pins = 10, .down = allPins}));
        QCOMPARE(card.spares(), 2);
        QCOMPARE(card.strikes(), 0);
        QVERIFY(!card.add({.pins = 4})); // which, is not known
        QVERIFY(!card.next()->pins);
        QCOMPARE(card.next()->standing, 6);
    }

    void queries() {
        const Scorecard perfect = cardOf("XXXXXXXXXXXX");
        QVERIFY(perfect.perfect());
        QCOMPARE(perfect.strikes(), 12);
        QCOMPARE(perfect.strikesInARow(), 12);
        QVERIFY(cardOf(repeated("X", 10), current).perfect());
        const Scorecard some = cardOf("X 9/ 72 X X X");
        QCOMPARE(some.strikesInARow(), 3);
        QCOMPARE(some.spares(), 1);
        QCOMPARE(some.opens(), 1);
        QVERIFY(!some.perfect());
        QCOMPARE(cardOf("X X 9").strikesInARow(), 0);
        QCOMPARE(some.runningTotal(), 20 + 17 + 9 + 30);
    }

private:
    static int bestOf(const Scorecard& card) {
        const auto turn = card.next();
        if (!turn)
            return *card.total();
        int best = 0;
        for (int pins = 0; pins <= turn->standing; ++pins) {
            Scorecard next = card;
            next.add({.pins = pins});
            best = std::max(best, bestOf(next));
        }
        return best;
    }
};

QTEST_GUILESS_MAIN(TestScorecard)
#include "test_scorecard.moc"
