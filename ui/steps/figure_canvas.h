// What a figure is made of: strokes, arrows, discs, and labels that find a free place of their own.
// Pixels, y downwards.
#pragma once

#include "ui/steps/formula_layout.h"

#include <QBrush>
#include <QLineF>
#include <QPen>

#include <vector>

namespace thetalane {

enum class ArrowHead { Filled, Open };

struct FigureLabel {
    FormulaBox box;
    QPointF anchor;  // what it belongs to
    QPointF outward; // where it would like to stand, seen from the anchor
    QRectF place;    // found by settle()
};

class FigureCanvas {
public:
    FigureCanvas(const Appearance& appearance, QSizeF size);

    QSizeF size() const { return m_size; }
    double width() const { return m_appearance.lineWidth(); }

    void line(QPointF from, QPointF to, const QColor& color, double width,
              Qt::PenStyle style = Qt::SolidLine);
    void arrow(QPointF from, QPointF to, const QColor& color, double width,
               ArrowHead head = ArrowHead::Filled, Qt::PenStyle style = Qt::SolidLine);
    void disc(QPointF centre, double radius, const QColor& color);
    void arc(QPointF centre, double radius, double fromDegrees, double spanDegrees, const QColor& color);
    void dot(QPointF centre, const QColor& color);
    void label(const Formula& formula, QPointF anchor, QPointF outward, Appearance::Size size);

    // Gives every label the best place near its anchor: inside, off every stroke, off the other labels.
    void settle();

    void paint(QPainter& painter) const;

    const std::vector<FigureLabel>& labels() const { return m_labels; }
    const std::vector<QLineF>& strokes() const { return m_strokes; } // what labels keep off

private:
    struct Shape {
        QPainterPath path;
        QPen pen{Qt::NoPen};
        QBrush brush{Qt::NoBrush};
    };
    double costOf(const QRectF& place, std::size_t self) const;

    const Appearance& m_appearance;
    QSizeF m_size;
    std::vector<Shape> m_shapes;
    std::vector<QLineF> m_strokes;
    std::vector<QLineF> m_edges; // of discs: better kept off, but no harm
    std::vector<FigureLabel> m_labels;
};

} // namespace thetalane
