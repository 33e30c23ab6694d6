#include "ui/lane/paths_item.h"

#include "ui/lane/arrow.h"
#include "ui/lane/scale.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr std::size_t mostBodies = 60;      // more paths than that are a tangle, not a picture
constexpr std::size_t walkedStretches = 12; // in a closed frame the oldest are let go
constexpr std::size_t comingStretches = 3;  // and of what will come, the next few are shown
constexpr std::size_t thrownStretches = 40; // of a ball on a lane more: that is what one aims by
constexpr double sag = 0.2;                 // [px] of a piece of a curve

QPointF mixed(const QPointF& a, const QPointF& b, double share) {
    return a + (b - a) * share;
}

} // namespace

PathsItem::PathsItem(const Appearance& appearance)
    : m_appearance(appearance) {
    setZValue(0);
}

void PathsItem::build(const Run& run, double until, std::vector<Ink> inks) {
    prepareGeometryChange();
    m_paths.clear();
    m_bounds = {};
    m_lane = run.scene.lane.has_value();
    if (run.scene.bodies.size() > mostBodies)
        return;
    m_paths.resize(run.scene.bodies.size());
    for (std::size_t i = 0; i < m_paths.size(); ++i) {
        Path& path = m_paths[i];
        path.ink = inks[i];
        path.pin = run.scene.bodies[i].kind == BodyKind::Pin;
        const auto segments = run.timeline.segments(i);
        for (std::size_t k = 0; k < segments.size() && segments[k].start < until; ++k) {
            const Segment& segment = segments[k];
            const double end = std::min(k + 1 < segments.size() ? segments[k + 1].start : until, until);
            const double time = end - segment.start;
            const Vec2d half = segment.position + segment.velocity * (time / 2);
            const Vec2d to = segment.position + (segment.velocity + segment.acceleration * (time / 2)) * time;
            path.stretches.push_back(
                {segment.start, end, toUnits(segment.position), toUnits(half), toUnits(to)});
            for (const QPointF& point : {path.stretches.back().from, path.stretches.back().to})
                m_bounds |= QRectF(point, QSizeF(1, 1));
            if (!(segment.acceleration == Vec2d{}))
                m_bounds |= QRectF(path.stretches.back().control, QSizeF(1, 1));
        }
    }
    m_bounds.adjust(-100, -100, 100, 100);
}

void PathsItem::setTime(double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < m_paths.size(); ++i) {
        Path& path = m_paths[i];
        const auto next = std::upper_bound(path.stretches.begin(), path.stretches.end(), time,
                                           [](double t, const Stretch& s) { return t < s.start; });
        path.next = std::size_t(next - path.stretches.begin());
        path.share = 0;
        if (path.next > 0) {
            const Stretch& now = path.stretches[path.next - 1];
            path.share = now.end > now.start ? std::min(1.0, (time - now.start) / (now.end - now.start)) : 1;
        }
        path.moving = !(states[i].velocity == Vec2d{});
    }
    update();
}

void PathsItem::setFutureHidden(bool hidden) {
    m_futureHidden = hidden;
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
        if (m_futureHidden)
            continue;
        painter->setRenderHint(QPainter::Antialiasing, false);
        painter->setPen(Qt::NoPen);
        painter->setBrush(faded(colour, 0.6));
        collectToCome(path, toPixels, QRectF(painter->viewport()));
        painter->drawRects(m_dots.data(), int(m_dots.size()));
    }
}

// The same parabola, from one time to another.
PathsItem::Stretch PathsItem::Stretch::part(double a, double b) const {
    const auto at = [&](double t) { return mixed(mixed(from, control, t), mixed(control, to, t), t); };
    const QPointF middle = mixed(mixed(from, control, a), mixed(control, to, a), b);
    return {start + (end - start) * a, start + (end - start) * b, at(a), middle, at(b)};
}

// Straight pieces that keep to the curve at this zoom; one where it is straight.
void PathsItem::flatten(const Stretch& stretch, const QTransform& toPixels) {
    const QPointF from = toPixels.map(stretch.from);
    const QPointF control = toPixels.map(stretch.control);
    const QPointF to = toPixels.map(stretch.to);
    constexpr double most = 400;
    const QPointF bend = from - 2 * control + to;
    const double pieces =
        std::clamp(std::ceil(std::sqrt(std::hypot(bend.x(), bend.y()) / (4 * sag))), 1.0, most);
    QPointF last = from;
    for (double k = 1; k <= pieces; ++k) {
        const double t = k / pieces;
        const QPointF point = k < pieces ? mixed(mixed(from, control, t), mixed(control, to, t), t) : to;
        if (point != last)
            m_lines.emplace_back(last, point);
        last = point;
    }
}

// Single lines and not a polyline, squares and not a dotted pen: Qt paints them many times as fast.
void PathsItem::collectWalked(const Path& path, const QTransform& toPixels) {
    m_lines.clear();
    const std::size_t first = path.next > walkedStretches ? path.next - walkedStretches : 0;
    for (std::size_t k = first; k + 1 < path.next; ++k)
        flatten(path.stretches[k], toPixels);
    if (path.next > 0)
        flatten(path.stretches[path.next - 1].part(0, path.share), toPixels);
}

std::vector<QLineF> PathsItem::walkedLines(std::size_t body, const QTransform& toPixels) {
    collectWalked(m_paths[body], toPixels);
    return m_lines;
}

void PathsItem::collectToCome(const Path& path, const QTransform& toPixels, const QRectF& area) {
    m_dots.clear();
    if (path.pin && !path.moving)
        return; // ten pins that rest would fill the rack with what is yet to happen
    const auto add = [&](const Stretch& stretch) {
        m_lines.clear();
        flatten(stretch, toPixels);
        addDots(area);
    };
    if (path.next > 0)
        add(path.stretches[path.next - 1].part(path.share, 1));
    const std::size_t coming = m_lane && !path.pin ? thrownStretches : comingStretches;
    const std::size_t end = std::min(path.stretches.size(), path.next + coming - 1);
    for (std::size_t k = path.next; k < end; ++k)
        add(path.stretches[k]);
}

// Counted from where the body will arrive, so that the dots stand still while it eats them up.
void PathsItem::addDots(const QRectF& area) {
    const int dot = int(m_appearance.lineWidth());
    const double step = 4 * m_appearance.lineWidth();
    double walked = 0; // from the arrival to the piece's end
    for (auto piece = m_lines.rbegin(); piece != m_lines.rend(); ++piece) {
        const double length = piece->length();
        const double before = walked;
        walked += length;
        const QRectF box = QRectF(piece->p1(), piece->p2()).normalized().adjusted(-1, -1, 1, 1);
        if (length == 0 || !box.intersects(area))
            continue;
        const QPointF along = (piece->p1() - piece->p2()) / length;
        // Of a line that leaves the view by far, only what can be seen.
        const double reach = area.width() + area.height();
        const double middle = QPointF::dotProduct(area.center() - piece->p2(), along);
        const bool last = piece + 1 == m_lines.rend(); // no dot hangs over the body
        const double from = std::max(before, before + middle - reach);
        const double to = before + std::min(last ? length - dot : length, middle + reach);
        for (double s = std::ceil(from / step) * step; s < to; s += step) {
            const QPointF at = piece->p2() + along * (s - before);
            if (area.contains(at))
                m_dots.emplace_back(int(at.x()), int(at.y()), dot, dot);
        }
    }
}

} // namespace thetalane
