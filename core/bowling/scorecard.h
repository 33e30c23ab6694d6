// Ten-pin scoring: USBC's traditional rules, and World Bowling's current-frame rules. A value built from its
// deliveries, one after the other; nothing else is kept that could disagree with them.
#pragma once

#include "core/scene/bowling_scene.h"

#include <optional>
#include <span>
#include <vector>

namespace thetalane {

// Traditional: a strike adds the next two deliveries, a spare the next one, and the tenth frame has the fill
// balls that this takes. CurrentFrame: a strike is 30, a spare 10 and its first ball, an open frame its pins;
// no fill balls.
enum class ScoringRules { Traditional, CurrentFrame };

inline constexpr int framesOfAGame = 10;
inline constexpr int pinsOfARack = 10;

struct Delivery {
    int pins = 0;                 // that went down; those of a foul do not count and are set up again
    std::optional<PinSet> down{}; // which, where that is known
    bool foul = false;
    bool corrected = false; // put right by hand afterwards

    friend bool operator==(const Delivery&, const Delivery&) = default;
};

inline int countedPins(const Delivery& d) {
    return d.foul ? 0 : d.pins;
}

// What a delivery meets. Frames and balls count from 1.
struct Turn {
    int frame = 1;
    int ball = 1;
    int standing = pinsOfARack;           // how many
    std::optional<PinSet> pins = allPins; // which, unless an earlier delivery told only its count
    bool firstOnRack = true;              // so that all ten are a strike; else, also after a foul, a spare
};

struct ScoredDelivery {
    Delivery delivery;
    Turn turn;
    bool strike = false;
    bool spare = false;
    bool split = false; // its first ball left one; never where only a count is known
};

enum class FrameMark { Unfinished, Open, Spare, Strike };

struct FrameScore {
    int first = 0; // its deliveries: from this one on
    int count = 0; // so many
    bool complete = false;
    FrameMark mark = FrameMark::Unfinished; // in the tenth, of its first rack
    bool split = false;                     // left by its first ball
    bool corrected = false;
    std::optional<int> points{}; // with the bonus; nothing while that is open
    std::optional<int> total{};  // of the game up to this frame
};

// GameOver: also of a corrected frame that is over before.
enum class DeliveryFault { NegativePins, MoreThanStand, PinNotStanding, CountDiffers, GameOver };

struct DeliveryError {
    DeliveryFault fault{};
    Turn turn;    // at which
    int pins = 0; // of the delivery; PinNotStanding: the first such pin's number
};

class Scorecard {
public:
    explicit Scorecard(ScoringRules rules = ScoringRules::Traditional)
        : m_rules(rules) {}

    ScoringRules rules() const { return m_rules; }

    // Who fits the turn is taken; otherwise nothing changes.
    std::optional<DeliveryError> add(const Delivery& delivery);
    std::optional<DeliveryError> errorOf(const Delivery& delivery) const;

    std::span<const ScoredDelivery> deliveries() const { return m_deliveries; }
    std::span<const FrameScore> frames() const { return m_frames; } // those begun

    std::optional<Turn> next() const; // nothing once the game is over
    bool complete() const { return !next(); }
    std::optional<int> total() const; // of a complete game
    int runningTotal() const;         // of the frames that can be scored
    int highestPossible() const;      // with every delivery to come taking all that stands

    // Fill balls count, so that a perfect game has twelve.
    int strikes() const;
    int strikesInARow() const; // up to the last delivery: 2 a double, 3 a turkey
    int spares() const;
    int opens() const; // frames
    int splits() const;
    bool perfect() const { return total() == 300; }

private:
    void score();

    ScoringRules m_rules;
    std::vector<ScoredDelivery> m_deliveries;
    std::vector<FrameScore> m_frames;
};

// USBC rule 2h: the head pin is down, and at least one pin is down between two or more that stand (7-9,
// 3-10), or just ahead of them (5-6). Between: in the way of the line from one to the other, or so that no
// standing pin joins the two from row to row.
bool isSplit(const PinSet& standing);

} // namespace thetalane
