// Where everything stands on a score sheet [px]: a column for the names, ten frames, the total. Painting and
// the mouse ask the same places.
#pragma once

#include "core/bowling/scorecard.h"
#include "ui/appearance.h"

#include <QRectF>

#include <optional>

namespace thetalane {

// A frame of a player, and of it one roll or its lower part. All from 0.
struct SheetPlace {
    std::size_t player = 0;
    int frame = 0;
    std::optional<int> roll{};

    friend bool operator==(const SheetPlace&, const SheetPlace&) = default;
};

class SheetLayout {
public:
    SheetLayout(const Appearance& appearance, ScoringRules rules, std::size_t players, int width);

    static int leastWidth(const Appearance& appearance, ScoringRules rules);
    static int headerHeight(const Appearance& appearance);
    static int rowHeight(const Appearance& appearance);

    int height() const; // of all rows and the header
    QRectF header() const { return {0, 0, m_width, m_header}; }
    QRectF row(std::size_t player) const;
    QRectF name(std::size_t player) const;
    QRectF total(std::size_t player) const;
    QRectF frame(std::size_t player, int frame) const;
    QRectF heading(int frame) const;
    int rollCount(int frame) const { return frame == 9 && m_tenthIsLong ? 3 : 2; }
    QRectF roll(std::size_t player, int frame, int roll) const;
    QRectF frameTotal(std::size_t player, int frame) const;

    std::optional<SheetPlace> at(const QPointF& point) const;

private:
    double left(int frame) const;
    double frameWidth(int frame) const { return frame == 9 ? m_last : m_frame; }

    std::size_t m_players;
    bool m_tenthIsLong; // with its fill balls
    double m_width = 0;
    double m_name = 0;
    double m_total = 0;
    double m_frame = 0;
    double m_last = 0;
    double m_header = 0;
    double m_row = 0;
    double m_rolls = 0; // the upper part of a row
};

} // namespace thetalane
