// How surely a hand lets go of the ball: what is aimed at and what is thrown differ by chance, drawn from a
// seed, so that the same game can be thrown again.
#pragma once

#include "core/scene/bowling_scene.h"

#include <array>
#include <cstdint>

namespace thetalane {

enum class Release { None, Steady, League, Beginner };
inline constexpr std::array releases{Release::None, Release::Steady, Release::League, Release::Beginner};

// Standard deviations. Guesses, all of them: nobody could be found to have measured them. A degree aside is
// 32 cm at the head pin, and the strip of positions that strike is 1.5 to 4 cm wide.
struct ReleaseSpread {
    double speed = 0;     // m/s
    double direction = 0; // rad
    double position = 0;  // m
    double spin = 0;      // as a part of the spin that was meant
};

ReleaseSpread spreadOf(Release release);

// The throw that comes of an aim. The same for the same seed, player and delivery (from 0), so that undoing a
// delivery is no second chance.
Throw released(Throw aim, Release release, std::uint32_t seed, std::size_t player, std::size_t delivery);

} // namespace thetalane
