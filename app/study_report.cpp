#include "app/study_report.h"

#include "app/console.h"
#include "app/text_table.h"
#include "core/format/run_names.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>

#include <cmath>

namespace thetalane {
namespace {

struct StudyReportText {
    Q_DECLARE_TR_FUNCTIONS(StudyReportText)
};

QString percent(double part) {
    const double p = 100 * part;
    return (p == 0 || p == 100 ? QString::number(p) : QString::number(p, 'f', p > 99 || p < 1 ? 2 : 1)) +
           " %";
}

QString ratioText(const MethodResult& r) {
    return r.costRounds > 0 ? numberText(r.costRatio, 3) : QStringLiteral("–");
}

QString spreadText(const MethodResult& r) {
    if (r.state == MethodState::TooSlow && !std::isfinite(r.cost.median))
        return QStringLiteral("–");
    if (r.state == MethodState::TooSlow)
        return StudyReportText::tr("about %1").arg(costText(r.cost.median));
    return r.costRounds > 0 ? costText(r.cost.median) : QStringLiteral("–");
}

// How wide the middle half of the rounds is, of their median.
QString halfText(const MethodResult& r) {
    return r.costRounds > 1
               ? QString::number(100 * (r.cost.upper - r.cost.lower) / r.cost.median, 'f', 0) + " %"
               : QStringLiteral("–");
}

QString stateText(const MethodResult& r) {
    switch (r.state) {
    case MethodState::Refused:
        return StudyReportText::tr("refused: %1").arg(refusalMessage(r.refusal));
    case MethodState::TooSlow:
        return StudyReportText::tr("too slow, left out");
    case MethodState::Waiting:
        return StudyReportText::tr("not reached");
    case MethodState::Measured:
        break;
    }
    return {};
}

QStringList rowOf(const StudyResult& result, const MethodResult& r) {
    QStringList cells{methodText(r.method), spreadText(r), halfText(r), ratioText(r)};
    if (r.cases == 0)
        return cells << stateText(r) << ""
                     << ""
                     << ""
                     << ""
                     << ""
                     << ""
                     << "";
    if (r.method == result.truth)
        cells << StudyReportText::tr("the truth") << "";
    else
        cells << numberText(r.error().median, 2) << numberText(r.error().rms, 2);
    const bool differs = r.sameOrder < 1;
    return cells << percent(r.sameTouched)
                 << (differs ? QString::number(r.firstDifference.median + 1) + " · " +
                                   numberText(r.differenceTime.median, 3) + " s"
                             : QStringLiteral("–"))
                 << numberText(r.energyDrift, 2) << numberText(r.missed, 3) << numberText(r.repeated, 3)
                 << numberText(r.collisions, 4);
}

void printNotes(const StudyResult& result) {
    printLine();
    printLine(StudyReportText::tr(
        "Cost: processor time on one core, the methods in turn; median, the middle half of "
        "the rounds, and the ratio to the first row."));
    printLine(StudyReportText::tr(
        "Error: rms over the bodies of the distance from where they should be at the end; "
        "median and rms over the cases."));
    printLine(StudyReportText::tr(
        "First difference: the contact that is the first to differ, and its time; median of "
        "the cases that differ."));
    printLine(StudyReportText::tr(
        "Energy: off at the end, of the energy at the start. Missed, repeated: contacts, a case."));
    printLine(StudyReportText::tr("Truth: %1; studied until %2 s.")
                  .arg(methodText(result.truth), numberText(result.until)));
    if (result.until < result.untilAsked)
        printLine(StudyReportText::tr("Until %1 s was asked for: the truth does not get there in the time "
                                      "allowed, or chaos has eaten its digits by then.")
                      .arg(numberText(result.untilAsked)));
    if (result.truth.settings.precision != Precision::Quad)
        printLine(StudyReportText::tr(
            "Too many bodies for 113 bits: the truth is the next-event run itself, and has its errors."));
    if (std::isfinite(result.truthDigits))
        printLine(
            StudyReportText::tr("Digits that chaos leaves of the truth at the last collision, at least: %1")
                .arg(QString::number(result.truthDigits, 'f', 1)));
    for (const MethodResult& r : result.methods)
        if (r.digitsAsked > 0 && !(r.method == result.truth))
            printLine(StudyReportText::tr(
                          "Digits left of %1: said within one digit of the truth at %2 of %3 collisions.")
                          .arg(methodText(r.method), percent(r.digitsRight))
                          .arg(r.digitsAsked));
    if (result.cancelled)
        printLine(StudyReportText::tr("Cancelled: %1 of %2 cases are in this table.")
                      .arg(result.cases)
                      .arg(result.casesAsked));
}

QString number(double value) {
    return std::isfinite(value) ? exactText(value) : QString();
}

QString cell(QString text) {
    return text.contains(',') || text.contains('"') ? '"' + text.replace('"', "\"\"") + '"' : text;
}

constexpr const char* stateNames[] = {"measured", "waiting", "refused", "too-slow"};
constexpr const char* modelNames[] = {"friction", "spin", "oil", "restitution", "wall-restitution", "ties"};

QString variantOf(const Method& m) {
    QStringList parts;
    if (m.settings.kind == EngineKind::Stepped && m.settings.approachingOnly)
        parts << "approaching-only";
    if (m.settings.kind == EngineKind::Swept)
        parts << QString("passes=%1").arg(m.settings.passes);
    for (const Model model : m.without)
        parts << QString("without-") + modelNames[int(model)];
    return parts.join('+');
}

QStringList costCells(const MethodResult& r) {
    if (r.costRounds == 0)
        return {"", "", "", "", ""};
    return {number(r.cost.lower), number(r.cost.upper), number(r.costRatio), number(r.costPerSecond),
            r.collisions > 0 ? number(r.costPerCollision) : QString()};
}

QStringList errorCells(const MethodResult& r) {
    QStringList cells;
    if (r.cases == 0)
        return QStringList(12 + int(studyTimes), "");
    const bool differs = r.sameOrder < 1;
    cells << number(r.error().rms) << number(r.error().worst) << number(100 * r.sameDown)
          << number(100 * r.sameOrder) << (differs ? number(r.firstDifference.median + 1) : "")
          << (differs ? number(r.differenceTime.median) : "") << number(r.missed) << number(r.repeated)
          << number(r.energyDrift) << number(r.momentumDrift);
    for (const PositionError& e : r.errors)
        cells << number(e.median);
    if (r.digitsAsked == 0)
        return cells << ""
                     << "";
    return cells << QString::number(r.digitsAsked) << number(100 * r.digitsRight);
}

QStringList csvRow(const StudyResult& result, const MethodResult& r) {
    const EngineSettings& s = r.method.settings;
    const bool errors = r.cases > 0, cost = r.costRounds > 0;
    return QStringList{fileName(s.kind),
                       fileName(s.precision),
                       s.kind == EngineKind::Event ? QString() : number(s.step),
                       cost ? number(r.cost.median) : QString(),
                       errors ? number(r.error().median) : QString(),
                       errors ? number(100 * r.sameTouched) : QString(),
                       errors ? number(r.collisions) : QString(),
                       variantOf(r.method),
                       stateNames[int(r.state)],
                       QString::number(r.cases),
                       QString::number(r.costRounds)} +
           costCells(r) + errorCells(r) + QStringList{number(result.until)};
}

constexpr const char* header =
    "engine,precision,step_s,cost_us,error_m,same_pins_percent,collisions,variant,state,cases,cost_rounds,"
    "cost_lower_us,cost_upper_us,cost_ratio,us_per_simulated_s,us_per_collision,error_rms_m,error_worst_m,"
    "same_down_percent,same_order_percent,first_difference,first_difference_s,missed,repeated,energy_drift,"
    "momentum_drift,error_1_m,error_2_m,error_3_m,error_4_m,error_5_m,error_6_m,error_7_m,error_8_m,digits_"
    "collisions,digits_right_percent,until_s,"
    "seed,date,machine,call\n";

} // namespace

void printStudy(const StudyResult& result, bool throws) {
    using Align = Column::Align;
    const QList<Column> columns{{StudyReportText::tr("Method"), Align::Left},
                                {throws ? StudyReportText::tr("a throw") : StudyReportText::tr("a run")},
                                {StudyReportText::tr("spread")},
                                {StudyReportText::tr("ratio")},
                                {StudyReportText::tr("error [m]")},
                                {StudyReportText::tr("rms [m]")},
                                {StudyReportText::tr("same touched")},
                                {StudyReportText::tr("first difference")},
                                {StudyReportText::tr("energy")},
                                {StudyReportText::tr("missed")},
                                {StudyReportText::tr("repeated")},
                                {StudyReportText::tr("collisions")}};
    printTable(columns, result.methods.size(),
               [&](std::size_t i) { return rowOf(result, result.methods[i]); });
    printNotes(result);
}

void printModels(const StudyResult& ablation, bool throws) {
    using Align = Column::Align;
    const QList<Column> columns{{StudyReportText::tr("Left out"), Align::Left},
                                {throws ? StudyReportText::tr("a throw") : StudyReportText::tr("a run")},
                                {StudyReportText::tr("spread")},
                                {StudyReportText::tr("its share of the cost")},
                                {StudyReportText::tr("other pins down")},
                                {StudyReportText::tr("other pins touched")},
                                {StudyReportText::tr("off by [m]")}};
    printLine();
    printTable(columns, ablation.methods.size(), [&](std::size_t i) {
        const MethodResult& r = ablation.methods[i];
        const QString name =
            i == 0 ? StudyReportText::tr("nothing: all models") : modelText(r.method.without.front());
        QStringList cells{name, spreadText(r), halfText(r)};
        if (i == 0)
            return cells << ""
                         << ""
                         << ""
                         << "";
        cells << (r.costRounds > 0 ? QString::number(qRound(100 * (1 - r.costRatio))).replace('-', "−") + " %"
                                   : QStringLiteral("–"));
        return r.cases == 0 ? cells << stateText(r) << ""
                                    << ""
                            : cells << percent(1 - r.sameDown) << percent(1 - r.sameTouched)
                                    << numberText(r.error().median, 2);
    });
}

QString studyCsv(const QList<const StudyResult*>& results, const StudyConditions& conditions) {
    QString text = header;
    const QStringList last{conditions.seed, conditions.date, cell(conditions.machine), cell(conditions.call)};
    for (const StudyResult* result : results)
        for (const MethodResult& r : result->methods)
            if (result == results.front() || !(r.method == result->truth)) // that one is there already
                text += (csvRow(*result, r) + last).join(',') + '\n';
    return text;
}

} // namespace thetalane
