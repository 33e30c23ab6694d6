// A frame while it is put right: its deliveries, of which each must fit those before. Entered as it is
// written ("9/"), or pin by pin.
#pragma once

#include "core/bowling/score_notation.h"

#include <QString>

#include <optional>
#include <vector>

namespace thetalane {

class FrameDraft {
public:
    FrameDraft() = default;
    FrameDraft(ScoringRules rules, int frame, std::vector<Delivery> deliveries); // frame from 1

    const std::vector<Delivery>& deliveries() const { return m_deliveries; }
    QString text() const;
    int mostBalls() const { return isLong() ? 3 : 2; }

    // What the ball (from 0) meets; nothing where the frame is over before.
    std::optional<Turn> turn(int ball) const;
    bool isWhole() const; // nothing more belongs to it

    // What was wrong with the text, and then nothing changes. Which pins fell stays known where the count is
    // the same.
    std::optional<RollError> setText(const QString& text);
    // Turns a pin over that the ball meets. Balls after it stay as far as they fit.
    void togglePin(int ball, int pin);

private:
    bool isLong() const { return m_rules == ScoringRules::Traditional && m_frame == framesOfAGame; }
    Scorecard cardBefore(int ball) const;

    ScoringRules m_rules = ScoringRules::Traditional;
    int m_frame = 1;
    std::vector<Delivery> m_deliveries;
};

} // namespace thetalane
