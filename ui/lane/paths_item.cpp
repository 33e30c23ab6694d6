#include "ui/lane/paths_item.h"

#include "ui/lane/arrow.h"
#include "ui/lane/scale.h"

#include <algorithm>

namespace thetalane {
namespace {

constexpr std::size_t mostBodies = 60;   // more paths than that are a tangle, not a picture
constexpr std::size_t walkedPoints = 12; // in a closed frame the oldest stretches are let go
constexpr std::size_t comingPoints = 3;  // and of what will come, the next few stretches are shown
constexpr int curvePieces = 24;

} // namespace

PathsItem::PathsItem(const Appearance& appearance)
    : m_appearance(appearance) {
    setZValue(0);
}

void PathsItem::build(const Run& run, double until, std::vector<Ink> inks) {
    prepareGeometryChange();
    m_paths.clear();
    m_bounds = {};
    if (run.scene.bodies.size() > mostBodies)
        return;
    m_paths.resize(run.scene.bodies.size());
    for (std::size_t i = 0; i < m_paths.size(); ++i) {
        Path& path = m_paths[i];
        path.ink = inks[i];
        path.pin = run.scene.bodies[i].kind == BodyKind::Pin;
        const auto add = [&](double t) {
            path.times.push_back(t);
            path.points.push_back(toUnits(run.timeline.bodyAt(i, t).position));
            m_bounds |= QRectF(path.points.back(), QSizeF(1, 1));
        };
        const auto segments = run.timeline.segments(i);
        for (std::size_t s = 0; s < segments.size() && segments[s].start < until; ++s) {
            const double from = segments[s].start;
            const double to = std::min(s + 1 < segments.size() ? segments[s + 1].start : until, until);
            const bool straight = segments[s].acceleration == Vec2d{};
            const int pieces = straight ? 1 : curvePieces;
            for (int k = 0; k < pieces; ++k)
                add(from + (to - from) * k / pieces);
        }
        add(until);
    }
    m_bounds.adjust(-100, -100, 100, 100);
}

void PathsItem::setTime(double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < m_paths.size(); ++i) {
        Path& path = m_paths[i];
        const auto next = std::upper_bound(path.times.begin(), path.times.end(), time);
        path.next = std::size_t(next - path.times.begin());
        path.now = toUnits(states[i].position);
        path.moving = !(states[i].velocity == Vec2d{});
    }
    update();
}

void PathsItem::setReceding(bool receding) {
    m_receding = receding;
    update();
}

void PathsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
    if (m_receding)
        return; // the step overlay needs the room
    const QTransform toPixels = painter->worldTransform();
    const Pixels pixels(*painter);
    for (const Path& path : m_paths) {
        const QColor colour =
            path.ink == Ink::Plain ? m_appearance.quietText() : m_appearance.textInk(path.ink);
        painter->setRenderHint(QPainter::Antialiasing, true);
        // A width of 1 is Qt's fast way; the projector's lines have to be seen first.
        const double width = m_appearance.projector() ? 2 : 1;
        painter->setPen(
            QPen(faded(colour, m_appearance.projector() ? 0.5 : 0.75), width, Qt::SolidLine, Qt::FlatCap));
        collectWalked(path, toPixels);
        painter->drawLines(m_lines.data(), int(m_lines.size()));

        painter->setRenderHint(QPainter::Antialiasing, false);
        painter->setPen(Qt::NoPen);
        painter->setBrush(faded(colour, 0.6));
        collectToCome(path, toPixels, QRectF(painter->viewport()));
        painter->drawRects(m_dots.data(), int(m_dots.size()));
    }
}

// Single lines and not a polyline, squares and not a dotted pen: Qt paints them many times as fast.
void PathsItem::collectWalked(const Path& path, const QTransform& toPixels) {
    m_lines.clear();
    const std::size_t first = path.next > walkedPoints ? path.next - walkedPoints : 0;
    for (std::size_t k = first; k < path.next; ++k) {
        const QPointF to = k + 1 < path.next ? path.points[k + 1] : path.now;
        if (to != path.points[k])
            m_lines.emplace_back(toPixels.map(path.points[k]), toPixels.map(to));
    }
}

void PathsItem::collectToCome(const Path& path, const QTransform& toPixels, const QRectF& area) {
    m_dots.clear();
    if (path.pin && !path.moving)
        return; // ten pins that rest would fill the rack with what is yet to happen
    QPointF from = path.now;
    const std::size_t end = std::min(path.points.size(), path.next + comingPoints);
    for (std::size_t k = path.next; k < end; ++k) {
        addDots(QLineF(toPixels.map(path.points[k]), toPixels.map(from)), area);
        from = path.points[k];
    }
}

// Counted from where the body will arrive, so that the dots stand still while it eats them up.
void PathsItem::addDots(const QLineF& line, const QRectF& area) {
    const double length = line.length();
    const int dot = int(m_appearance.lineWidth());
    const double step = 4 * m_appearance.lineWidth();
    if (length < dot)
        return;
    const QPointF along = (line.p2() - line.p1()) / length;
    const QRectF box = QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1);
    if (!box.intersects(area))
        return;
    // Of a line that leaves the view by far, only what can be seen.
    const double reach = area.width() + area.height();
    const QPointF toMiddle = area.center() - line.p1();
    const double middle = QPointF::dotProduct(toMiddle, along);
    const double first = std::max(0.0, std::floor((middle - reach) / step) * step);
    const double last = std::min(length - dot, middle + reach);
    for (double s = first; s <= last; s += step) {
        const QPointF at = line.p1() + along * s;
        if (area.contains(at))
            m_dots.emplace_back(int(at.x()), int(at.y()), dot, dot);
    }
}

} // namespace thetalane
