#include "app/engine_options.h"

#include "app/options.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>

namespace thetalane {
namespace {

struct EngineOptionsText {
    Q_DECLARE_TR_FUNCTIONS(EngineOptionsText)
};

constexpr std::string_view engineWords[] = {"event", "stepped", "auto"};
constexpr std::string_view precisionWords[] = {"float", "double", "quad"};

// An option that the engine would leave unread is a mistake worth telling.
void needsEvent(Arguments& arguments, const QString& option) {
    if (arguments.has(option))
        arguments.note(
            "--" + option + ": " +
            EngineOptionsText::tr("the stepped engine does not take this; leave one of the two out"));
}

void needsStepped(Arguments& arguments, const QString& option) {
    if (arguments.has(option))
        arguments.note("--" + option + ": " +
                       EngineOptionsText::tr("only the stepped engine takes this; add --engine stepped"));
}

QString optionOf(RefusalReason reason) {
    switch (reason) {
    case RefusalReason::UntilNotPositive:
        return "--until";
    case RefusalReason::StepNotPositive:
    case RefusalReason::TooManySteps:
        return "--step";
    case RefusalReason::MaxCollisionsNotPositive:
        return "--max-collisions";
    }
    return {};
}

} // namespace

void takeEngineOptions(Arguments& a) {
    a.takesValue("until", "S", EngineOptionsText::tr("the time to run [s]; 10 unless said"));
    a.takesValue("max-collisions", "N",
                 EngineOptionsText::tr("ends the run after N collisions; 1000000 unless said"));
    a.takesValue(
        "engine", "event|stepped|auto",
        EngineOptionsText::tr("event: from contact to contact; stepped: the paper's loop; auto: event"));
    a.takesValue("step", "S", EngineOptionsText::tr("the step of the stepped engine [s]; 1/60 unless said"));
    a.takesFlag("approaching-only", EngineOptionsText::tr("stepped: exchanges only when the two approach"));
    a.takesValue("precision", "float|double|quad",
                 EngineOptionsText::tr("the engine's numbers; double unless said"));
    a.takesValue("contact-time", "S",
                 EngineOptionsText::tr("bodies that friction presses together stay in touch when they would "
                                       "meet again sooner [s]; 0.0001 unless said"));
}

EngineSettings engineSettings(Arguments& a) {
    EngineSettings s;
    s.kind = a.choice("engine", 0, engineWords) == 1 ? EngineKind::Stepped : EngineKind::Event;
    s.precision = Precision(a.choice("precision", int(s.precision), precisionWords));
    s.until = a.number("until", s.until, positive);
    s.maxCollisions = a.count("max-collisions", s.maxCollisions);
    s.step = a.number("step", s.step, positive);
    s.approachingOnly = a.has("approaching-only");
    s.contactTime = a.number("contact-time", s.contactTime, positive);
    if (s.kind == EngineKind::Event) {
        needsStepped(a, "step");
        needsStepped(a, "approaching-only");
    } else {
        needsEvent(a, "contact-time");
    }
    return s;
}

std::variant<Run, QString> simulateOrTell(Scene scene, const EngineSettings& settings) {
    auto outcome = simulate(std::move(scene), settings);
    if (const auto* refusal = std::get_if<Refusal>(&outcome))
        return optionOf(refusal->reason) + ": " + refusalMessage(*refusal);
    return std::get<Run>(std::move(outcome));
}

} // namespace thetalane
