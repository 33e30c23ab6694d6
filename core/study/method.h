// One way to compute a scene: an engine with its settings, and which models of the scene are left out.
#pragma once

#include "core/engine/engine.h"

#include <optional>
#include <vector>

namespace thetalane {

// What can be left out, to see what it costs and what its absence changes.
enum class Model {
    Friction,        // of the floor: nothing slows, no oil, spin means nothing
    Spin,            // of the balls: they start without
    Oil,             // the whole lane is dry
    Restitution,     // collisions between bodies lose nothing, e = 1, as in the paper
    WallRestitution, // walls and kickbacks throw back with e = 1
    Ties,            // contacts at one instant are taken one after the other
};

struct Method {
    // Of these the study sets until, maxCollisions and keepDetail itself.
    EngineSettings settings;
    std::vector<Model> without{};

    friend bool operator==(const Method&, const Method&) = default;
};

Method eventMethod(Precision precision = Precision::Double);
Method steppedMethod(double step, bool approachingOnly);
Method sweptMethod(double step, int passes);
Method without(Model model); // event, double

// Next-event with 113 bits: what all others are held against.
Method referenceMethod();
bool isReference(const Method& method);

enum class MethodSet {
    Quick,    // a few, for the first look
    Standard, // steps down to 1/1000 s
    All,      // and down to 1/100,000 s: minutes for 4,000 throws
};
// The first is event in double, to which costs are compared; the second is the reference.
std::vector<Method> studyMethods(MethodSet set);

// Event in double with all models, then with one left out each, of those that the scene has.
std::vector<Method> ablationMethods(const Scene& scene);
bool hasModel(const Scene& scene, Model model);

// The scene without the models that the method leaves out, and the settings to run it with.
Scene sceneFor(const Method& method, Scene scene);
EngineSettings settingsFor(const Method& method, double until, bool detail = true);

// Why the engine would not run it, found out without a whole run.
std::optional<Refusal> refusalOf(const Method& method, const Scene& scene, double until);

// Detail: with the list of collisions. The run, or why the engine will not run it.
std::variant<Run, Refusal> runMethod(const Method& method, const Scene& scene, double until,
                                     bool detail = true);

} // namespace thetalane
