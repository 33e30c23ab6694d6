#include "ui/lab/lab_words.h"

#include "ui/words/instant.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

struct LabWords {
    Q_DECLARE_TR_FUNCTIONS(LabWords)
};

QString placeText(const Vec2d& p) {
    return QStringLiteral("(%1, %2) m").arg(numberText(p.x, 3), numberText(p.y, 3));
}

// A contact of a list: its number, who meets, and when.
QString contactText(const Run& run, std::size_t index) {
    const auto list = run.timeline.collisions();
    if (index >= list.size())
        return LabWords::tr("none");
    return LabWords::tr("contact %1, %2 at %3 s")
        .arg(index + 1)
        .arg(contactName(run.scene, list[index]), numberText(list[index].time));
}

} // namespace

QString presetName(Preset preset) {
    switch (preset) {
    case Preset::Through:
        return LabWords::tr("It went through");
    case Preset::Twice:
        return LabWords::tr("It hit twice");
    case Preset::SmallerStep:
        return LabWords::tr("Smaller step, no better");
    case Preset::Float:
        return LabWords::tr("Is float enough?");
    case Preset::Friction:
        return LabWords::tr("What friction costs");
    case Preset::Butterfly:
        break;
    }
    return LabWords::tr("Butterfly: 1 µm to the left");
}

QString presetQuestion(Preset preset) {
    switch (preset) {
    case Preset::Through:
        return LabWords::tr("A fast ball, a pin, and steps so long that the ball can skip through it");
    case Preset::Twice:
        return LabWords::tr("One ball, one pin, e = 0.75: how often the paper's loop exchanges one contact");
    case Preset::SmallerStep:
        return LabWords::tr("Throws at the rack with ever smaller steps, against the exact method");
    case Preset::Float:
        return LabWords::tr("Throws at the rack with 24, 53 and 113 bits");
    case Preset::Friction:
        return LabWords::tr("Throws down the whole lane with all models, then with one left out each");
    case Preset::Butterfly:
        break;
    }
    return LabWords::tr(
        "The same throws at the rack with the ball a little to the left; no method errs here");
}

QString shiftText(double metres) {
    if (metres < 1e-6)
        return numberText(metres * 1e9, 3) + QStringLiteral(" nm");
    if (metres < 1e-3)
        return numberText(metres * 1e6, 3) + QStringLiteral(" µm");
    return numberText(metres * 1e3, 3) + QStringLiteral(" mm");
}

QString rowName(const LabPlan& plan, std::size_t row) {
    if (!plan.shifts.empty())
        return LabWords::tr("ball %1 to the left").arg(shiftText(plan.shifts[row]));
    const Method& method = plan.options.methods[row];
    if (plan.preset != Preset::Friction)
        return methodText(method);
    return method.without.empty() ? LabWords::tr("with all models")
                                  : LabWords::tr("without %1").arg(modelText(method.without.front()));
}

QString percentText(double part) {
    const double percent = 100 * part;
    const bool whole = percent == 0 || percent == 100;
    double shown = std::round(percent * 10) / 10;
    if (!whole) // what is nearly all is not all
        shown = std::clamp(shown, 0.1, 99.9);
    return QString::number(shown, 'f', whole ? 0 : 1) + QStringLiteral(" %");
}

QString keptTogether(QString text) {
    static const QRegularExpression before("(?<=[0-9⁰¹²³⁴⁵⁶⁷⁸⁹]) (?=([nµmc]?m|m/s|[nµm]?s|%)\\b|%)");
    constexpr QChar space(0x00A0);
    text.replace(before, QString(space));
    return text.replace(QStringLiteral(" + r₂"), QString(space) + '+' + space + QStringLiteral("r₂"));
}

QString labState(const LabResult& result) {
    const StudyResult& s = result.study;
    QString count = s.casesAsked > 1 ? LabWords::tr("%1 of %2 throws").arg(s.cases).arg(s.casesAsked)
                                     : LabWords::tr("one scene, %1 s").arg(numberText(s.until, 3));
    if (s.until < 0.999 * s.untilAsked)
        count = LabWords::tr("%1 s of %2 s: further the truth would take too long")
                    .arg(numberText(s.until, 3), numberText(s.untilAsked, 3));
    if (!result.ended) {
        if (result.part < 0.03 || result.seconds < 0.3)
            return count;
        const double left = result.seconds * (1 - result.part) / result.part;
        return LabWords::tr("%1 · about %2 s left").arg(count).arg(std::max(1, int(std::ceil(left))));
    }
    const QString time = numberText(result.seconds, 2);
    return s.cancelled ? LabWords::tr("Cancelled after %1 s; shown is what there is: %2").arg(time, count)
                       : LabWords::tr("%1 · measured in %2 s").arg(count, time);
}

QString ghostShortText(const LabPlan& plan, const Ghost& ghost) {
    const QString name = rowName(plan, ghost.row);
    return ghost.parting ? LabWords::tr("%1: leaves at %2 s").arg(name, numberText(ghost.parting->time, 3))
                         : LabWords::tr("%1: stays to the end").arg(name);
}

QString ghostText(const LabResult& result, const Ghost& ghost) {
    const LabPlan& plan = *result.plan;
    const Run& truth = *result.ghosts->truth;
    QStringList lines;
    if (const auto& p = ghost.parting)
        lines << LabWords::tr("At %1 s, at %2, the body “%3” is more than %4 mm from where it should be.")
                     .arg(numberText(p->time), placeText(p->run), bodyName(truth.scene, p->body),
                          numberText(1e3 * plan.tolerance, 3));
    else
        lines << LabWords::tr("No body is ever more than %1 mm from where it should be.")
                     .arg(numberText(1e3 * plan.tolerance, 3));
    if (ghost.difference)
        lines << LabWords::tr("The first contact that differs: should be %1; here: %2.")
                     .arg(contactText(truth, *ghost.difference), contactText(*ghost.run, *ghost.difference));
    else
        lines << LabWords::tr("All contacts are the same.");
    if (ghost.digits && plan.shifts.empty())
        lines << LabWords::tr("Digits left after the last contact: %1.")
                     .arg(QString::number(*ghost.digits, 'f', 1));
    return lines.join(' ');
}

} // namespace thetalane
