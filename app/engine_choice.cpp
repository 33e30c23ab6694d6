#include "app/engine_choice.h"

#include "app/options.h"
#include "core/study/choose_method.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdio>

namespace thetalane {
namespace {

struct EngineChoiceText {
    Q_DECLARE_TR_FUNCTIONS(EngineChoiceText)
};

void say(const QString& line) {
    const QByteArray bytes = (line + '\n').toUtf8();
    std::fwrite(bytes.constData(), 1, std::size_t(bytes.size()), stderr);
}

QString metres(double value) {
    return numberText(value, 2) + " m";
}

void tellWhy(const Choice& choice) {
    say("auto: " + (choice.met ? EngineChoiceText::tr("%1 is the cheapest that stays within %2")
                                     .arg(methodText(choice.method), metres(choice.tolerance))
                               : EngineChoiceText::tr("nothing stays within %2; %1 comes nearest")
                                     .arg(methodText(choice.method), metres(choice.tolerance))));
    for (const TriedMethod& t : choice.tried)
        say("  " + (t.tooSlow ? EngineChoiceText::tr("%1: about %2, too dear to be tried")
                                    .arg(methodText(t.method), costText(t.cost))
                              : EngineChoiceText::tr("%1: %2, off by at most %3")
                                    .arg(methodText(t.method), costText(t.cost), metres(t.error))));
    say("  " +
        EngineChoiceText::tr("measured until %1 s against %2, in %3 s")
            .arg(numberText(choice.until), precisionText(choice.reference), numberText(choice.seconds, 2)));
    if (choice.until < choice.untilAsked)
        say("  " +
            EngineChoiceText::tr("not until %1 s, which would have taken too long: what comes later was "
                                 "not measured, so %2 was asked for")
                .arg(numberText(choice.untilAsked), metres(choice.tolerance * roomToGrow)));
    if (choice.reference != Precision::Quad)
        say("  " + EngineChoiceText::tr("too many bodies for 113 bits: what is measured is the distance from "
                                        "the next-event engine in double"));
}

} // namespace

void takeTolerance(Arguments& a) {
    a.takesValue(
        "tolerance", "M",
        EngineChoiceText::tr("with --engine auto: the cheapest engine, step and precision that keeps "
                             "every body within so many metres of where it should be, found by "
                             "measuring them on this scene"));
}

void checkTolerance(Arguments& a) {
    if (!a.has("tolerance"))
        return;
    (void)a.number("tolerance", 1, positive);
    if (a.value("engine") != "auto")
        a.note("--tolerance: " +
               EngineChoiceText::tr("only with --engine auto; choose it, or leave this out"));
    if (a.has("precision"))
        a.note("--precision: " + EngineChoiceText::tr("is chosen by --tolerance; leave one of the two out"));
}

EngineSettings chosenSettings(Arguments& a, const EngineSettings& settings, const Scene& scene) {
    if (!a.has("tolerance"))
        return settings;
    const auto choice = chooseMethod(scene, a.number("tolerance", 1, positive), settings.until);
    if (!choice)
        return settings;
    tellWhy(*choice);
    EngineSettings chosen = settingsFor(choice->method, settings.until, settings.keepDetail);
    chosen.maxCollisions = settings.maxCollisions;
    chosen.contactTime = settings.contactTime;
    chosen.ties = settings.ties;
    return chosen;
}

} // namespace thetalane
