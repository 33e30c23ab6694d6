#include "ui/lane/label.h"

#include "ui/lane/arrow.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace thetalane {
namespace {

constexpr double padX = 5;
constexpr double padY = 2;

struct Fonts {
    QFont symbol, sub, text;

    Fonts(const Appearance& look, Appearance::Size size)
        : symbol(look.formulaFont(int(look.pixels(size) * 1.35), true))
        , sub(look.formulaFont(int(look.pixels(size) * 0.96), false))
        , text(look.font(size)) {}
};

bool crosses(const QLineF& line, const QRectF& rect) {
    if (rect.contains(line.p1()) || rect.contains(line.p2()))
        return true;
    const QPointF c[] = {rect.topLeft(), rect.topRight(), rect.bottomRight(), rect.bottomLeft()};
    for (int i = 0; i < 4; ++i)
        if (line.intersects(QLineF(c[i], c[(i + 1) % 4]), nullptr) == QLineF::BoundedIntersection)
            return true;
    return false;
}

// How far the rectangle reaches from its centre in a direction.
double reach(const QSizeF& size, const QPointF& direction) {
    const double x = std::abs(direction.x()) > 1e-9 ? size.width() / 2 / std::abs(direction.x()) : 1e9;
    const double y = std::abs(direction.y()) > 1e-9 ? size.height() / 2 / std::abs(direction.y()) : 1e9;
    return std::min(x, y);
}

QRectF around(const QPointF& centre, const QSizeF& size) {
    return {centre.x() - size.width() / 2, centre.y() - size.height() / 2, size.width(), size.height()};
}

} // namespace

QSizeF labelSize(const OverlayLabel& label, const Appearance& look, Appearance::Size textSize) {
    const Fonts f(look, textSize);
    const double width = QFontMetricsF(f.symbol).horizontalAdvance(label.symbol) +
                         QFontMetricsF(f.sub).horizontalAdvance(label.sub) +
                         QFontMetricsF(f.text).horizontalAdvance(label.text);
    const double drop = label.sub.isEmpty() ? 0 : 0.25 * f.sub.pixelSize();
    const double line = label.symbol.isEmpty() ? f.text.pixelSize() : f.symbol.pixelSize();
    return {width + 2 * padX, 1.25 * line + drop + 2 * padY};
}

void paintLabel(QPainter& painter, const QRectF& rect, const OverlayLabel& label, const QColor& colour,
                const Appearance& look, Appearance::Size textSize) {
    const Fonts f(look, textSize);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(look.card(), 0.86));
    painter.drawRoundedRect(rect, 4, 4);
    painter.setPen(colour);
    const double drop = label.sub.isEmpty() ? 0 : 0.25 * f.sub.pixelSize();
    const double line = label.symbol.isEmpty() ? f.text.pixelSize() : f.symbol.pixelSize();
    const double base = rect.bottom() - padY - drop - 0.28 * line;
    double x = rect.left() + padX;
    const auto put = [&](const QFont& font, const QString& text, double down) {
        painter.setFont(font);
        painter.drawText(QPointF(x, base + down), text);
        x += QFontMetricsF(font).horizontalAdvance(text);
    };
    put(f.symbol, label.symbol, 0);
    put(f.sub, label.sub, 0.3 * f.sub.pixelSize());
    put(f.text, label.text, 0);
}

double LabelLayout::cost(const QRectF& rect) const {
    double sum = 0;
    const QRectF wide = rect.adjusted(-3, -2, 3, 2);
    for (const QLineF& line : m_lines)
        sum += crosses(line, wide) ? 60 : 0;
    for (const QRectF& other : m_taken)
        sum += wide.intersects(other) ? 140 : 0;
    for (const Circle& disc : m_discs) {
        const QPointF d = rect.center() - disc.centre;
        const double inside = disc.radius + rect.height() / 2 - std::hypot(d.x(), d.y());
        sum += std::clamp(inside / rect.height() * 15, 0.0, 30.0);
    }
    return m_area.contains(rect) ? sum : sum + 500;
}

QRectF LabelLayout::place(const QSizeF& size, const QPointF& anchor, const QPointF& away) {
    constexpr int directions = 24;
    constexpr double gaps[] = {7, 16, 28, 44, 64, 90, 120};
    const double start = std::atan2(away.y(), away.x());
    QRectF best = around(anchor, size);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < directions; ++k) {
        const double turn = (k % 2 ? 1 : -1) * ((k + 1) / 2) * 2 * std::numbers::pi / directions;
        const QPointF direction(std::cos(start + turn), std::sin(start + turn));
        for (const double gap : gaps) {
            const QRectF rect = around(anchor + direction * (reach(size, direction) + gap), size);
            const double price = cost(rect) + 3 * std::abs(turn) + 0.35 * (gap - gaps[0]);
            if (price < least) {
                least = price;
                best = rect;
            }
        }
    }
    m_taken.push_back(best);
    return best;
}

QRectF LabelLayout::placeInside(const QSizeF& size, const QPointF& centre, double radius,
                                const QPointF& away) {
    constexpr int directions = 16;
    QRectF best = around(centre, size);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        for (const double part : {0.62, 0.5, 0.72}) {
            const QRectF rect =
                around(centre + QPointF(std::cos(angle), std::sin(angle)) * (part * radius), size);
            const double price =
                cost(rect) + std::abs(part - 0.62) -
                (std::cos(angle) * away.x() + std::sin(angle) * away.y()) / std::hypot(away.x(), away.y());
            if (price < least) {
                least = price;
                best = rect;
            }
        }
    }
    m_taken.push_back(best);
    return best;
}

} // namespace thetalane
