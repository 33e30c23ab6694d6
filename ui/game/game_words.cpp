#include "ui/game/game_words.h"

#include "ui/words/game_text.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <numbers>

namespace thetalane {
namespace {

struct GameWords {
    Q_DECLARE_TR_FUNCTIONS(GameWords)
};

QStringList pinNumbers(const PinSet& pins) {
    QStringList numbers;
    for (std::size_t k = 0; k < pins.size(); ++k)
        if (pins[k])
            numbers << QString::number(int(k) + 1);
    return numbers;
}

// What a delivery left, where that is known.
std::optional<PinSet> leftBy(const ScoredDelivery& d) {
    if (!d.turn.pins || !d.delivery.down)
        return std::nullopt;
    return *d.turn.pins & ~*d.delivery.down;
}

// Strikes in a row up to this delivery.
int strikesUpTo(const Scorecard& card, std::size_t delivery) {
    int count = 0;
    for (std::size_t k = delivery + 1; k-- > 0 && card.deliveries()[k].strike;)
        ++count;
    return count;
}

QString strikeText(int inARow) {
    switch (inARow) {
    case 1:
        return GameWords::tr("Strike!");
    case 2:
        return GameWords::tr("Double!");
    case 3:
        return GameWords::tr("Turkey!");
    default:
        return GameWords::tr("%1 strikes in a row!").arg(inARow);
    }
}

// The ball left the lane before it came to the pins.
bool isGutterBall(const Game& game, const PlayedDelivery& d) {
    return d.delivery.pins == 0 && d.thrown && !entryOf(*d.thrown, game.lane.friction);
}

bool endsOpenFrame(const Scorecard& card, std::size_t delivery) {
    for (const FrameScore& f : card.frames())
        if (f.mark == FrameMark::Open && std::size_t(f.first + f.count) == delivery + 1)
            return true;
    return false;
}

QString rollWords(const ScoredDelivery& d) {
    if (d.delivery.foul)
        return GameWords::tr("foul");
    if (d.strike)
        return GameWords::tr("strike");
    if (d.spare)
        return GameWords::tr("spare");
    if (d.split)
        return GameWords::tr("%1 (split)").arg(d.delivery.pins);
    return QString::number(d.delivery.pins);
}

} // namespace

QString playerName(const Game& game, std::size_t player) {
    return QString::fromStdString(game.players[player].name);
}

QString rulesText(ScoringRules rules) {
    return rules == ScoringRules::Traditional ? GameWords::tr("Traditional scoring")
                                              : GameWords::tr("Current-frame scoring");
}

QString releaseText(Release release) {
    switch (release) {
    case Release::Steady:
        return GameWords::tr("Steady hand");
    case Release::League:
        return GameWords::tr("League player");
    case Release::Beginner:
        return GameWords::tr("Beginner");
    case Release::None:
        break;
    }
    return GameWords::tr("Exactly as aimed");
}

QString releaseToolTip(Release release) {
    if (release == Release::None)
        return GameWords::tr("The ball is thrown exactly as it is aimed.");
    const ReleaseSpread s = spreadOf(release);
    return GameWords::tr(
               "The ball leaves the hand by chance a little otherwise than aimed. Standard deviations "
               "(guesses): speed %1 m/s, direction %2°, position %3 cm, rotation %4 %.")
        .arg(numberText(s.speed), numberText(s.direction * 180 / std::numbers::pi),
             numberText(s.position * 100), numberText(s.spin * 100));
}

QString laneText(const LaneConditions& lane) {
    if (!lane.friction)
        return GameWords::tr("No friction");
    return lane.friction->oil.empty() ? GameWords::tr("Dry lane") : GameWords::tr("House oil");
}

QString standingText(const PinSet& standing) {
    if (standing.all())
        return GameWords::tr("All ten pins stand");
    if (standing.none())
        return GameWords::tr("No pins stand");
    if (standing.count() == 1)
        return GameWords::tr("Pin %1 stands").arg(pinNumbers(standing).first());
    return GameWords::tr("Pins %1 stand").arg(pinNumbers(standing).join(QStringLiteral(", ")));
}

QString splitText(const PinSet& standing) {
    return GameWords::tr("%1 split").arg(pinNumbers(standing).join(u'-'));
}

QString announcement(const Game& game, const DeliveryPlace& place) {
    const Scorecard card = cardOf(game, place.player);
    const ScoredDelivery& d = card.deliveries()[place.delivery];
    const bool isLast = place.delivery + 1 == card.deliveries().size();
    if (isLast && card.perfect() && game.rules == ScoringRules::Traditional)
        return GameWords::tr("Perfect game! 300");
    if (isLast && card.perfect())
        return GameWords::tr("Perfect game!");
    if (d.delivery.foul)
        return GameWords::tr("Foul");
    if (d.strike)
        return strikeText(strikesUpTo(card, place.delivery));
    if (d.spare)
        return GameWords::tr("Spare!");
    if (isGutterBall(game, game.deliveries[place.player][place.delivery]))
        return GameWords::tr("Gutter ball");
    if (d.split)
        if (const auto left = leftBy(d))
            return splitText(*left);
    if (endsOpenFrame(card, place.delivery))
        return GameWords::tr("Open frame");
    return d.delivery.pins == 0 ? GameWords::tr("No pins")
                                : GameWords::tr("Pins down: %1").arg(d.delivery.pins);
}

const char* announcementTerm(const Game& game, const DeliveryPlace& place) {
    const Scorecard card = cardOf(game, place.player);
    const ScoredDelivery& d = card.deliveries()[place.delivery];
    if (place.delivery + 1 == card.deliveries().size() && card.perfect())
        return "perfect-game";
    if (d.delivery.foul)
        return "foul";
    if (d.strike)
        return strikesUpTo(card, place.delivery) > 1 ? "turkey" : "strike";
    if (d.spare)
        return "spare";
    if (isGutterBall(game, game.deliveries[place.player][place.delivery]))
        return "gutter";
    if (d.split)
        return "split";
    return endsOpenFrame(card, place.delivery) ? "open-frame" : "pinfall";
}

QString announcementDetail(const Game& game, const DeliveryPlace& place) {
    const Scorecard card = cardOf(game, place.player);
    const ScoredDelivery& d = card.deliveries()[place.delivery];
    QStringList parts{deliveryText(game, place) + QStringLiteral(".")};
    if (d.delivery.foul)
        parts << GameWords::tr("The pins do not count and are set up again.");
    else if (const auto left = leftBy(d); left && left->any())
        parts << standingText(*left) + QStringLiteral(".");
    if (d.spare && place.delivery > 0 && card.deliveries()[place.delivery - 1].split)
        if (const auto was = leftBy(card.deliveries()[place.delivery - 1]))
            parts << GameWords::tr("%1 picked up.").arg(splitText(*was));
    if (!turnOf(game))
        parts << winnerText(game);
    return parts.join(u' ');
}

QString winnerText(const Game& game) {
    int best = -1;
    QStringList winners;
    for (std::size_t k = 0; k < game.players.size(); ++k) {
        const int total = cardOf(game, k).runningTotal();
        if (total > best)
            winners.clear();
        best = std::max(best, total);
        if (total == best)
            winners << playerName(game, k);
    }
    if (game.players.size() == 1)
        return GameWords::tr("The game is over with %1 points.").arg(best);
    return winners.size() == 1
               ? GameWords::tr("%1 wins with %2 points.").arg(winners.first(), QString::number(best))
               : GameWords::tr("A tie at %2 points: %1.")
                     .arg(winners.join(QStringLiteral(", ")), QString::number(best));
}

QString placeText(const Turn& turn) {
    return GameWords::tr("Frame %1, ball %2").arg(turn.frame).arg(turn.ball);
}

QString deliveryText(const Game& game, const DeliveryPlace& place) {
    const Scorecard card = cardOf(game, place.player);
    const ScoredDelivery& d = card.deliveries()[place.delivery];
    return GameWords::tr("%1, frame %2, ball %3: %4")
        .arg(playerName(game, place.player), QString::number(d.turn.frame), QString::number(d.turn.ball),
             rollWords(d));
}

QString deliveryLine(const Game& game, const DeliveryPlace& place) {
    const Scorecard card = cardOf(game, place.player);
    const ScoredDelivery& d = card.deliveries()[place.delivery];
    return placeText(d.turn) + QStringLiteral(": ") + rollWords(d) + QStringLiteral(" · ") +
           playerName(game, place.player);
}

QString frameText(const Game& game, std::size_t player, int frame) {
    const Scorecard card = cardOf(game, player);
    const QString name = playerName(game, player);
    if (frame > int(card.frames().size()))
        return GameWords::tr("%1, frame %2: not played").arg(name, QString::number(frame));
    const FrameScore& f = card.frames()[std::size_t(frame - 1)];
    QStringList rolls;
    for (int k = 0; k < f.count; ++k)
        rolls << rollWords(card.deliveries()[std::size_t(f.first + k)]);
    QString text = GameWords::tr("%1, frame %2: %3.")
                       .arg(name, QString::number(frame), rolls.join(QStringLiteral(", ")));
    if (f.total)
        text += ' ' + GameWords::tr("Total %1.").arg(*f.total);
    if (f.corrected)
        text += ' ' + GameWords::tr("Corrected by hand.");
    return text;
}

QString gameTitle(const Game& game) {
    const auto turn = turnOf(game);
    QStringList names;
    for (std::size_t k = 0; k < game.players.size(); ++k)
        names << (turn ? playerName(game, k)
                       : playerName(game, k) + u' ' + QString::number(cardOf(game, k).runningTotal()));
    const QString all = names.join(QStringLiteral(", "));
    return turn ? GameWords::tr("%1 · frame %2").arg(all, QString::number(turn->turn.frame)) : all;
}

QString storeFaultText(const StoreFault& fault) {
    return fault.file ? gameFileErrorText(*fault.file) : fault.system;
}

QString rollsFaultText(const RollError& e) {
    switch (e.fault) {
    case RollFault::MorePins:
    case RollFault::SpareAsDigits:
        return GameWords::tr("%1 pins stand: fewer are a digit, all of them /").arg(e.standing);
    case RollFault::StrikeNotFirst:
        return GameWords::tr("X is all ten at the first ball; a spare is written /");
    case RollFault::SpareFirst:
        return GameWords::tr("/ is a spare; all ten at the first ball are written X");
    case RollFault::FrameGoesOn:
        return GameWords::tr("the second ball is missing");
    case RollFault::FrameIsOver:
    case RollFault::GameOver:
        return GameWords::tr("this is more than one frame");
    case RollFault::UnknownSymbol:
    case RollFault::Zero:
        break;
    }
    return GameWords::tr("rolls are X, /, -, F and the digits 1 to 9");
}

} // namespace thetalane
