// Rolls as they are written on a score sheet: "X 9/ 72 F9 9- … XX8". X strike, / spare, a digit from 1 to 9,
// - none, F foul; frames with spaces between them. Several strikes may stand together, and the rolls of the
// tenth frame may be spaced.
#pragma once

#include "core/bowling/scorecard.h"

#include <string>
#include <string_view>
#include <variant>

namespace thetalane {

enum class RollFault {
    UnknownSymbol,  // text: the symbol
    Zero,           // written -
    StrikeNotFirst, // X where pins of the rack are down, or after a miss: a spare is written /
    SpareFirst,     // / at a fresh rack: a strike is written X
    MorePins,       // than stand; text: the roll, standing
    SpareAsDigits,  // 5 and 5: written 5/
    FrameGoesOn,    // a space before the frame's second roll; text: the frame so far
    FrameIsOver,    // text: what stands together, without a space between two frames
    GameOver,       // text: the roll that is too many
};

struct RollError {
    RollFault fault{};
    int frame = 1;
    std::string text{};
    int standing = 0;  // pins, where the roll went wrong
    int firstBall = 0; // SpareAsDigits: the pins of the ball before
};

// The scorecard of these rolls; an unfinished game is none of the faults.
std::variant<Scorecard, RollError> readRolls(std::string_view text, ScoringRules rules);

// One delivery as it is written: X / - F 1 to 9.
char symbolOf(const ScoredDelivery& delivery);

// A frame's rolls, together: "X", "9/", "XX8". frame: index into card.frames().
std::string rollsText(const Scorecard& card, std::size_t frame);

} // namespace thetalane
