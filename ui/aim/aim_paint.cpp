// The aim as it is drawn: the run's own way to the first contact, the arrow, and what can be grabbed.
#include "ui/aim/aim_tool.h"
#include "ui/lane/arrow.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thetalane {
namespace {

constexpr double smallScale = 60; // [px/m] below it only what can be told apart is drawn

// The ball's stretches as they are, each a parabola in pieces that cannot be told from it, as far as they are
// in sight: single lines, which Qt paints many times as fast as a path.
std::vector<QLineF> wayOf(const Timeline& timeline, double until, const Pixels& pixels, const QRectF& area) {
    std::vector<QLineF> lines;
    const auto segments = timeline.segments(0);
    for (std::size_t k = 0; k < segments.size() && segments[k].start < until; ++k) {
        const Segment& s = segments[k];
        const double time =
            std::min(k + 1 < segments.size() ? segments[k + 1].start : until, until) - s.start;
        const int pieces = s.acceleration == Vec2d{} ? 1 : 24;
        QPointF last = pixels.at(s.position);
        for (int piece = 1; piece <= pieces; ++piece) {
            const double t = time * piece / pieces;
            const QPointF next = pixels.at(s.position + (s.velocity + s.acceleration * (t / 2)) * t);
            if (QRectF(last, next).normalized().adjusted(-2, -2, 2, 2).intersects(area))
                lines.emplace_back(last, next);
            last = next;
        }
    }
    return lines;
}

// Until the ball first touches something, or is lost to play.
double firstTouch(const Timeline& timeline) {
    double until = timeline.endTime();
    for (const Collision& c : timeline.collisions())
        if (c.involves(0)) {
            until = std::min(until, c.time);
            break;
        }
    for (const Departure& d : timeline.departures())
        if (d.body == 0)
            until = std::min(until, d.time);
    return until;
}

} // namespace

void AimTool::paint(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    if (!isActive())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintWay(painter, pixels, area);
    const QRectF seen = area.adjusted(-60, -60, 60, 60);
    const QRectF arrow(pixels.at(placeOf(AimPart::Ball, ballThrow())),
                       pixels.at(placeOf(AimPart::Direction, ballThrow())));
    // Out of sight, as in the rack's close-up, it costs nothing.
    if (!arrow.normalized().adjusted(-1, -1, 1, 1).intersects(seen))
        return paintValue(painter, pixels, area);
    paintArrow(painter, pixels);
    if (pixels.length(1) > smallScale)
        paintRotation(painter, pixels);
    for (int k = 0; k < aimPartCount; ++k)
        paintHandle(painter, pixels, AimPart(k));
    paintValue(painter, pixels, area);
}

void AimTool::paintWay(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    const Appearance& look = m_context.appearance;
    const Timeline& timeline = m_context.session.timeline();
    const double until = firstTouch(timeline);
    const QColor ink = look.textInk(Ink::First);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ink, look.projector() ? 2 : 1, Qt::SolidLine, Qt::FlatCap));
    const std::vector<QLineF> lines = wayOf(timeline, until, pixels, area);
    painter.drawLines(lines.data(), int(lines.size()));
    const double radius = pixels.length(regulation::ballRadius);
    if (radius < 3 || !(until > 0))
        return;
    const QPointF there = pixels.at(timeline.bodyAt(0, until).position);
    if (!area.adjusted(-radius, -radius, radius, radius).contains(there))
        return;
    painter.setPen(QPen(faded(ink, 0.6), 1));
    painter.drawEllipse(there, radius, radius);
}

void AimTool::paintArrow(QPainter& painter, const Pixels& pixels) const {
    const Appearance& look = m_context.appearance;
    const Throw& t = ballThrow();
    const Vec2d ball = placeOf(AimPart::Ball, t), tip = placeOf(AimPart::Direction, t);
    const Vec2d way = tip - ball;
    const Vec2d rim = ball + way * (regulation::ballRadius / norm(way));
    const QColor ink = look.accent();
    thetalane::paintArrow(painter, pixels.at(rim), pixels.at(tip),
                          {faded(ink, 0.55), look.lineWidth() * 0.75, false});
    // As far as the bead it is the speed's.
    painter.setPen(QPen(ink, 1.5 * look.lineWidth(), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(pixels.at(rim), pixels.at(placeOf(AimPart::Speed, t)));
}

// A ring about the ball, from the forward roll round to the axis, and out to the bead.
void AimTool::paintRotation(QPainter& painter, const Pixels& pixels) const {
    const Appearance& look = m_context.appearance;
    const Throw& t = ballThrow();
    const QPointF centre = pixels.at(placeOf(AimPart::Ball, t));
    const double ring = pixels.length(rotationRing);
    const QRectF box(centre - QPointF(ring, ring), QSizeF(2 * ring, 2 * ring));
    const double forward = 90 - t.direction / perDegree; // counterclockwise from the right, as Qt counts
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(faded(look.accent(), 0.35), 0.75 * look.lineWidth()));
    painter.drawArc(box, int((forward - 90) * 16), 180 * 16);
    painter.setPen(QPen(look.accent(), 1.5 * look.lineWidth(), Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(box, int(forward * 16), int(t.axis / perDegree * 16));
    const QPointF bead = pixels.at(placeOf(AimPart::Rotation, t));
    const Vec2d out = pullOf(t);
    painter.drawLine(centre + QPointF(out.x, -out.y) * ring, bead);
}

void AimTool::paintHandle(QPainter& painter, const Pixels& pixels, AimPart part) const {
    const Appearance& look = m_context.appearance;
    const bool small = pixels.length(1) < smallScale;
    if (small && part == AimPart::Rotation)
        return;
    const QPointF at = pixels.at(placeOf(part, ballThrow()));
    const bool held = m_gesture && m_gesture->part == part;
    const double bead = (small ? 3 : 2.5) * look.lineWidth();
    const double radius =
        part == AimPart::Ball ? std::max(pixels.length(regulation::ballRadius), bead) : bead;
    if (held || (!m_gesture && m_hovered == part)) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(faded(look.accent(), held ? 0.4 : 0.25));
        painter.drawEllipse(at, radius + 3 * look.lineWidth(), radius + 3 * look.lineWidth());
    }
    if (m_focused == part) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(look.accent(), look.lineWidth()));
        const double ring = radius + 2.5 * look.lineWidth();
        painter.drawEllipse(at, ring, ring);
    }
    if (part == AimPart::Ball)
        return; // it is drawn already
    painter.setPen(QPen(look.accent(), look.lineWidth()));
    painter.setBrush(part == AimPart::Direction ? look.accent() : look.card());
    painter.drawEllipse(at, radius, radius);
}

// Beside the part; where that is out of sight or hidden by the edge, at the foot of the view.
void AimTool::paintValue(QPainter& painter, const Pixels& pixels, const QRectF& area) const {
    const auto part = shownPart();
    const Appearance& look = m_context.appearance;
    if (!part)
        return;
    QStringList lines{valueText(*part)};
    if (m_limit != AimLimit::None)
        lines << limitText();
    const QFont font = look.font(Appearance::Size::Normal, true);
    const QFont second = look.font(Appearance::Size::Small);
    const QFontMetricsF metrics(font), smaller(second);
    double width = metrics.horizontalAdvance(lines.front());
    if (lines.size() > 1)
        width = std::max(width, smaller.horizontalAdvance(lines.back()));
    const double pad = 0.75 * look.unit();
    const QSizeF size(width + 2 * pad, metrics.height() + (lines.size() > 1 ? smaller.height() : 0) + pad);
    // The corners above are the badge's.
    const QRectF room = area.adjusted(4, 4, -4, -4);
    const double top = room.top() + 7 * look.unit();
    if (size.width() > room.width())
        return; // the strip: the large view says it
    const QPointF at = pixels.at(placeOf(*part, ballThrow()));
    QRectF box(at + QPointF(3 * look.unit(), -size.height() / 2), size);
    if (!room.contains(at))
        box.moveCenter({room.center().x(), room.bottom() - 7 * look.unit()});
    if (box.right() > room.right())
        box.moveRight(at.x() - 3 * look.unit());
    box.moveTop(std::clamp(box.top(), top, std::max(top, room.bottom() - box.height())));
    box.moveLeft(std::clamp(box.left(), room.left(), room.right() - box.width()));
    painter.setPen(QPen(m_limit == AimLimit::None ? look.line() : look.error(), 1));
    painter.setBrush(faded(look.card(), 0.95));
    painter.drawRoundedRect(box, 5, 5);
    painter.setFont(font);
    painter.setPen(look.text());
    painter.drawText(box.topLeft() + QPointF(pad, pad / 2 + metrics.ascent()), lines.front());
    if (lines.size() > 1) {
        painter.setFont(second);
        painter.setPen(look.error());
        painter.drawText(box.topLeft() + QPointF(pad, pad / 2 + metrics.height() + smaller.ascent()),
                         lines.back());
    }
}

} // namespace thetalane
