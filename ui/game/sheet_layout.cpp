#include "ui/game/sheet_layout.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

struct Least {
    int name, total, box;
};

Least least(const Appearance& a) {
    return a.projector() ? Least{110, 84, 24} : Least{78, 48, 16};
}

int boxes(ScoringRules rules) {
    return rules == ScoringRules::Traditional ? 21 : 20;
}

} // namespace

SheetLayout::SheetLayout(const Appearance& a, ScoringRules rules, std::size_t players, int width)
    : m_players(players)
    , m_tenthIsLong(rules == ScoringRules::Traditional)
    , m_width(std::max(width, leastWidth(a, rules)))
    , m_header(headerHeight(a))
    , m_row(rowHeight(a))
    , m_rolls(std::round(m_row * 0.46)) {
    const Least low = least(a);
    // What there is beyond the least goes to the frames, and a part of it to the names and the total.
    const double beyond = m_width - leastWidth(a, rules);
    m_name = std::round(std::min(low.name + beyond * 0.16, a.projector() ? 260.0 : 190.0));
    m_total = std::round(std::min(low.total + beyond * 0.06, a.projector() ? 130.0 : 92.0));
    m_frame = std::floor((m_width - m_name - m_total - 1) / boxes(rules) * 2);
    m_last = m_tenthIsLong ? std::round(m_frame * 1.5) : m_frame;
    m_name = m_width - m_total - 1 - 9 * m_frame - m_last; // the rounding of ten frames
}

int SheetLayout::leastWidth(const Appearance& a, ScoringRules rules) {
    const Least low = least(a);
    return low.name + low.total + boxes(rules) * low.box + 1;
}

int SheetLayout::headerHeight(const Appearance& a) {
    return a.pixels(Appearance::Size::Small) + a.unit();
}

int SheetLayout::rowHeight(const Appearance& a) {
    return a.pixels(Appearance::Size::Normal) + a.pixels(Appearance::Size::Large) + 2 * a.unit();
}

int SheetLayout::height() const {
    return int(m_header + m_row * double(m_players)) + 1;
}

QRectF SheetLayout::row(std::size_t player) const {
    return {0, m_header + m_row * double(player), m_width, m_row};
}

QRectF SheetLayout::name(std::size_t player) const {
    return {0, row(player).top(), m_name, m_row};
}

QRectF SheetLayout::total(std::size_t player) const {
    return {m_width - m_total - 1, row(player).top(), m_total, m_row};
}

double SheetLayout::left(int frame) const {
    return m_name + frame * m_frame;
}

QRectF SheetLayout::frame(std::size_t player, int frame) const {
    return {left(frame), row(player).top(), frameWidth(frame), m_row};
}

QRectF SheetLayout::heading(int frame) const {
    return {left(frame), 0, frameWidth(frame), m_header};
}

QRectF SheetLayout::roll(std::size_t player, int frame, int roll) const {
    const double box = frameWidth(frame) / rollCount(frame);
    return {left(frame) + roll * box, row(player).top(), box, m_rolls};
}

QRectF SheetLayout::frameTotal(std::size_t player, int frame) const {
    return this->frame(player, frame).adjusted(0, m_rolls, 0, 0);
}

std::optional<SheetPlace> SheetLayout::at(const QPointF& point) const {
    for (std::size_t player = 0; player < m_players; ++player)
        for (int f = 0; f < framesOfAGame; ++f) {
            if (!frame(player, f).contains(point))
                continue;
            for (int r = 0; r < rollCount(f); ++r)
                if (roll(player, f, r).contains(point))
                    return SheetPlace{player, f, r};
            return SheetPlace{player, f, std::nullopt};
        }
    return std::nullopt;
}

} // namespace thetalane
