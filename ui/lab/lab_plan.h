// What the lab is asked: a preset that makes one point, or a scene with methods of the user's choice.
#pragma once

#include "core/study/study.h"

#include <optional>
#include <vector>

namespace thetalane {

enum class Preset {
    Through,     // a coarse step skips through a pin
    Twice,       // the paper's loop exchanges one contact again and again, however small the step
    SmallerStep, // and so it does not converge
    Float,       // what 24 bits are good for
    Friction,    // what a model costs, and what its absence changes
    Butterfly,   // the same throw, a little to the left
};
inline constexpr int presetCount = 6;

// Of the preset Through.
struct LabDials {
    double speed = 20;     // of the ball [m/s]
    double perSecond = 30; // steps

    double step() const { return 1 / perSecond; }
    double wayOfAStep() const { return speed / perSecond; } // v·h [m]
    friend bool operator==(const LabDials&, const LabDials&) = default;
};

struct LabPlan {
    std::optional<Preset> preset; // nothing: a scene of the user's own
    LabDials dials;
    StudyCases cases;
    StudyOptions options;
    // How far to the left the ball starts [m], a row each, instead of methods of options.
    std::vector<double> shifts;
    std::vector<std::size_t> ghosts; // rows that are drawn over the lane
    std::size_t teller = 0;          // drawn is the first case that comes out otherwise in this row
    double tolerance = 1e-3;         // off by more than this, a ghost has left the truth [m]

    std::size_t rows() const { return shifts.empty() ? options.methods.size() : shifts.size(); }
};

// share: of the usual number of cases; tests take fewer.
LabPlan presetPlan(Preset preset, const LabDials& dials = {}, double share = 1);
LabPlan ownPlan(Scene scene, double until, std::vector<Method> methods);

// What may be chosen for a scene, the first few of them at the start.
std::vector<Method> ownMethods(const Scene& scene);
inline constexpr std::size_t chosenAtFirst = 4;

// The longest way on which a ball overlaps the pin it meets head-on: 2(r₁ + r₂) [m].
double wayThrough();

} // namespace thetalane
