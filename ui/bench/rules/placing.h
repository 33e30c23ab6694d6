// Where a body may stand. A body that is put down gives way to what is there already: it stands at the free
// place nearest to the one asked for, inside the walls, touching nothing deeper than rounding. The others
// never move for it. Lengths in metres.
#pragma once

#include "core/scene/scene.h"

#include <optional>
#include <string>

namespace thetalane {

inline constexpr std::size_t mostOnTheBench = 12; // bodies that can be edited by hand

struct Mover {
    double radius = 0;
    int index = -1;               // in the scene; -1: a new one
    std::optional<double> line{}; // the y it must stay on
};

bool isFree(const Scene& scene, const Mover& mover, Vec2d place);

// Nothing where there is no room at all.
std::optional<Vec2d> freePlaceNear(const Scene& scene, const Mover& mover, Vec2d wanted);

// The y of one line along x that everything is on and moves along, if there is one.
std::optional<double> lineOf(const Scene& scene);

// All bodies on one line, in the order of their x, moved no more than needed to be free of each other and the
// walls; their velocities along it only. Nothing where they do not all fit.
std::optional<Scene> linedUp(const Scene& scene);

// One body more, at rest, near the middle, with room around it where there is any. Nothing where there is no
// room, or the bench is full.
std::optional<Scene> withOneMore(const Scene& scene, std::optional<double> line);
Scene without(Scene scene, std::size_t body);

// The mass, and what goes with it; see EditOptions::constantSize().
void setMass(Body& body, double mass, bool constantSize);

// A wall where none was: beyond everything, at a round place.
double placeForWall(const Scene& scene, Side side);

// What a new scene starts with: two equal balls between four walls, one on its way to the other.
Scene newScene();

// Twelve digits: 0.1 + 0.2 is to be 0.3.
double tidy(double value);

} // namespace thetalane
