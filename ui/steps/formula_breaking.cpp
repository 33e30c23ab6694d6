// Breaking a formula that is too wide: before a plus or minus, as textbooks do.
#include "ui/steps/formula_layout.h"

#include <algorithm>

namespace thetalane {
namespace {

using Kind = Formula::Kind;

bool isSum(const Formula& f) {
    return f.kind == Kind::Operator && (f.text == "+" || f.text == "−");
}

// The parts of a row, cut before those sum signs where the next term would not fit. What follows a cut starts
// with a nothing, so that its sign is set as one between two terms.
std::vector<Formula> cut(const FormulaLayout& layout, const Formula& f, double width) {
    std::vector<Formula> rows{{}};
    for (std::size_t i = 0; i < f.parts.size(); ++i) {
        const bool binary = i > 0 && isSum(f.parts[i]) && f.parts[i - 1].kind != Kind::Operator;
        if (binary) {
            Formula longer = rows.back();
            for (std::size_t k = i; k < f.parts.size() && (k == i || !isSum(f.parts[k])); ++k)
                longer.parts.push_back(f.parts[k]);
            if (layout.box(longer).width > width)
                rows.push_back(row({symbol({})}));
        }
        rows.back().parts.push_back(f.parts[i]);
    }
    return rows;
}

} // namespace

// Rows below one another; the baseline is the first one's.
FormulaBox FormulaLayout::lines(const std::vector<Formula>& rows) const {
    std::vector<FormulaBox> boxes;
    double width = 0;
    for (const Formula& f : rows) {
        boxes.push_back(box(f));
        width = std::max(width, boxes.back().width);
    }
    FormulaBox result;
    double y = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i > 0)
            y += boxes[i - 1].descent + 0.3 * m_size + std::max(boxes[i].ascent, strut());
        result.add(boxes[i], {0, y});
    }
    result.width = width;
    result.broken = boxes.size() > 1;
    return result;
}

FormulaBox FormulaLayout::box(const Formula& f, double width) const {
    FormulaBox whole = box(f);
    if (whole.width <= width)
        return whole;
    if (f.kind == Kind::Fraction) {
        const double inside = width - 0.28 * m_size;
        return fraction(box(f.parts[0], inside), box(f.parts[1], inside));
    }
    if (f.kind != Kind::Row)
        return whole;
    if (f.parts.size() == 2 && f.parts[0].kind == Kind::Operator) { // a sign before a fraction
        FormulaBox result = box(f.parts[0]);
        const double start = result.width + 0.06 * m_size;
        const FormulaBox rest = box(f.parts[1], width - start);
        result.add(rest, {start, 0});
        result.width = start + rest.width;
        return result;
    }
    const std::vector<Formula> rows = cut(*this, f, width);
    return rows.size() == 1 ? whole : lines(rows);
}

} // namespace thetalane
