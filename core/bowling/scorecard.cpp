#include "core/bowling/scorecard.h"

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

Turn freshRack(int frame, int ball) {
    return {frame, ball};
}

// The second ball at a rack: what was left, or after a foul all ten again.
Turn sameRack(const ScoredDelivery& last) {
    Turn turn{last.turn.frame, last.turn.ball + 1};
    turn.firstOnRack = false;
    if (last.delivery.foul)
        return turn;
    turn.standing = last.turn.standing - last.delivery.pins;
    turn.pins.reset();
    if (last.turn.pins && last.delivery.down)
        turn.pins = *last.turn.pins & ~*last.delivery.down;
    else if (last.delivery.pins == 0)
        turn.pins = last.turn.pins;
    return turn;
}

bool clears(const ScoredDelivery& d) {
    return d.strike || d.spare;
}

std::optional<Turn> afterFrame(int frame) {
    return frame == framesOfAGame ? std::nullopt : std::optional(freshRack(frame + 1, 1));
}

// With the fill balls: two after a strike, one after a spare.
std::optional<Turn> inLastFrame(const ScoredDelivery& last, bool beganWithStrike) {
    const int ball = last.turn.ball;
    const bool goesOn = ball == 1 || (ball == 2 && (beganWithStrike || last.spare));
    if (!goesOn)
        return std::nullopt;
    return clears(last) ? freshRack(framesOfAGame, ball + 1) : sameRack(last);
}

FrameMark markOf(std::span<const ScoredDelivery> own, bool complete) {
    if (own[0].strike)
        return FrameMark::Strike;
    if (own.size() > 1 && own[1].spare)
        return FrameMark::Spare;
    return complete ? FrameMark::Open : FrameMark::Unfinished;
}

int sumOf(std::span<const ScoredDelivery> deliveries) {
    int sum = 0;
    for (const ScoredDelivery& d : deliveries)
        sum += countedPins(d.delivery);
    return sum;
}

std::optional<int> currentFramePoints(const FrameScore& frame, std::span<const ScoredDelivery> own) {
    if (!frame.complete)
        return std::nullopt;
    if (frame.mark == FrameMark::Strike)
        return 30;
    return sumOf(own) + (frame.mark == FrameMark::Spare ? countedPins(own[0].delivery) : 0);
}

// `all`: from the frame's first delivery to the game's last.
std::optional<int> traditionalPoints(const FrameScore& frame, int number,
                                     std::span<const ScoredDelivery> all) {
    if (!frame.complete)
        return std::nullopt;
    const bool clearedAway = frame.mark == FrameMark::Strike || frame.mark == FrameMark::Spare;
    const std::size_t counted = number == framesOfAGame ? std::size_t(frame.count)
                                : clearedAway           ? 3
                                                        : 2; // 1 + 2 or 2 + 1
    if (all.size() < counted)
        return std::nullopt;
    return sumOf(all.first(counted));
}

} // namespace

std::optional<Turn> Scorecard::next() const {
    if (m_deliveries.empty())
        return freshRack(1, 1);
    const ScoredDelivery& last = m_deliveries.back();
    if (m_rules == ScoringRules::Traditional && last.turn.frame == framesOfAGame)
        return inLastFrame(last, m_frames.back().mark == FrameMark::Strike);
    if (last.strike || last.turn.ball == 2)
        return afterFrame(last.turn.frame);
    return sameRack(last);
}

std::optional<DeliveryError> Scorecard::errorOf(const Delivery& d) const {
    const auto turn = next();
    if (!turn)
        return DeliveryError{DeliveryFault::GameOver, m_deliveries.back().turn, d.pins};
    if (d.pins < 0)
        return DeliveryError{DeliveryFault::NegativePins, *turn, d.pins};
    if (d.pins > turn->standing)
        return DeliveryError{DeliveryFault::MoreThanStand, *turn, d.pins};
    if (d.down && int(d.down->count()) != d.pins)
        return DeliveryError{DeliveryFault::CountDiffers, *turn, d.pins};
    if (d.down && turn->pins)
        if (const PinSet missing = *d.down & ~*turn->pins; missing.any()) {
            std::size_t k = 0;
            while (!missing[k])
                ++k;
            return DeliveryError{DeliveryFault::PinNotStanding, *turn, int(k) + 1};
        }
    return std::nullopt;
}

std::optional<DeliveryError> Scorecard::add(const Delivery& delivery) {
    if (const auto error = errorOf(delivery))
        return error;
    ScoredDelivery d{delivery, *next()};
    const bool all = !delivery.foul && delivery.pins == d.turn.standing;
    d.strike = all && d.turn.firstOnRack;
    d.spare = all && !d.turn.firstOnRack;
    if (d.turn.firstOnRack && d.turn.pins && delivery.down && !delivery.foul)
        d.split = isSplit(*d.turn.pins & ~*delivery.down);
    m_deliveries.push_back(d);
    score();
    return std::nullopt;
}

// All anew: there are 21 deliveries at most, and each may complete frames before it.
void Scorecard::score() {
    m_frames.clear();
    for (std::size_t k = 0; k < m_deliveries.size(); ++k) {
        if (m_deliveries[k].turn.ball == 1)
            m_frames.push_back({.first = int(k)});
        FrameScore& frame = m_frames.back();
        ++frame.count;
        frame.split |= m_deliveries[k].turn.ball == 1 && m_deliveries[k].split;
        frame.corrected |= m_deliveries[k].delivery.corrected;
        frame.mark = markOf(
            std::span(m_deliveries).subspan(std::size_t(frame.first), std::size_t(frame.count)), false);
    }
    const auto turn = next();
    std::optional<int> total = 0;
    for (std::size_t k = 0; k < m_frames.size(); ++k) {
        FrameScore& frame = m_frames[k];
        const auto all = std::span<const ScoredDelivery>(m_deliveries).subspan(std::size_t(frame.first));
        const auto own = all.first(std::size_t(frame.count));
        frame.complete = !turn || turn->frame != int(k) + 1;
        frame.mark = markOf(own, frame.complete);
        frame.points = m_rules == ScoringRules::Traditional ? traditionalPoints(frame, int(k) + 1, all)
                                                            : currentFramePoints(frame, own);
        if (total && frame.points)
            total = *total + *frame.points;
        else
            total.reset();
        frame.total = total;
    }
}

std::optional<int> Scorecard::total() const {
    return complete() ? m_frames.back().total : std::nullopt;
}

int Scorecard::runningTotal() const {
    int total = 0;
    for (const FrameScore& frame : m_frames)
        total = frame.total.value_or(total);
    return total;
}

int Scorecard::highestPossible() const {
    Scorecard best = *this;
    while (const auto turn = best.next())
        best.add({.pins = turn->standing, .down = turn->pins});
    return best.runningTotal();
}

int Scorecard::strikes() const {
    return int(std::count_if(m_deliveries.begin(), m_deliveries.end(), [](auto& d) { return d.strike; }));
}

int Scorecard::strikesInARow() const {
    const auto end =
        std::find_if(m_deliveries.rbegin(), m_deliveries.rend(), [](auto& d) { return !d.strike; });
    return int(end - m_deliveries.rbegin());
}

int Scorecard::spares() const {
    return int(std::count_if(m_deliveries.begin(), m_deliveries.end(), [](auto& d) { return d.spare; }));
}

int Scorecard::opens() const {
    return int(
        std::count_if(m_frames.begin(), m_frames.end(), [](auto& f) { return f.mark == FrameMark::Open; }));
}

int Scorecard::splits() const {
    return int(std::count_if(m_deliveries.begin(), m_deliveries.end(), [](auto& d) { return d.split; }));
}

bool isSplit(const PinSet& standing) {
    if (standing[0] || standing.count() < 2)
        return false;
    const auto stands = [&](int pin) { return standing[std::size_t(pin - 1)]; };
    struct Three {
        int down, one, other;
    };
    // Just ahead of two; in the line from one to the other: along a row, or from row to row.
    static constexpr Three letters[] = {{1, 2, 3},  {2, 4, 5}, {3, 5, 6},  {4, 7, 8},  {5, 8, 9},
                                        {6, 9, 10}, {5, 4, 6}, {8, 7, 9},  {9, 8, 10}, {4, 2, 7},
                                        {5, 2, 9},  {5, 3, 8}, {6, 3, 10}, {8, 7, 10}, {9, 7, 10}};
    for (const Three& t : letters)
        if (!stands(t.down) && stands(t.one) && stands(t.other))
            return true;
    // Seen from the bowler the pins stand in seven columns; whom one of them keeps apart no pin joins.
    static constexpr std::array<int, 10> columns{4, 3, 5, 2, 4, 6, 1, 3, 5, 7};
    unsigned taken = 0;
    for (std::size_t k = 0; k < columns.size(); ++k)
        taken |= standing[k] ? 1u << columns[k] : 0u;
    while (!(taken & 1u))
        taken >>= 1;
    return (taken & (taken + 1)) != 0; // a gap among them
}

} // namespace thetalane
