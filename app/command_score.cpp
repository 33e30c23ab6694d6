// thetalane score "X 9/ 72 …": frames and totals
#include "app/commands.h"
#include "app/console.h"
#include "app/options.h"
#include "app/score_words.h"
#include "app/text_table.h"
#include "core/bowling/score_notation.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

namespace thetalane {
namespace {

struct ScoreCommandText {
    Q_DECLARE_TR_FUNCTIONS(ScoreCommandText)
};

constexpr std::string_view rulesWords[] = {"traditional", "current-frame"};

QString nameOf(ScoringRules rules) {
    return QString::fromUtf8(rulesWords[std::size_t(rules)].data());
}

QJsonValue orNull(std::optional<int> number) {
    return number ? QJsonValue(*number) : QJsonValue(QJsonValue::Null);
}

// Laid out by hand where the contract shows an order of keys: QJsonObject sorts them.
QByteArray jsonText(const Scorecard& card) {
    const auto text = [](const QJsonValue& value) {
        const QByteArray array = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
        return array.mid(1, array.size() - 2);
    };
    QByteArray frames;
    for (std::size_t k = 0; k < card.frames().size(); ++k) {
        const FrameScore& frame = card.frames()[k];
        frames += (k == 0 ? "\n    " : ",\n    ") + QByteArray("{\"rolls\": ") +
                  text(QString::fromStdString(rollsText(card, k))) +
                  ", \"points\": " + text(orNull(frame.points)) +
                  ", \"total\": " + text(orNull(frame.total)) + '}';
    }
    return "{\n  \"format\": \"thetalane-score\", \"version\": 1,\n  \"rules\": " +
           text(nameOf(card.rules())) + ",\n  \"frames\": [" + frames + (frames.isEmpty() ? "]" : "\n  ]") +
           ",\n  \"total\": " + text(orNull(card.total())) +
           ", \"complete\": " + (card.complete() ? "true" : "false") +
           ",\n  \"running_total\": " + text(card.runningTotal()) +
           ", \"highest_possible\": " + text(card.highestPossible()) + "\n}\n";
}

QString spaced(const std::string& rolls) {
    QStringList symbols;
    for (const char c : rolls)
        symbols << QString(QLatin1Char(c));
    return symbols.join(' ');
}

QString orOpen(std::optional<int> number) {
    return number ? QString::number(*number) : QStringLiteral("…");
}

QString rulesText(ScoringRules rules) {
    return rules == ScoringRules::Traditional
               ? ScoreCommandText::tr("Traditional scoring")
               : ScoreCommandText::tr(
                     "Current-frame scoring (a strike is 30, a spare 10 and its first ball)");
}

void printForPeople(const Scorecard& card) {
    const QList<Column> columns{{ScoreCommandText::tr("Frame")},
                                {ScoreCommandText::tr("Rolls"), Column::Align::Left},
                                {ScoreCommandText::tr("Points")},
                                {ScoreCommandText::tr("Total")}};
    printLine(rulesText(card.rules()));
    printTable(columns, card.frames().size(), [&](std::size_t k) {
        const FrameScore& frame = card.frames()[k];
        return QStringList{QString::number(k + 1), spaced(rollsText(card, k)), orOpen(frame.points),
                           orOpen(frame.total)};
    });
    printLine();
    printLine(ScoreCommandText::tr("Strikes: %1, spares: %2, open frames: %3")
                  .arg(card.strikes())
                  .arg(card.spares())
                  .arg(card.opens()));
    if (const auto turn = card.next())
        printLine(ScoreCommandText::tr("The game goes on: frame %1, ball %2, %3 pins stand. "
                                       "So far %4 points, at most %5 possible.")
                      .arg(turn->frame)
                      .arg(turn->ball)
                      .arg(turn->standing)
                      .arg(card.runningTotal())
                      .arg(card.highestPossible()));
    else
        printLine((card.perfect() ? ScoreCommandText::tr("Total: %1, a perfect game")
                                  : ScoreCommandText::tr("Total: %1"))
                      .arg(*card.total()));
}

// Rolls that begin with a gutter ball look like an option: they go behind a "--" of their own. A "--" that
// no option follows is no frame but the usual end of the options.
QStringList rollsLast(QStringList arguments) {
    static const QRegularExpression rolls("^-[-0-9XxFf/\\s]*$"), option("^--?[a-z]");
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (!rolls.match(arguments[i]).hasMatch())
            continue;
        if (arguments[i] == "--" && i + 1 < arguments.size() && !option.match(arguments[i + 1]).hasMatch())
            return arguments;
        const QString asked = arguments.takeAt(i);
        return arguments << "--" << asked;
    }
    return arguments;
}

} // namespace

int scoreCommand(const Call& call) {
    Arguments a("score \"X 9/ 72 …\" [--rules traditional|current-frame] [--json]", commandSummary("score"));
    a.takesOne("ROLLS",
               ScoreCommandText::tr("frames separated by spaces: X strike, / spare, 1 to 9, - none, F foul; "
                                    "the tenth with its fill balls, as in XX8"));
    a.takesValue("rules", "traditional|current-frame", ScoreCommandText::tr("traditional unless said"));
    a.takesFlag("json", ScoreCommandText::tr("prints JSON for programs"));
    if (const auto status = a.read(rollsLast(call.arguments)))
        return *status;
    const auto rules = ScoringRules(a.choice("rules", 0, rulesWords));
    if (const auto status = a.faults())
        return *status;

    const auto outcome = readRolls(a.positional().toStdString(), rules);
    if (const auto* error = std::get_if<RollError>(&outcome))
        return wrongCall(rollMessage(*error, rules));
    const Scorecard& card = std::get<Scorecard>(outcome);
    if (a.has("json"))
        standardOutput().write(jsonText(card));
    else
        printForPeople(card);
    return finishOutput();
}

} // namespace thetalane
