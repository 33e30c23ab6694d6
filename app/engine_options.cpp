#include "app/engine_options.h"

#include "app/options.h"
#include "core/format/run_names.h"
#include "ui/words/scene_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <initializer_list>

namespace thetalane {
namespace {

struct EngineOptionsText {
    Q_DECLARE_TR_FUNCTIONS(EngineOptionsText)
};

constexpr std::string_view engineWords[] = {"event", "swept", "stepped", "auto"};
constexpr EngineKind engines[] = {EngineKind::Event, EngineKind::Swept, EngineKind::Stepped,
                                  EngineKind::Event};
constexpr std::string_view precisionWords[] = {"float", "double", "quad"};
constexpr qint64 mostPasses = 1'000'000;

// An option that the engine would leave unread is a mistake worth telling.
void takenOnlyBy(std::initializer_list<EngineKind> kinds, const QString& option, EngineKind kind,
                 Arguments& arguments) {
    if (!arguments.has(option) || std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
        return;
    QStringList names;
    for (const EngineKind k : kinds)
        names << fileName(k);
    arguments.note(
        "--" + option + ": " +
        EngineOptionsText::tr("only with --engine %1; choose it, or leave this out").arg(names.join('|')));
}

int passes(Arguments& arguments, int unlessSaid) {
    const qint64 asked = arguments.count("passes", unlessSaid);
    if (asked <= mostPasses)
        return int(asked);
    arguments.note("--passes: " +
                   EngineOptionsText::tr("must be at most %1, is %2").arg(mostPasses).arg(asked));
    return unlessSaid;
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
    case RefusalReason::PassesNotPositive:
        return "--passes";
    case RefusalReason::ContactTimeNotPositive:
        return "--contact-time";
    }
    return {};
}

} // namespace

void takeEngineOptions(Arguments& a) {
    a.takesValue("until", "S", EngineOptionsText::tr("the time to run [s]; 10 unless said"));
    a.takesValue("max-collisions", "N",
                 EngineOptionsText::tr("ends the run after N collisions; 1000000 unless said"));
    a.takesValue("engine", "event|swept|stepped|auto",
                 EngineOptionsText::tr("event: from contact to contact; swept: by steps, with the instant of "
                                       "each contact within a step; stepped: the paper's loop; auto: event"));
    a.takesValue("step", "S",
                 EngineOptionsText::tr("the step of the stepped and swept engines [s]; 1/60 unless said"));
    a.takesValue("passes", "N",
                 EngineOptionsText::tr("swept: how often within a step a body is looked at for what it hits "
                                       "next; 1 unless said"));
    a.takesFlag("approaching-only", EngineOptionsText::tr("stepped: exchanges only when the two approach"));
    a.takesFlag("one-at-a-time",
                EngineOptionsText::tr("event: takes contacts of one instant one at a time, not together"));
    a.takesValue("precision", "float|double|quad",
                 EngineOptionsText::tr("the engine's numbers; double unless said"));
    a.takesValue("contact-time", "S",
                 EngineOptionsText::tr("bodies that friction presses together stay in touch when they would "
                                       "meet again sooner [s]; 0.0001 unless said"));
}

EngineSettings engineSettings(Arguments& a) {
    EngineSettings s;
    s.kind = engines[a.choice("engine", 0, engineWords)];
    s.precision = Precision(a.choice("precision", int(s.precision), precisionWords));
    s.until = a.number("until", s.until, positive);
    s.maxCollisions = a.count("max-collisions", s.maxCollisions);
    s.step = a.number("step", s.step, positive);
    s.approachingOnly = a.has("approaching-only");
    s.passes = passes(a, s.passes);
    s.ties = !a.has("one-at-a-time");
    s.contactTime = a.number("contact-time", s.contactTime, positive);
    takenOnlyBy({EngineKind::Stepped, EngineKind::Swept}, "step", s.kind, a);
    takenOnlyBy({EngineKind::Stepped}, "approaching-only", s.kind, a);
    takenOnlyBy({EngineKind::Swept}, "passes", s.kind, a);
    takenOnlyBy({EngineKind::Event}, "one-at-a-time", s.kind, a);
    takenOnlyBy({EngineKind::Event}, "contact-time", s.kind, a);
    return s;
}

std::variant<Run, QString> simulateOrTell(Scene scene, const EngineSettings& settings) {
    auto outcome = simulate(std::move(scene), settings);
    if (const auto* refusal = std::get_if<Refusal>(&outcome))
        return optionOf(refusal->reason) + ": " + refusalMessage(*refusal);
    return std::get<Run>(std::move(outcome));
}

} // namespace thetalane
