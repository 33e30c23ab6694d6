// What the edit tool shows on the lane: halo, handles, the grid, and values beside what moves.
#include "ui/bench/edit_tool.h"
#include "ui/bench/rules/placing.h"
#include "ui/lane/arrow.h"
#include "ui/lane/label.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {

void EditTool::paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    m_resolution = 1 / pixels.length(1);
    if (!isActive())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_options.snap())
        paintGrid(painter, pixels, area);
    if (m_grip && m_grip->body < bodies().size()) {
        paintHalo(painter, pixels, m_grip->body, true);
        if (m_grip->part == Part::Tip) {
            const Body& body = bodies()[m_grip->body];
            const Vec2d along = tipOf(body, m_grip->scale, 0) - body.position;
            if (norm(body.velocity) > 0)
                paintArrow(painter, pixels.at(body.position + along * (body.radius / norm(along))),
                           pixels.at(body.position + along),
                           {m_context.appearance.accent(), m_context.appearance.lineWidth() + 1, false});
        }
        paintHandle(painter, pixels, m_grip->body);
        if (m_grip->moved)
            paintValues(painter, pixels, area, m_grip->body, m_grip->part == Part::Tip);
    } else {
        if (m_hovered && std::size_t(m_hovered->id / 2) < bodies().size()) {
            paintHalo(painter, pixels, std::size_t(m_hovered->id / 2), false);
            paintHandle(painter, pixels, std::size_t(m_hovered->id / 2));
        }
        if (m_selected) {
            paintHalo(painter, pixels, *m_selected, true);
            paintHandle(painter, pixels, *m_selected);
            paintValues(painter, pixels, area, *m_selected, m_lastWasVelocity);
        }
    }
    painter.restore();
}

void EditTool::paintGrid(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    constexpr double closest = 7; // [px] closer lines would be a grey sheet
    const double step = spacing(m_resolution);
    if (pixels.length(step) < closest)
        return;
    const Vec2d low = pixels.metres(area.bottomLeft());
    const Vec2d high = pixels.metres(area.topRight());
    QColor ink = m_context.appearance.quietText();
    ink.setAlphaF(0.16F);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(ink, 1));
    for (double k = std::ceil(low.x / step); k * step <= high.x; ++k) {
        const double x = std::round(pixels.at({k * step, 0}).x());
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    for (double k = std::ceil(low.y / step); k * step <= high.y; ++k) {
        const double y = std::round(pixels.at({0, k * step}).y());
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    }
    painter.setRenderHint(QPainter::Antialiasing);
}

void EditTool::paintHalo(QPainter& painter, const Pixels& pixels, std::size_t index, bool strong) const {
    const Body& body = bodies()[index];
    const double width = m_context.appearance.lineWidth();
    const double radius = pixels.length(body.radius) + 1.5 * width + 1;
    QColor ink = m_context.appearance.accent();
    ink.setAlphaF(strong ? 0.9F : 0.45F);
    painter.setPen(QPen(ink, strong ? 1.5 * width : width));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(pixels.at(body.position), radius, radius);
}

// A knob on the tip of the arrow; of a body at rest at its edge, with a stalk that says what it is for.
void EditTool::paintHandle(QPainter& painter, const Pixels& pixels, std::size_t index) const {
    constexpr double stalk = 9; // [px] as far as handleAt() expects it
    const Body& body = bodies()[index];
    const QPointF at = pixels.at(tipOf(body, arrowScale(), stalk * m_resolution));
    const double radius = m_context.appearance.projector() ? 7 : 5;
    const QColor accent = m_context.appearance.accent();
    if (norm(body.velocity) == 0) {
        painter.setPen(QPen(accent, m_context.appearance.lineWidth()));
        painter.drawLine(pixels.at(body.position + Vec2d{body.radius, 0}), at);
    }
    painter.setPen(QPen(accent, m_context.appearance.lineWidth()));
    painter.setBrush(m_context.appearance.card());
    painter.drawEllipse(at, radius, radius);
}

QString EditTool::valuesOf(const Body& body, bool velocity) const {
    const QString name = bodyName(body);
    if (!velocity) {
        const QString x = QStringLiteral("x = %1 m").arg(numberText(body.position.x));
        return m_options.oneLine()
                   ? QStringLiteral("%1   %2").arg(name, x)
                   : QStringLiteral("%1   %2   y = %3 m").arg(name, x, numberText(body.position.y));
    }
    if (m_options.oneLine())
        return QStringLiteral("%1   v = %2 m/s").arg(name, numberText(body.velocity.x));
    const double speed = norm(body.velocity);
    if (speed == 0)
        return QStringLiteral("%1   v = 0").arg(name);
    const double angle = std::atan2(body.velocity.y, body.velocity.x) * 180 / std::numbers::pi;
    return QStringLiteral("%1   v = %2 m/s   %3°").arg(name, numberText(speed), numberText(angle));
}

// Above the body, where no hand is; its arrow is kept free.
void EditTool::paintValues(QPainter& painter, const Pixels& pixels, const QRectF& area, std::size_t index,
                           bool velocity) const {
    const Appearance& look = m_context.appearance;
    const Body& body = bodies()[index];
    const QString text = valuesOf(body, velocity);
    const QFont font = look.font(Appearance::Size::Normal, true);
    const QFontMetricsF metrics(font);
    const double margin = look.unit();
    const QSizeF size(metrics.horizontalAdvance(text) + 2 * margin, metrics.height() + margin);
    const QPointF centre = pixels.at(body.position);
    const QPointF tip = pixels.at(tipOf(body, arrowScale(), 0));
    LabelLayout layout(area.adjusted(4, 4, -4, -4));
    layout.avoid(QLineF(centre, tip));
    const double radius = pixels.length(body.radius) + 8;
    layout.avoid(QRectF(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)));
    layout.avoid(QRectF(tip - QPointF(10, 10), QSizeF(20, 20)));
    const QRectF rect = layout.place(size, centre - QPointF(0, radius), {0, -1});
    painter.setPen(QPen(look.accent(), 1));
    painter.setBrush(look.card());
    painter.drawRoundedRect(rect, 5, 5);
    painter.setPen(look.text());
    painter.setFont(font);
    painter.drawText(rect, Qt::AlignCenter, text);
}

} // namespace thetalane
