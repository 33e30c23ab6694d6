#include "core/study/method.h"

#include <algorithm>

namespace thetalane {
namespace {

bool leavesOut(const Method& method, Model model) {
    return std::find(method.without.begin(), method.without.end(), model) != method.without.end();
}

bool anyBody(const Scene& scene, bool (*asked)(const Body&)) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), asked);
}

bool spins(const Body& b) {
    return b.kind == BodyKind::Ball && (b.spin.x != 0 || b.spin.y != 0 || b.spin.z != 0);
}

constexpr int severalPasses = 4;

void addSteps(std::vector<Method>& methods, std::initializer_list<double> perSecond) {
    for (const bool approachingOnly : {false, true})
        for (const double n : perSecond)
            methods.push_back(steppedMethod(1 / n, approachingOnly));
    for (const int passes : {1, severalPasses})
        for (const double n : perSecond)
            methods.push_back(sweptMethod(1 / n, passes));
}

constexpr Model models[] = {Model::Friction,        Model::Spin, Model::Oil, Model::Restitution,
                            Model::WallRestitution, Model::Ties};

// With e = 1, as the paper has it.
void addPapersLoop(std::vector<Method>& methods, std::initializer_list<double> perSecond) {
    for (const double n : perSecond) {
        methods.push_back(steppedMethod(1 / n, false));
        methods.back().without = {Model::Restitution};
    }
}

} // namespace

Method eventMethod(Precision precision) {
    Method m;
    m.settings.kind = EngineKind::Event;
    m.settings.precision = precision;
    return m;
}

Method steppedMethod(double step, bool approachingOnly) {
    Method m;
    m.settings.kind = EngineKind::Stepped;
    m.settings.step = step;
    m.settings.approachingOnly = approachingOnly;
    return m;
}

Method sweptMethod(double step, int passes) {
    Method m;
    m.settings.kind = EngineKind::Swept;
    m.settings.step = step;
    m.settings.passes = passes;
    return m;
}

Method without(Model model) {
    Method m = eventMethod();
    m.without = {model};
    return m;
}

Method referenceMethod() {
    return eventMethod(Precision::Quad);
}

bool isReference(const Method& method) {
    return method.settings.kind == EngineKind::Event && method.settings.precision == Precision::Quad &&
           method.without.empty();
}

std::vector<Method> studyMethods(MethodSet set) {
    std::vector<Method> methods{eventMethod(), referenceMethod(), eventMethod(Precision::Float)};
    switch (set) {
    case MethodSet::Quick:
        addSteps(methods, {60, 240});
        break;
    case MethodSet::Standard:
        addSteps(methods, {30, 60, 120, 240, 500, 1000});
        addPapersLoop(methods, {60, 1000});
        break;
    case MethodSet::All:
        addSteps(methods, {30, 60, 120, 240, 500, 1000, 10'000, 100'000});
        addPapersLoop(methods, {60, 1000, 100'000});
        break;
    }
    return methods;
}

bool hasModel(const Scene& scene, Model model) {
    switch (model) {
    case Model::Friction:
        return scene.friction.has_value();
    case Model::Spin:
        return scene.friction && anyBody(scene, spins);
    case Model::Oil:
        return scene.friction && !scene.friction->oil.empty();
    case Model::Restitution:
        return scene.restitution < 1;
    case Model::WallRestitution:
        return (scene.frame && scene.frame->restitution < 1) ||
               (scene.lane && scene.lane->kickbacks && scene.lane->kickbacks->restitution < 1);
    case Model::Ties:
        return scene.bodies.size() > 2;
    }
    return false;
}

std::vector<Method> ablationMethods(const Scene& scene) {
    std::vector<Method> methods{eventMethod()};
    for (const Model model : models)
        if (hasModel(scene, model))
            methods.push_back(without(model));
    return methods;
}

Scene sceneFor(const Method& method, Scene scene) {
    if (leavesOut(method, Model::Friction))
        scene.friction.reset();
    if (leavesOut(method, Model::Oil) && scene.friction)
        scene.friction->oil.clear();
    if (leavesOut(method, Model::Spin))
        for (Body& b : scene.bodies)
            b.spin = {};
    if (leavesOut(method, Model::Restitution))
        scene.restitution = 1;
    if (leavesOut(method, Model::WallRestitution)) {
        if (scene.frame)
            scene.frame->restitution = 1;
        if (scene.lane && scene.lane->kickbacks)
            scene.lane->kickbacks->restitution = 1;
    }
    return scene;
}

EngineSettings settingsFor(const Method& method, double until, bool detail) {
    EngineSettings settings = method.settings;
    settings.until = until;
    settings.keepDetail = detail;
    settings.ties = settings.ties && !leavesOut(method, Model::Ties);
    return settings;
}

std::optional<Refusal> refusalOf(const Method& method, const Scene& scene, double until) {
    const EngineSettings& s = method.settings;
    double shorter = until; // as short as it can be without another reason
    if (s.kind == EngineKind::Event)
        shorter = std::min(until, 1e-9);
    else if (s.step > 0 && until / s.step > maxSteps)
        return Refusal{RefusalReason::TooManySteps, until / s.step, maxSteps};
    else if (s.step > 0)
        shorter = std::min(until, s.step);
    Scene few = scene;
    few.bodies.resize(std::min<std::size_t>(few.bodies.size(), 1));
    const auto outcome = runMethod(method, few, shorter, false);
    const Refusal* refusal = std::get_if<Refusal>(&outcome);
    return refusal ? std::optional(*refusal) : std::nullopt;
}

std::variant<Run, Refusal> runMethod(const Method& method, const Scene& scene, double until, bool detail) {
    return simulate(sceneFor(method, scene), settingsFor(method, until, detail));
}

} // namespace thetalane
