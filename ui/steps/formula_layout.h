// A small typesetter: a Formula becomes a box of glyphs and strokes, as a textbook would set it. Italic
// symbols, upright functions and units, fractions on the axis of the minus sign, roots with their bar.
#pragma once

#include "ui/appearance.h"
#include "ui/words/formula.h"

#include <QPainterPath>
#include <QRectF>

#include <vector>

class QPainter;

namespace thetalane {

// Relative to the left end of the box's baseline; y downwards, pixels.
struct FormulaItem {
    QPointF position; // of a text's baseline
    QString text;     // empty: the path is filled
    QFont font;
    QPainterPath path;
    Ink ink = Ink::Plain;
};

struct FormulaBox {
    double width = 0;
    double ascent = 0;   // above the baseline
    double descent = 0;  // below it
    bool broken = false; // over several rows; the baseline is the first one's
    std::vector<FormulaItem> items;

    double height() const { return ascent + descent; }
    // Takes another box in, its baseline starting at `at`; the extents grow upwards and downwards only.
    void add(const FormulaBox& box, QPointF at);
};

class FormulaLayout {
public:
    FormulaLayout(const Appearance& appearance, int pixelSize);

    int pixelSize() const { return m_size; }
    double axis() const; // the height of the minus sign above the baseline
    double strut() const { return 0.74 * m_size; }

    FormulaBox box(const Formula& formula) const;

    // Not wider than `width` if that can be done by breaking at + and −, also above and below a stroke.
    FormulaBox box(const Formula& formula, double width) const;

    FormulaBox text(const QString& text, bool italic, Ink ink) const;
    double relationSpace() const { return 0.32 * m_size; } // on each side of an equals sign

private:
    FormulaLayout smaller() const;
    FormulaBox row(const std::vector<Formula>& parts) const;
    FormulaBox index(const Formula& formula) const;
    FormulaBox primes(int count, Ink ink) const;
    FormulaBox letters(const QString& text, bool italic, Ink ink) const;
    FormulaBox fraction(const FormulaBox& above, const FormulaBox& below) const;
    FormulaBox root(const FormulaBox& under) const;
    FormulaBox script(const Formula& formula) const;
    FormulaBox group(const FormulaBox& inner) const;
    FormulaBox lines(const std::vector<Formula>& rows) const;
    double spaceBetween(const Formula& left, const Formula& right, bool leftUnary) const;
    double stroke() const;

    const Appearance& m_appearance;
    int m_size;
};

void paintFormula(QPainter& painter, const FormulaBox& box, QPointF baseline, const Appearance& appearance);

// The rectangles of all glyphs and strokes: for tests, and for keeping labels apart.
std::vector<QRectF> inkRects(const FormulaBox& box, QPointF baseline);

} // namespace thetalane
