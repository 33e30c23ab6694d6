#include "ui/lab/lab_plan.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double patience = 1.5; // for one run [s]

int counted(int usual, double share) {
    return std::max(2, int(std::lround(usual * share)));
}

// A ball that comes straight at one pin. Its way to the contact differs from case to case by parts of
// `spread`, evenly, so that every place within a step comes up alike.
StudyCases ballAtPin(int count, double speed, double restitution, double spread) {
    namespace r = regulation;
    constexpr double before = 0.5, golden = 0.6180339887498949;
    StudyCases cases;
    cases.until = (before + spread + 1) / speed;
    for (int k = 0; k < count; ++k) {
        const double part = std::fmod(0.5 + golden * k, 1.0);
        Scene scene = rackScene(0, 0, speed, restitution);
        scene.bodies.resize(2); // the ball and the head pin
        scene.bodies[0].position = {0, -(r::ballRadius + r::pinRadius + before + part * spread)};
        scene.bodies[0].velocity = {0, speed};
        cases.scenes.push_back(std::move(scene));
    }
    return cases;
}

StudyOptions briefly(std::vector<Method> methods) {
    StudyOptions options;
    options.methods = std::move(methods);
    options.costRounds = 5;
    options.patience = patience;
    return options;
}

std::size_t rowOf(const LabPlan& plan, const Method& method) {
    const auto& all = plan.options.methods;
    return std::size_t(std::find(all.begin(), all.end(), method) - all.begin());
}

// The step of the dial among others about it, so that a curve can be drawn.
void through(LabPlan& plan, double share) {
    const LabDials& d = plan.dials;
    std::vector<Method> methods{eventMethod()};
    std::vector<double> ways; // v·h of each
    for (const double part : {0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0, 4.5, 6.0})
        ways.push_back(part * wayThrough());
    ways.push_back(d.wayOfAStep());
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    for (const double way : ways)
        methods.push_back(steppedMethod(way == d.wayOfAStep() ? d.step() : way / d.speed, false));
    methods.push_back(sweptMethod(d.step(), 1));
    plan.cases = ballAtPin(counted(400, share), d.speed, 0.75, 6 * std::max(wayThrough(), d.wayOfAStep()));
    plan.options = briefly(std::move(methods));
    plan.teller = rowOf(plan, steppedMethod(d.step(), false));
    plan.ghosts = {plan.teller, plan.rows() - 1};
}

void twice(LabPlan& plan, double share) {
    std::vector<Method> methods{eventMethod()};
    for (const bool approachingOnly : {false, true})
        for (const double n : {60, 240, 1000, 10'000, 100'000})
            methods.push_back(steppedMethod(1 / n, approachingOnly));
    plan.cases = ballAtPin(counted(200, share), 6.8, 0.75, 0.2);
    plan.options = briefly(std::move(methods));
    plan.teller = rowOf(plan, steppedMethod(1e-5, false));
    plan.ghosts = {plan.teller, rowOf(plan, steppedMethod(1e-5, true))};
    plan.tolerance = 1e-2;
}

void smallerStep(LabPlan& plan, double share) {
    std::vector<Method> methods{eventMethod()};
    for (const bool approachingOnly : {false, true})
        for (const double n : {60, 240, 1000, 10'000})
            methods.push_back(steppedMethod(1 / n, approachingOnly));
    for (const double n : {60, 240, 1000, 10'000})
        methods.push_back(sweptMethod(1 / n, 1));
    plan.cases = rackThrows(counted(20, share));
    plan.options = briefly(std::move(methods));
    plan.options.costRounds = 1;
    plan.teller = rowOf(plan, steppedMethod(1.0 / 10'000, false));
    plan.ghosts = {plan.teller, rowOf(plan, steppedMethod(1.0 / 10'000, true)),
                   rowOf(plan, sweptMethod(1.0 / 60, 1))};
    plan.tolerance = 1e-2;
}

void floatEnough(LabPlan& plan, double share) {
    plan.cases = rackThrows(counted(300, share));
    plan.options = briefly({eventMethod(), eventMethod(Precision::Float), referenceMethod()});
    plan.teller = 1;
    plan.ghosts = {0, 1};
    plan.tolerance = 1e-4;
}

void friction(LabPlan& plan, double share) {
    plan.cases = laneThrows(counted(24, share));
    plan.options = ablationStudy(plan.cases.scenes.front());
    plan.options.costRounds = 5;
    plan.options.patience = patience;
    plan.teller = 1;
    for (std::size_t row = 1; row < std::min<std::size_t>(plan.rows(), 4); ++row)
        plan.ghosts.push_back(row);
    plan.tolerance = 1e-2;
}

void butterfly(LabPlan& plan, double share) {
    plan.cases = rackThrows(counted(80, share));
    plan.options = briefly({referenceMethod()});
    plan.shifts = {1e-9, 1e-6, 1e-3};
    plan.teller = 1;
    plan.ghosts = {0, 1, 2};
    plan.tolerance = 2e-3;
}

} // namespace

double wayThrough() {
    return 2 * (regulation::ballRadius + regulation::pinRadius);
}

LabPlan presetPlan(Preset preset, const LabDials& dials, double share) {
    LabPlan plan;
    plan.preset = preset;
    plan.dials = dials;
    switch (preset) {
    case Preset::Through:
        through(plan, share);
        break;
    case Preset::Twice:
        twice(plan, share);
        break;
    case Preset::SmallerStep:
        smallerStep(plan, share);
        break;
    case Preset::Float:
        floatEnough(plan, share);
        break;
    case Preset::Friction:
        friction(plan, share);
        break;
    case Preset::Butterfly:
        butterfly(plan, share);
        break;
    }
    return plan;
}

LabPlan ownPlan(Scene scene, double until, std::vector<Method> methods) {
    LabPlan plan;
    plan.cases = oneScene(std::move(scene), until);
    plan.options = briefly(std::move(methods));
    for (std::size_t row = 0; row < plan.rows(); ++row)
        if (!isReference(plan.options.methods[row]))
            plan.ghosts.push_back(row);
    return plan;
}

std::vector<Method> ownMethods(const Scene& scene) {
    std::vector<Method> methods{eventMethod(), eventMethod(Precision::Float), steppedMethod(1.0 / 60, false),
                                sweptMethod(1.0 / 60, 1), referenceMethod()};
    for (const double n : {240, 1000, 10'000})
        methods.push_back(steppedMethod(1 / n, false));
    for (const double n : {60, 240, 1000, 10'000})
        methods.push_back(steppedMethod(1 / n, true));
    for (const double n : {240, 1000, 10'000})
        methods.push_back(sweptMethod(1 / n, 1));
    methods.push_back(sweptMethod(1.0 / 60, 4));
    for (const Method& m : ablationMethods(scene))
        if (!m.without.empty())
            methods.push_back(m);
    return methods;
}

} // namespace thetalane
