#include "ui/steps/figure_canvas.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace thetalane {
namespace {

double lengthOf(QPointF v) {
    return std::hypot(v.x(), v.y());
}

// How much of a stroke lies inside a rectangle, by samples two pixels apart [px].
double lengthInside(const QLineF& stroke, const QRectF& rect) {
    if (std::max(stroke.x1(), stroke.x2()) < rect.left() ||
        std::min(stroke.x1(), stroke.x2()) > rect.right() ||
        std::max(stroke.y1(), stroke.y2()) < rect.top() || std::min(stroke.y1(), stroke.y2()) > rect.bottom())
        return 0;
    const int samples = std::max(2, int(stroke.length() / 2));
    int inside = 0;
    for (int i = 0; i <= samples; ++i)
        inside += rect.contains(stroke.pointAt(double(i) / samples));
    return 2.0 * inside;
}

double outsideOf(const QRectF& rect, QSizeF size) {
    return std::max(0.0, -rect.left()) + std::max(0.0, -rect.top()) +
           std::max(0.0, rect.right() - size.width()) + std::max(0.0, rect.bottom() - size.height());
}

double area(const QRectF& rect) {
    return rect.isValid() ? rect.width() * rect.height() : 0;
}

} // namespace

FigureCanvas::FigureCanvas(const Appearance& appearance, QSizeF size)
    : m_appearance(appearance)
    , m_size(size) {}

void FigureCanvas::line(QPointF from, QPointF to, const QColor& color, double width, Qt::PenStyle style) {
    QPainterPath path(from);
    path.lineTo(to);
    m_shapes.push_back({path, QPen(color, width, style, Qt::FlatCap), Qt::NoBrush});
    m_strokes.emplace_back(from, to);
}

void FigureCanvas::arrow(QPointF from, QPointF to, const QColor& color, double width, ArrowHead head,
                         Qt::PenStyle style) {
    const QPointF along = to - from;
    const double length = lengthOf(along);
    if (length < 1)
        return;
    const QPointF unit = along / length;
    const QPointF normal(-unit.y(), unit.x());
    const double reach = std::min(length, 3.6 * width + 3); // a short arrow is all head
    const double half = 0.42 * reach;
    const QPointF base = to - unit * reach;

    QPainterPath shaft(from);
    shaft.lineTo(head == ArrowHead::Filled ? base + unit * 1.0 : to);
    m_shapes.push_back({shaft, QPen(color, width, style, Qt::FlatCap), Qt::NoBrush});
    QPainterPath tip(base + normal * half);
    tip.lineTo(to);
    tip.lineTo(base - normal * half);
    if (head == ArrowHead::Filled) {
        tip.closeSubpath();
        m_shapes.push_back({tip, Qt::NoPen, color});
    } else {
        m_shapes.push_back(
            {tip, QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin), Qt::NoBrush});
    }
    m_strokes.emplace_back(from, to);
    m_strokes.emplace_back(base + normal * half, base - normal * half);
}

void FigureCanvas::disc(QPointF centre, double radius, const QColor& color) {
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    QColor inside = color;
    inside.setAlphaF(0.10f);
    QColor edge = color;
    edge.setAlphaF(0.55f);
    m_shapes.push_back({path, QPen(edge, 1.2), inside});
    constexpr int pieces = 48;
    for (int i = 0; i < pieces; ++i) {
        const auto at = [&](int k) {
            const double angle = 2 * std::numbers::pi * k / pieces;
            return centre + radius * QPointF(std::cos(angle), std::sin(angle));
        };
        m_edges.emplace_back(at(i), at(i + 1));
    }
}

void FigureCanvas::arc(QPointF centre, double radius, double fromDegrees, double spanDegrees,
                       const QColor& color) {
    const QRectF box(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius);
    QPainterPath path;
    path.arcMoveTo(box, fromDegrees);
    path.arcTo(box, fromDegrees, spanDegrees);
    m_shapes.push_back({path, QPen(color, 0.75 * width()), Qt::NoBrush});
    constexpr int pieces = 12;
    const auto at = [&](int i) {
        const double angle = (fromDegrees + spanDegrees * i / pieces) * std::numbers::pi / 180;
        return centre + radius * QPointF(std::cos(angle), -std::sin(angle));
    };
    for (int i = 0; i < pieces; ++i)
        m_strokes.emplace_back(at(i), at(i + 1));
}

void FigureCanvas::dot(QPointF centre, const QColor& color) {
    const double r = 1.1 * width();
    QPainterPath path;
    path.addEllipse(centre, r, r);
    m_shapes.push_back({path, Qt::NoPen, color});
    m_strokes.emplace_back(centre - QPointF(r, 0), centre + QPointF(r, 0));
    m_strokes.emplace_back(centre - QPointF(0, r), centre + QPointF(0, r));
}

void FigureCanvas::label(const Formula& formula, QPointF anchor, QPointF outward, Appearance::Size size) {
    const FormulaLayout layout(m_appearance, m_appearance.pixels(size));
    const double length = lengthOf(outward);
    m_labels.push_back(
        {layout.box(formula), anchor, length > 0 ? outward / length : QPointF(0, -1), QRectF()});
}

double FigureCanvas::costOf(const QRectF& place, std::size_t self) const {
    const QRectF wide = place.adjusted(-3.5, -3, 3.5, 3);
    double cost = 60 * outsideOf(wide, m_size);
    for (const QLineF& stroke : m_strokes)
        cost += 5 * lengthInside(stroke, wide);
    for (const QLineF& edge : m_edges)
        cost += 0.8 * lengthInside(edge, wide);
    for (std::size_t i = 0; i < self; ++i)
        cost += 2 * area(wide.intersected(m_labels[i].place));
    return cost;
}

void FigureCanvas::settle() {
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        FigureLabel& label = m_labels[i];
        const QSizeF size(label.box.width, label.box.height());
        double best = std::numeric_limits<double>::max();
        for (double distance = 4; distance <= 64; distance += 3) {
            for (int turn = 0; turn < 24; ++turn) {
                // 0°, 15°, -15°, 30°, …: the nearer to the wish the better
                const double angle = ((turn + 1) / 2) * (turn % 2 ? 1 : -1) * std::numbers::pi / 12;
                const QPointF way(label.outward.x() * std::cos(angle) - label.outward.y() * std::sin(angle),
                                  label.outward.x() * std::sin(angle) + label.outward.y() * std::cos(angle));
                // The label's near edge stands `distance` away, whatever its shape.
                const QPointF centre = label.anchor + way * distance +
                                       QPointF(way.x() * size.width() / 2, way.y() * size.height() / 2);
                const QRectF place(centre.x() - size.width() / 2, centre.y() - size.height() / 2,
                                   size.width(), size.height());
                const double cost = costOf(place, i) + 1.2 * distance + 5 * std::abs(angle);
                if (cost < best) {
                    best = cost;
                    label.place = place;
                }
            }
        }
    }
}

void FigureCanvas::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Shape& shape : m_shapes) {
        painter.setPen(shape.pen);
        painter.setBrush(shape.brush);
        painter.drawPath(shape.path);
    }
    for (const FigureLabel& label : m_labels)
        paintFormula(painter, label.box, label.place.topLeft() + QPointF(0, label.box.ascent), m_appearance);
}

} // namespace thetalane
