#include "app/score_words.h"

#include "app/console.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

struct ScoreWords {
    Q_DECLARE_TR_FUNCTIONS(ScoreWords)
};

// Texts can be as long as the call; a line should not be.
QString quoted(const std::string& text) {
    constexpr qsizetype enough = 24;
    const QString all = oneLine(QString::fromStdString(text));
    return all.size() > enough ? all.left(enough) + QStringLiteral("…") : all;
}

// What the second ball of a rack may be, beside a spare.
QString secondBall(int standing) {
    return standing > 1 ? ScoreWords::tr("a digit up to %1, - for none, F for a foul or / for a spare")
                              .arg(standing - 1)
                        : ScoreWords::tr("- for none, F for a foul or / for a spare");
}

QString whatIsWrong(const RollError& e, ScoringRules rules) {
    switch (e.fault) {
    case RollFault::UnknownSymbol:
        return ScoreWords::tr("\"%1\" is no roll; rolls are X, /, -, F and the digits 1 to 9")
            .arg(quoted(e.text));
    case RollFault::Zero:
        return ScoreWords::tr("0 is no roll; no pins are written -, all ten X");
    case RollFault::StrikeNotFirst:
        return ScoreWords::tr("X stands for all ten at the first ball; here it must be %1")
            .arg(secondBall(e.standing));
    case RollFault::SpareFirst:
        return ScoreWords::tr("/ needs a ball before it at the same pins; all ten at the first ball are "
                              "written X");
    case RollFault::MorePins:
        return ScoreWords::tr("%1 is more than the pins that stand, %2; here it must be %3")
            .arg(quoted(e.text), QString::number(e.standing), secondBall(e.standing));
    case RollFault::SpareAsDigits:
        return ScoreWords::tr("%1 takes all pins that stand; a spare is written /").arg(quoted(e.text));
    case RollFault::FrameGoesOn:
        return ScoreWords::tr("the second ball is missing; after %1 there must be %2, without a space")
            .arg(quoted(e.text), secondBall(e.standing));
    case RollFault::FrameIsOver:
        return ScoreWords::tr("the frame is over before \"%1\" ends; frames are separated by spaces")
            .arg(quoted(e.text));
    case RollFault::GameOver:
        break;
    }
    return rules == ScoringRules::CurrentFrame
               ? ScoreWords::tr("%1 is one roll too many: the game is over; current-frame scoring has no "
                                "fill balls")
                     .arg(quoted(e.text))
               : ScoreWords::tr("%1 is one roll too many: the game is over; only a strike earns two fill "
                                "balls, and a spare one")
                     .arg(quoted(e.text));
}

} // namespace

QString rollMessage(const RollError& error, ScoringRules rules) {
    return ScoreWords::tr("frame %1: %2").arg(QString::number(error.frame), whatIsWrong(error, rules));
}

} // namespace thetalane
