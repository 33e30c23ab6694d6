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
    if (s.kind == EngineKind::Stepped) {
        if (!std::isfinite(s.step) || s.step <= 0)
            return Refusal{RefusalReason::StepNotPositive, s.step, 0};
        if (s.until / s.step > maxSteps)
            return Refusal{RefusalReason::TooManySteps, s.until / s.step, maxSteps};
    }
    return std::nullopt;
}

} // namespace

std::variant<Run, Refusal> simulate(Scene scene, const EngineSettings& settings) {
    if (const auto refusal = refuse(settings))
        return *refusal;
    Timeline timeline =
        settings.kind == EngineKind::Event ? runNextEvent(scene, settings) : runStepped(scene, settings);
    return Run{std::move(scene), settings, std::move(timeline)};
}

} // namespace thetalane
