// What is drawn on the lane for one stage of a collision: values in metres, made of PairCollision's numbers.
#pragma once

#include "core/timeline/timeline.h"
#include "ui/words/worked_steps.h"

#include <QString>

#include <optional>
#include <vector>

namespace thetalane {

// v with the subscript Ax′, and what follows: " = 0.9407 m/s".
struct OverlayLabel {
    QString symbol; // italic
    QString sub;
    QString text;
};

// The velocities of a body on the lane; an arrow keeps its part from stage to stage, and turns into the next.
enum class ArrowPart { Velocity, FirstComponent, SecondComponent, Before };

struct OverlayArrow {
    int body = 0; // 0: the collision's first, 1: its second
    ArrowPart part = ArrowPart::Velocity;
    Vec2d from;
    Vec2d to;
    Ink ink = Ink::Plain;
    bool bold = true;
    bool dashed = false; // across y′: an open head too
    double opacity = 1;
    double shift = 0; // to the side, in widths: beside the arrow it is compared with
    OverlayLabel label{};
};

struct OverlayLine {
    Vec2d from;
    Vec2d to;
    Ink ink = Ink::Plain;
    bool bold = false;
    bool dashed = false;
    OverlayLabel label{};
    bool labelAtEnd = false; // as an axis has it; else in the middle
};

// Counter-clockwise from the x axis, as θ is.
struct OverlayArc {
    Vec2d centre;
    double radius = 0; // [m]
    double angle = 0;  // [rad]
    OverlayLabel label{};
};

struct OverlayDisc {
    Vec2d centre;
    double radius = 0; // [m]
    QString name;
    Ink ink = Ink::Plain;
};

struct StepOverlay {
    std::vector<OverlayArrow> arrows;
    std::vector<OverlayLine> lines;
    std::vector<OverlayArc> arcs;
    std::vector<OverlayDisc> discs;
    Vec2d contact;             // where the two touch
    std::optional<Side> wall;  // the wall that was hit
    double metresPerSpeed = 0; // the length of 1 m/s: one scale for the whole collision
};

StepOverlay stepOverlay(const Scene& scene, const Collision& collision, Stage stage);

// Half the width of the square around the contact that the overlay fills a good part of [m].
double overlayReach(const Collision& collision);

// On the way from one stage to the next, t from 0 to 1: arrows of the same part turn, new ones appear.
StepOverlay between(const StepOverlay& from, const StepOverlay& to, double t);

} // namespace thetalane
