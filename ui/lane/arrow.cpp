#include "ui/lane/arrow.h"

#include <QLineF>
#include <QPolygonF>

#include <algorithm>

namespace thetalane {

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& to, const ArrowStyle& style) {
    const QPointF delta = to - from;
    const double length = std::hypot(delta.x(), delta.y());
    if (length < 1)
        return;
    const QPointF along = delta / length;
    const QPointF across(-along.y(), along.x());
    const double head = std::min(6 + 3.2 * style.width, length * 0.6);
    const double half = head * 0.42;
    const QPointF base = to - along * head;

    QPen pen(style.colour, style.width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
    if (style.dashed)
        pen.setDashPattern({3.2, 2.0});
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawLine(from, style.dashed ? to - along * style.width : base + along * (head * 0.2));
    const QPointF wings[] = {base + across * half, to, base - across * half};
    if (style.dashed) {
        painter.setPen(QPen(style.colour, style.width, Qt::SolidLine, Qt::RoundCap, Qt::MiterJoin));
        painter.drawPolyline(wings, 3);
    } else {
        painter.setPen(Qt::NoPen);
        painter.setBrush(style.colour);
        painter.drawPolygon(wings, 3);
    }
}

QColor mixed(const QColor& over, const QColor& under, double share) {
    const auto blend = [share](int a, int b) { return int(share * a + (1 - share) * b + 0.5); };
    return QColor(blend(over.red(), under.red()), blend(over.green(), under.green()),
                  blend(over.blue(), under.blue()));
}

QColor faded(QColor colour, double opacity) {
    colour.setAlphaF(float(colour.alphaF() * opacity));
    return colour;
}

} // namespace thetalane
