#include "core/engine/engine.h"

#include "core/engine/engines.h"

#include <cmath>
#include <optional>

namespace thetalane {
namespace {

std::optional<Refusal> refuse(const EngineSettings& s) {
    if (!std::isfinite(s.until) || s.until <= 0)
        return Refusal{RefusalReason::UntilNotPositive, s.until, 0};
    if (s.maxCollisions <= 0)
        return Refusal{RefusalReason::MaxCollisionsNotPositive, double(s.maxCollisions), 0};
    if (s.kind == EngineKind::Event) {
        if (!std::isfinite(s.contactTime) || s.contactTime <= 0)
            return Refusal{RefusalReason::ContactTimeNotPositive, s.contactTime, 0};
    } else {
        if (!std::isfinite(s.step) || s.step <= 0)
            return Refusal{RefusalReason::StepNotPositive, s.step, 0};
        if (s.until / s.step > maxSteps)
            return Refusal{RefusalReason::TooManySteps, s.until / s.step, maxSteps};
    }
    if (s.kind == EngineKind::Swept && s.passes <= 0)
        return Refusal{RefusalReason::PassesNotPositive, double(s.passes), 0};
    return std::nullopt;
}

Timeline runOn(const Scene& scene, const EngineSettings& settings) {
    switch (settings.kind) {
    case EngineKind::Event:
        return runNextEvent(scene, settings);
    case EngineKind::Stepped:
        return runStepped(scene, settings);
    case EngineKind::Swept:
        break;
    }
    return runSwept(scene, settings);
}

} // namespace

std::variant<Run, Refusal> simulate(Scene scene, const EngineSettings& settings) {
    if (const auto refusal = refuse(settings))
        return *refusal;
    Timeline timeline = runOn(scene, settings);
    return Run{std::move(scene), settings, std::move(timeline)};
}

} // namespace thetalane
