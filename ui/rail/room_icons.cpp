#include "ui/rail/room_icons.h"

#include <QPainterPathStroker>

namespace thetalane {
namespace {

QPainterPath stroked(const QPainterPath& line) {
    QPainterPathStroker stroker;
    stroker.setWidth(1.8);
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    return stroker.createStroke(line);
}

QPainterPath polyline(std::initializer_list<QPointF> points) {
    QPainterPath p;
    for (const QPointF& at : points)
        p.elementCount() ? p.lineTo(at) : p.moveTo(at);
    return p;
}

QPainterPath disc(const QPointF& at, double radius) {
    QPainterPath p;
    p.addEllipse(at, radius, radius);
    return p;
}

// An open book.
QPainterPath lessons() {
    QPainterPath line;
    for (const double way : {-1.0, 1.0}) {
        line.moveTo(12, 7);
        line.quadTo(12 + way * 4, 3.5, 12 + way * 9, 5);
        line.lineTo(12 + way * 9, 18);
        line.quadTo(12 + way * 4, 16.5, 12, 20);
    }
    line.moveTo(12, 7);
    line.lineTo(12, 20);
    return stroked(line);
}

// Two circles that touch, and the line of their centres.
QPainterPath steps() {
    QPainterPath line = disc({8.2, 15.2}, 5) + disc({16.4, 7.8}, 5);
    return stroked(line) | disc({12.1, 11.6}, 1.6);
}

QPainterPath collisions() {
    QPainterPath dots, line;
    for (const double y : {6.0, 12.0, 18.0}) {
        dots |= disc({5, y}, 1.7);
        line.moveTo(10, y);
        line.lineTo(20.5, y);
    }
    return stroked(line) | dots;
}

// Sliders.
QPainterPath attributes() {
    QPainterPath line, knobs;
    const double at[] = {15, 8, 13};
    for (int k = 0; k < 3; ++k) {
        const double y = 6 + 6 * k;
        line.moveTo(3.5, y);
        line.lineTo(20.5, y);
        knobs |= disc({at[k], y}, 2.7);
    }
    return stroked(line) | knobs;
}

// A disc, and the arrow that someone expects of it.
QPainterPath predict() {
    QPainterPath arrow = polyline({{11, 13}, {19, 5}});
    arrow += polyline({{13.5, 4.5}, {19.5, 4.5}, {19.5, 10.5}});
    QPainterPath dots;
    for (const double t : {0.0, 1.0, 2.0})
        dots |= disc({12.5 + 3.4 * t, 19}, 1.2);
    return stroked(disc({7, 16.5}, 4.2) + arrow) | dots;
}

QPainterPath tables() {
    QPainterPath line;
    line.addRect(QRectF(3.5, 4.5, 17, 15));
    line += polyline({{3.5, 9.5}, {20.5, 9.5}});
    line += polyline({{3.5, 14.5}, {20.5, 14.5}});
    line += polyline({{10, 4.5}, {10, 19.5}});
    return stroked(line);
}

// A pin.
QPainterPath game() {
    QPainterPath line;
    line.moveTo(9.5, 20.5);
    line.cubicTo(6, 14, 10, 12, 10, 8.5);
    line.cubicTo(8.6, 2, 15.4, 2, 14, 8.5);
    line.cubicTo(14, 12, 18, 14, 14.5, 20.5);
    line.closeSubpath();
    line += polyline({{10, 9}, {14, 9}});
    return stroked(line);
}

// One leads to two.
QPainterPath chain() {
    QPainterPath line = polyline({{6, 12}, {17, 6}}) + polyline({{6, 12}, {17, 18}});
    return stroked(line) | disc({5.5, 12}, 3) | disc({18, 5.5}, 2.6) | disc({18, 18.5}, 2.6);
}

QPainterPath map() {
    QPainterPath cells;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row != 2 - column)
                cells.addRect(QRectF(4 + 5.6 * column, 4 + 5.6 * row, 4.6, 4.6));
    QPainterPath line;
    line.addRect(QRectF(3, 3, 18, 18));
    return cells | stroked(line);
}

// A target.
QPainterPath practice() {
    return stroked(disc({12, 12}, 8.5) + disc({12, 12}, 4.6)) | disc({12, 12}, 1.7);
}

QPainterPath statistics() {
    QPainterPath bars;
    bars.addRect(QRectF(4.5, 13, 3.6, 6.5));
    bars.addRect(QRectF(10.2, 8, 3.6, 11.5));
    bars.addRect(QRectF(15.9, 4, 3.6, 15.5));
    return bars | stroked(polyline({{3, 20.5}, {21, 20.5}}));
}

// Axes, and a line that falls: error against cost.
QPainterPath accuracy() {
    QPainterPath line = polyline({{4, 3.5}, {4, 20}, {20.5, 20}});
    line += polyline({{8, 7}, {12, 12}, {19, 16}});
    return stroked(line) | disc({8, 7}, 1.8) | disc({12, 12}, 1.8) | disc({19, 16}, 1.8);
}

QPainterPath words() {
    QPainterPath hook;
    hook.moveTo(9, 9.4);
    hook.cubicTo(9, 5, 15.5, 5, 15.2, 9.3);
    hook.cubicTo(15, 11.6, 12, 11.6, 12, 14.2);
    QPainterPath all = stroked(disc({12, 12}, 9));
    all.addPath(stroked(hook));
    all.addPath(disc({12, 17.3}, 1.3));
    return all;
}

} // namespace

QPainterPath roomIcon(Room room) {
    switch (room) {
    case Room::Lessons:
        return lessons();
    case Room::Steps:
        return steps();
    case Room::Collisions:
        return collisions();
    case Room::Attributes:
        return attributes();
    case Room::Predict:
        return predict();
    case Room::Tables:
        return tables();
    case Room::Game:
        return game();
    case Room::Chain:
        return chain();
    case Room::Map:
        return map();
    case Room::Practice:
        return practice();
    case Room::Statistics:
        return statistics();
    case Room::Accuracy:
        return accuracy();
    case Room::Glossary:
        return words();
    }
    return {};
}

} // namespace thetalane
