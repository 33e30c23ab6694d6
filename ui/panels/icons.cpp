#include "ui/panels/icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPathStroker>
#include <QPixmap>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double grid = 24;
constexpr double strokeWidth = 2;

QPainterPath stroked(const QPainterPath& line) {
    QPainterPathStroker stroker;
    stroker.setWidth(strokeWidth);
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    return stroker.createStroke(line);
}

QPainterPath triangle(double left, double right, double halfHeight) {
    QPainterPath p;
    p.moveTo(left, 12 - halfHeight);
    p.lineTo(right, 12);
    p.lineTo(left, 12 + halfHeight);
    p.closeSubpath();
    return p;
}

QPainterPath bar(double left, double width, double halfHeight) {
    QPainterPath p;
    p.addRoundedRect(QRectF(left, 12 - halfHeight, width, 2 * halfHeight), 1, 1);
    return p;
}

QPainterPath mirrored(const QPainterPath& path) {
    return QTransform(-1, 0, 0, 1, grid, 0).map(path);
}

// The burst of an impact.
QPainterPath star(double x, double radius) {
    QPainterPath p;
    constexpr int points = 8;
    for (int i = 0; i < 2 * points; ++i) {
        const double r = i % 2 ? radius * 0.42 : i % 4 ? radius * 0.8 : radius;
        const double angle = i * std::numbers::pi / points;
        const QPointF at(x + r * std::sin(angle), 12 - r * std::cos(angle));
        i ? p.lineTo(at) : p.moveTo(at);
    }
    p.closeSubpath();
    return p;
}

QPainterPath collisionForward() {
    return triangle(2.5, 11, 6) | star(17, 5.5);
}

QPainterPath frameForward() {
    return bar(6, 2.5, 6.5) | triangle(11, 19, 6.5);
}

QPainterPath reset() {
    QPainterPath arc;
    const QRectF circle(5, 5, 14, 14);
    arc.arcMoveTo(circle, 120);
    arc.arcTo(circle, 120, 290);
    QPainterPath head; // at the start of the arc, pointing back along it
    head.moveTo(4.2, 3.6);
    head.lineTo(10.6, 4.2);
    head.lineTo(6.6, 9.4);
    head.closeSubpath();
    return stroked(arc) | head;
}

QPainterPath zoom() {
    QPainterPath line;
    line.addEllipse(QPointF(10.5, 10.5), 6, 6);
    line.moveTo(15, 15);
    line.lineTo(20, 20);
    return stroked(line);
}

QPainterPath globe() {
    QPainterPath line;
    line.addEllipse(QPointF(12, 12), 8.5, 8.5);
    line.addEllipse(QPointF(12, 12), 3.8, 8.5);
    line.moveTo(3.5, 12);
    line.lineTo(20.5, 12);
    return stroked(line);
}

// A screen on its stand.
QPainterPath projector() {
    QPainterPath line;
    line.moveTo(3, 4.5);
    line.lineTo(21, 4.5);
    line.addRect(QRectF(5, 4.5, 14, 10));
    line.moveTo(12, 14.5);
    line.lineTo(12, 17);
    line.moveTo(8, 20.5);
    line.lineTo(12, 17);
    line.lineTo(16, 20.5);
    return stroked(line);
}

QPainterPath cross(bool upright) {
    QPainterPath line;
    line.moveTo(6.5, 12);
    line.lineTo(17.5, 12);
    if (upright) {
        line.moveTo(12, 6.5);
        line.lineTo(12, 17.5);
    }
    return stroked(line);
}

QPainterPath chevron() {
    QPainterPath line;
    line.moveTo(6.5, 9.5);
    line.lineTo(12, 15);
    line.lineTo(17.5, 9.5);
    return stroked(line);
}

QPainterPath folder() {
    QPainterPath line;
    line.moveTo(4, 18.5);
    line.lineTo(4, 5.5);
    line.lineTo(10, 5.5);
    line.lineTo(12, 8);
    line.lineTo(20, 8);
    line.lineTo(20, 18.5);
    line.closeSubpath();
    return stroked(line);
}

// A crescent.
QPainterPath moon() {
    QPainterPath disc, bite;
    disc.addEllipse(QPointF(11, 12.5), 8, 8);
    bite.addEllipse(QPointF(15, 9), 7, 7);
    return disc - bite;
}

class PathEngine : public QIconEngine {
public:
    PathEngine(Icon icon, QColor colour, QColor disabled)
        : m_icon(icon)
        , m_colour(colour)
        , m_disabled(disabled) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        paintIcon(*painter, m_icon, rect, mode == QIcon::Disabled ? m_disabled : m_colour);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap image(size);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return image;
    }
    QIconEngine* clone() const override { return new PathEngine(*this); }

private:
    Icon m_icon;
    QColor m_colour;
    QColor m_disabled;
};

} // namespace

QPainterPath iconPath(Icon icon) {
    switch (icon) {
    case Icon::Play:
        return triangle(7.5, 20, 7.5);
    case Icon::Pause:
        return bar(6.5, 4, 7) | bar(13.5, 4, 7);
    case Icon::Start:
        return bar(3, 2.5, 6.5) | mirrored(triangle(4, 11, 6.5)) | mirrored(triangle(10, 17, 6.5));
    case Icon::FrameBack:
        return mirrored(frameForward());
    case Icon::FrameForward:
        return frameForward();
    case Icon::CollisionBack:
        return mirrored(collisionForward());
    case Icon::CollisionForward:
        return collisionForward();
    case Icon::Reset:
        return reset();
    case Icon::Zoom:
        return zoom();
    case Icon::Globe:
        return globe();
    case Icon::Projector:
        return projector();
    case Icon::Plus:
        return cross(true);
    case Icon::Minus:
        return cross(false);
    case Icon::Open:
        return folder();
    case Icon::Moon:
        return moon();
    case Icon::Down:
        return chevron();
    }
    return {};
}

void paintIcon(QPainter& painter, Icon icon, const QRectF& where, const QColor& colour) {
    const double side = std::min(where.width(), where.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(where.center() - QPointF(side, side) / 2);
    painter.scale(side / grid, side / grid);
    QPainterPath path = iconPath(icon);
    path.setFillRule(Qt::WindingFill);
    painter.fillPath(path, colour);
    painter.restore();
}

QIcon makeIcon(Icon icon, const QColor& colour, const QColor& disabled) {
    return QIcon(new PathEngine(icon, colour, disabled));
}

} // namespace thetalane
