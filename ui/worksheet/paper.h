// A page to be filled from the top: words, formulas and blanks. Units are tenths of a point; without a
// painter it only measures.
#pragma once

#include "ui/steps/formula_layout.h"
#include "ui/words/worked_steps.h"

#include <QPainter>

namespace thetalane {

class Paper {
public:
    static constexpr double pageWidth = 5953, pageHeight = 8419; // A4 [0.1 pt]
    static constexpr double margin = 460;

    // em: of the words [0.1 pt].
    Paper(const Appearance& appearance, double em, QPainter* painter)
        : m_appearance(appearance)
        , m_em(em)
        , m_painter(painter) {}

    double em() const { return m_em; }
    double y() const { return m_y; }
    double room() const { return pageWidth - 2 * margin; }
    void skip(double ems) { m_y += ems * m_em; }
    void moveTo(double y) { m_y = y; }
    QPainter* painter() const { return m_painter; }
    const Appearance& appearance() const { return m_appearance; }

    QFont font(double size = 1, bool bold = false) const; // size in em
    double textWidth(const QString& text, double size = 1, bool bold = false) const;
    // In one line; the baseline is at y + 1.1 em of that size.
    void text(double x, double y, const QString& text, const QColor& colour, double size = 1,
              bool bold = false) const;
    // Over as many lines as it takes; returns the height.
    double paragraph(double x, double y, double width, const QString& text, const QColor& colour,
                     double size = 1) const;
    void line(QPointF from, QPointF to, const QColor& colour, double wide = 6,
              Qt::PenStyle style = Qt::SolidLine) const;

    enum class Fill { Blank, Answer };
    // left = symbolic = ______ unit, or with the numbers put in and the result. Returns the height.
    double worked(double x, double y, double width, const WorkedLine& line, Fill fill) const;
    // Those lines in two columns, downwards one column after the other; moves on.
    void columns(const std::vector<WorkedLine>& lines, Fill fill);

private:
    struct Piece;
    std::vector<Piece> piecesOf(const WorkedLine& line, double width, Fill fill) const;

    const Appearance& m_appearance;
    double m_em;
    QPainter* m_painter;
    double m_y = margin;
};

} // namespace thetalane
