// The sentence of each preset: the point, said with the numbers that were measured.
#include "ui/lab/lab_words.h"

#include "ui/words/method_text.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

struct LabSentence {
    Q_DECLARE_TR_FUNCTIONS(LabSentence)
};

// What a row of the study found; null while there is nothing.
const MethodResult* find(const LabResult& r, const Method& method) {
    for (const MethodResult& m : r.study.methods)
        if (m.method == method && m.cases > 0)
            return &m;
    return nullptr;
}

// Two digits are enough for a ratio: 12000, 37, 3.4, 0.95.
QString times(double ratio) {
    if (ratio < 10)
        return QString::number(ratio, 'f', ratio < 1 ? 2 : 1);
    const double unit = std::pow(10, std::floor(std::log10(ratio)) - 1);
    return QString::number(std::round(ratio / unit) * unit, 'f', 0);
}

QString lengthText(double metres) {
    if (metres >= 1)
        return numberText(metres, 3) + " m";
    if (metres >= 0.01)
        return numberText(metres * 100, 3) + " cm";
    return metres >= 1e-10 ? shiftText(metres) : numberText(metres, 2) + " m";
}

QString through(const LabResult& r) {
    const LabDials& d = r.plan->dials;
    const MethodResult* loop = find(r, steppedMethod(d.step(), false));
    const MethodResult* swept = find(r, sweptMethod(d.step(), 1));
    if (!loop || !swept)
        return {};
    const double part = 1 - loop->sameTouched;
    const QString way = lengthText(d.wayOfAStep()), limit = lengthText(wayThrough());
    if (part == 0)
        return LabSentence::tr(
                   "At %1 m/s and %2 the ball moves %3 in a step: less than 2(r₁ + r₂) = %4, so it "
                   "cannot skip the pin. It went through in 0 of %5 throws.")
            .arg(numberText(d.speed), stepText(d.step()), way, limit)
            .arg(loop->cases);
    return LabSentence::tr("At %1 m/s and %2 the ball moves %3 in a step: more than 2(r₁ + r₂) = %4. It went "
                           "through the pin in %5 of %6 throws; swept steps of the same length: in %7.")
        .arg(numberText(d.speed), stepText(d.step()), way, limit, percentText(part))
        .arg(loop->cases)
        .arg(percentText(1 - swept->sameTouched));
}

QString twice(const LabResult& r) {
    const MethodResult* coarse = find(r, steppedMethod(1.0 / 60, false));
    const MethodResult* tiny = find(r, steppedMethod(1e-5, false));
    const MethodResult* careful = find(r, steppedMethod(1e-5, true));
    if (!coarse || !tiny || !careful)
        return {};
    return LabSentence::tr(
               "With a step of 1/60 s the loop hits the pin more than once in %1 of %2 throws; with "
               "1/100000 s still in %3. The overlap shrinks with the step, and so does the way out "
               "of it. Exchanging only when they approach: %4.")
        .arg(percentText(1 - coarse->sameOrder))
        .arg(tiny->cases)
        .arg(percentText(1 - tiny->sameOrder), percentText(1 - careful->sameOrder));
}

QString smallerStep(const LabResult& r) {
    const MethodResult* exact = find(r, eventMethod());
    const MethodResult* coarse = find(r, steppedMethod(1.0 / 60, false));
    const MethodResult* tiny = find(r, steppedMethod(1.0 / 10'000, false));
    const MethodResult* careful = find(r, steppedMethod(1.0 / 10'000, true));
    if (!exact || !coarse || !tiny || !careful)
        return {};
    QString text =
        LabSentence::tr("From 1/60 s to 1/10000 s the paper's loop goes from %1 to %2 of the throws with the "
                        "right pins touched.")
            .arg(percentText(coarse->sameTouched), percentText(tiny->sameTouched));
    if (tiny->costRounds > 0 && coarse->costRounds > 0)
        text +=
            ' ' +
            LabSentence::tr("It costs %1 times as much.").arg(times(tiny->cost.median / coarse->cost.median));
    text += ' ' + LabSentence::tr("Exchanging only when they approach: %1. From contact to contact: %2")
                      .arg(percentText(careful->sameTouched), percentText(exact->sameTouched));
    if (exact->costRounds > 0)
        text += LabSentence::tr(", in %1 a throw").arg(costText(exact->cost.median));
    return text + '.';
}

QString floatEnough(const LabResult& r) {
    const MethodResult* single = find(r, eventMethod(Precision::Float));
    const MethodResult* usual = find(r, eventMethod());
    if (!single || !usual)
        return {};
    const QString counts =
        single->sameTouched == 1
            ? LabSentence::tr("For the question which pins are touched, yes: the same in all of %1 throws.")
            : LabSentence::tr("Not always: the same pins are touched in %2 of %1 throws.");
    QString text = counts.arg(single->cases);
    if (single->sameTouched < 1)
        text = text.arg(percentText(single->sameTouched));
    text +=
        ' ' + LabSentence::tr("At the end float is off by %1 in half of them and by up to %3; double by %2.")
                  .arg(lengthText(single->error().median), lengthText(usual->error().median),
                       lengthText(single->error().worst));
    if (single->costRounds > 0 && usual->costRounds > 0)
        text +=
            ' ' + LabSentence::tr("Float takes %1 times the time of double.").arg(times(single->costRatio));
    if (r.ghosts && r.ghosts->all.size() == 2 && r.ghosts->all[0].digits && r.ghosts->all[1].digits)
        text += ' ' + LabSentence::tr("Digits left after the last contact of the throw below: %1 and %2.")
                          .arg(QString::number(*r.ghosts->all[1].digits, 'f', 1),
                               QString::number(*r.ghosts->all[0].digits, 'f', 1));
    return text;
}

QString friction(const LabResult& r) {
    const MethodResult* all = find(r, eventMethod());
    const MethodResult* none = find(r, without(Model::Friction));
    if (!all || !none)
        return {};
    QString text = LabSentence::tr("Leaving out friction changes which pins fall in %1 of %2 throws.")
                       .arg(percentText(1 - none->sameDown))
                       .arg(none->cases);
    if (all->costRounds > 0 && none->costRounds > 0)
        text = LabSentence::tr("Friction takes %1 of the time: %2 a throw with it, %3 without.")
                   .arg(percentText(std::max(0.0, 1 - none->cost.median / all->cost.median)),
                        costText(all->cost.median), costText(none->cost.median)) +
               ' ' + text;
    const MethodResult* least = nullptr;
    for (const MethodResult& m : r.study.methods)
        if (!m.method.without.empty() && m.cases > 0 && (!least || m.sameDown > least->sameDown))
            least = &m;
    if (least && least != none)
        text += ' ' + LabSentence::tr("What matters least is %1: %2.")
                          .arg(modelText(least->method.without.front()), percentText(1 - least->sameDown));
    return text;
}

QString butterfly(const LabResult& r) {
    const MethodResult& micro = r.study.methods[1];
    if (micro.cases == 0)
        return {};
    const double shift = r.plan->shifts[1];
    return LabSentence::tr(
               "%1 to the left becomes %2 in half of the throws after %3 s, and %4 in the worst: %5 "
               "times as much. Other pins fall in %6 of %7 throws; with %8 to the left, in %9.")
        .arg(shiftText(shift), lengthText(micro.error().median), numberText(r.study.until, 3),
             lengthText(micro.error().worst), times(micro.error().worst / shift),
             percentText(1 - micro.sameDown))
        .arg(micro.cases)
        .arg(shiftText(r.plan->shifts[2]), percentText(1 - r.study.methods[2].sameDown));
}

QString own(const LabResult& r) {
    const MethodResult* best = nullptr;
    const MethodResult* worst = nullptr;
    for (const MethodResult& m : r.study.methods) {
        if (m.cases == 0 || m.method == r.study.truth)
            continue;
        if (!best || m.error().median < best->error().median)
            best = &m;
        if (!worst || m.error().median > worst->error().median)
            worst = &m;
    }
    if (!best || best == worst)
        return {};
    return LabSentence::tr(
               "After %1 s the nearest to the truth is %2 (off by %3), the furthest %4 (off by %5).")
        .arg(numberText(r.study.until, 3), methodText(best->method), lengthText(best->error().median),
             methodText(worst->method), lengthText(worst->error().median));
}

} // namespace

QString labSentence(const LabResult& result) {
    if (!result.plan->preset)
        return own(result);
    switch (*result.plan->preset) {
    case Preset::Through:
        return through(result);
    case Preset::Twice:
        return twice(result);
    case Preset::SmallerStep:
        return smallerStep(result);
    case Preset::Float:
        return floatEnough(result);
    case Preset::Friction:
        return friction(result);
    case Preset::Butterfly:
        break;
    }
    return butterfly(result);
}

} // namespace thetalane
