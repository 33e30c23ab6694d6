#include "app/run_report.h"

#include "app/console.h"
#include "app/text_table.h"
#include "core/format/run_file.h"
#include "core/format/run_names.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"
#include "ui/words/worked_steps.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

struct RunReportText {
    Q_DECLARE_TR_FUNCTIONS(RunReportText)
};

constexpr int timeDigits = 6; // collisions of one break follow each other by a millisecond

QString engineText(const EngineSettings& s) {
    QString text;
    switch (s.kind) {
    case EngineKind::Event:
        text = RunReportText::tr("event engine");
        if (!s.ties)
            text += ", " + RunReportText::tr("one contact at a time");
        break;
    case EngineKind::Stepped:
        text = RunReportText::tr("stepped engine, step %1 s").arg(numberText(s.step));
        if (s.approachingOnly)
            text += ", " + RunReportText::tr("approaching only");
        break;
    case EngineKind::Swept:
        text = RunReportText::tr("swept engine, step %1 s, passes: %2").arg(numberText(s.step)).arg(s.passes);
        break;
    }
    return text + ", " + fileName(s.precision);
}

bool hasTies(const Run& run) {
    const auto collisions = run.timeline.collisions();
    return std::any_of(collisions.begin(), collisions.end(), [](const Collision& c) { return c.group > 0; });
}

QString tieText(const Collision& c) {
    return c.group > 0 ? QString("%1.%2").arg(c.group).arg(c.pass) : QString();
}

QStringList collisionRow(const Run& run, std::size_t i) {
    const Collision& c = run.timeline.collisions()[i];
    const Contact<double>& contact = c.steps.contact;
    const double degrees = std::atan2(contact.sinTheta, contact.cosTheta) * 180 / std::numbers::pi;
    return {QString::number(i + 1),        numberText(c.time, timeDigits),
            pairText(run.scene, c),        numberText(contact.Z),
            numberText(degrees),           numberText(c.steps.impulse),
            numberText(c.steps.energyLoss)};
}

QStringList lastingRow(const Run& run, const LastingContact& contact) {
    Collision pair; // the same two
    pair.first = contact.first;
    pair.second = contact.second;
    pair.side = contact.side;
    return {pairText(run.scene, pair), numberText(contact.from, timeDigits),
            numberText(contact.to, timeDigits)};
}

void printLasting(const Run& run) {
    const auto contacts = run.timeline.lastingContacts();
    if (contacts.empty())
        return;
    using enum Column::Align;
    printTable({{RunReportText::tr("Pressed together by friction"), Left},
                {RunReportText::tr("From [s]"), Right},
                {RunReportText::tr("To [s]"), Right}},
               contacts.size(), [&](std::size_t i) { return lastingRow(run, contacts[i]); });
    printLine();
}

QString change(double from, double to) {
    return numberText(to - from);
}

QStringList totalsRow(const QString& name, double from, double to) {
    return {name, numberText(from, 6), numberText(to, 6), change(from, to)};
}

} // namespace

QString pairText(const Scene& scene, const Collision& collision) {
    return oneLine(bodyName(scene, collision.first) + " – " + partnerName(scene, collision));
}

void printHeading(const Run& run, Language::Code language) {
    const QString title = oneLine(sceneTitle(run.scene, language));
    printLine(title.isEmpty() ? engineText(run.settings) : title + " (" + engineText(run.settings) + ')');
    printLine();
}

void printCollisions(const Run& run) {
    if (run.timeline.collisions().empty())
        return;
    using enum Column::Align;
    QList<Column> columns{{RunReportText::tr("No."), Right},
                          {RunReportText::tr("Time [s]"), Right},
                          {RunReportText::tr("Bodies"), Left},
                          {"Z [m]", Right},
                          {"θ [°]", Right},
                          {RunReportText::tr("Impulse [N·s]"), Right},
                          {RunReportText::tr("Energy loss [J]"), Right}};
    const bool ties = hasTies(run);
    if (ties)
        columns << Column{RunReportText::tr("Tie"), Left};
    printTable(columns, run.timeline.collisions().size(), [&run, ties](std::size_t i) {
        const QStringList row = collisionRow(run, i);
        return ties ? row + QStringList{tieText(run.timeline.collisions()[i])} : row;
    });
    printLine();
    if (ties) {
        printLine(
            RunReportText::tr("1.2 under Tie: the first instant at which several contacts meet, its second "
                              "pass. Contacts of one pass are resolved together."));
        printLine();
    }
}

void printTotals(const Run& run) {
    printLasting(run);
    const std::vector<BodyState> first = startStates(run),
                                 last = run.timeline.stateAt(run.timeline.endTime());
    const Totals start = totals(run.scene, first), end = totals(run.scene, last);
    QList<QStringList> rows{
        totalsRow(RunReportText::tr("Momentum, x [kg·m/s]"), start.momentum.x, end.momentum.x),
        totalsRow(RunReportText::tr("Momentum, y [kg·m/s]"), start.momentum.y, end.momentum.y),
        totalsRow(RunReportText::tr("Kinetic energy [J]"), start.energy, end.energy)};
    if (run.scene.friction)
        rows << totalsRow(RunReportText::tr("Energy of rotation [J]"), rotationalEnergy(run.scene, first),
                          rotationalEnergy(run.scene, last));
    using enum Column::Align;
    printTable({{RunReportText::tr("Total"), Left},
                {RunReportText::tr("Start"), Right},
                {RunReportText::tr("End"), Right},
                {RunReportText::tr("Change"), Right}},
               std::size_t(rows.size()), [&rows](std::size_t i) { return rows[qsizetype(i)]; });
    printLine();
    printLine(RunReportText::tr("Collisions: %1").arg(run.timeline.collisionCount()));
    printLine(
        RunReportText::tr("Ended at %1 s: %2")
            .arg(numberText(run.timeline.endTime(), timeDigits), endReasonText(run.timeline.endReason())));
}

} // namespace thetalane
