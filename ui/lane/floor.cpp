#include "ui/lane/floor.h"

#include "ui/lane/arrow.h"
#include "ui/lane/bands.h"
#include "ui/lane/scale.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <vector>

namespace thetalane {
namespace {

// USBC equipment specifications: seven arrows 12 to 16 ft past the foul line on every fifth board, ten dots
// 7 ft past it on boards 3, 5, 8, 11 and 14 of each side.
constexpr int boards = 39;
constexpr double middleArrow = 4.83;
constexpr double arrowStep = 0.34;
constexpr double dotRow = 2.134;
constexpr int dotBoards[] = {3, 5, 8, 11, 14};
constexpr double approach = 4.572; // 15 ft before the foul line
constexpr double deckBefore = 0.15;

// Hairlines lie on whole pixels, and a wide run of them costs one call each.
void paintGrid(QPainter& painter, const Pixels& px, const Appearance& look, const QRectF& inside) {
    const double step = roundLength(1.25 * 64 / px.length(1));
    const Vec2d from = px.metres(inside.bottomLeft());
    const Vec2d to = px.metres(inside.topRight());
    painter.setPen(QPen(faded(look.line(), look.projector() ? 0.3 : 0.55), 1));
    for (double k = std::ceil(from.x / step); k * step <= to.x; ++k) {
        const double x = std::round(px.at({k * step, 0}).x()) + 0.5;
        painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
    }
    for (double k = std::ceil(from.y / step); k * step <= to.y; ++k) {
        const double y = std::round(px.at({0, k * step}).y()) + 0.5;
        painter.drawLine(QPointF(inside.left(), y), QPointF(inside.right(), y));
    }
}

void paintHatch(QPainter& painter, const QRectF& band, const QColor& colour, double step) {
    painter.save();
    painter.setClipRect(band, Qt::IntersectClip);
    painter.setPen(QPen(colour, 1.2));
    const double reach = band.height();
    for (double x = std::floor((band.left() - reach) / step) * step; x < band.right(); x += step)
        painter.drawLine(QPointF(x, band.bottom()), QPointF(x + reach, band.top()));
    painter.restore();
}

// The solid outside of each wall that is there, hatched, and its edge.
void paintFrame(QPainter& painter, const Pixels& px, const Frame& frame, const Appearance& look,
                const QRectF& all) {
    const double far = 1e7;
    const QRectF inner = px.rect({frame.left.value_or(-far), frame.bottom.value_or(-far)},
                                 {frame.right.value_or(far), frame.top.value_or(far)});
    const double thick = 1.25 * look.unit();
    const QRectF inside = inner & all;
    QPainterPath outside;
    outside.addRect(all);
    QPainterPath hole;
    hole.addRect(inside);
    painter.fillPath(outside - hole, look.window());

    const QColor hatch = mixed(look.quietText(), look.window(), 0.45);
    painter.setClipPath(outside - hole);
    const QRectF shell = inside.adjusted(frame.left ? -thick : 0, frame.top ? -thick : 0,
                                         frame.right ? thick : 0, frame.bottom ? thick : 0);
    paintHatch(painter, shell, hatch, 0.75 * look.unit());
    painter.setClipping(false);

    painter.setPen(
        QPen(mixed(look.quietText(), look.card(), 0.85), look.lineWidth(), Qt::SolidLine, Qt::SquareCap));
    if (frame.left)
        painter.drawLine(inside.topLeft(), inside.bottomLeft());
    if (frame.right)
        painter.drawLine(inside.topRight(), inside.bottomRight());
    if (frame.bottom)
        painter.drawLine(inside.bottomLeft(), inside.bottomRight());
    if (frame.top)
        painter.drawLine(inside.topLeft(), inside.topRight());
}

void paintPinSpots(QPainter& painter, const Pixels& px, const Scene& scene, const Appearance& look) {
    if (px.length(0.02) < 2)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(mixed(look.quietText(), look.wood(), 0.2));
    for (const Body& body : scene.bodies)
        if (body.kind == BodyKind::Pin) {
            const double r = px.length(body.radius * 0.2);
            painter.drawEllipse(px.at(body.position), r, r);
        }
}

double boardCentre(const Lane& lane, int board) {
    return lane.left + (board - 0.5) * (lane.right - lane.left) / boards;
}

void paintBoards(QPainter& painter, const Pixels& px, const Lane& lane, const Appearance& look,
                 const QRectF& all) {
    const double board = (lane.right - lane.left) / boards;
    if (px.length(board) < 4)
        return;
    const QRectF wood = px.rect({lane.left, lane.foulLine - approach}, {lane.right, lane.end}) & all;
    painter.setPen(QPen(faded(look.woodLine(), 0.75), 1));
    for (int k = 1; k < boards; ++k) {
        const double x = px.at({lane.left + k * board, 0}).x();
        painter.drawLine(QPointF(x, wood.top()), QPointF(x, wood.bottom()));
    }
}

void paintMarks(QPainter& painter, const Pixels& px, const Lane& lane, const Appearance& look) {
    const QColor mark = mixed(look.quietText(), look.wood(), 0.6);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark);
    const double unit = std::max(px.length(0.012), 1.0);
    for (int k = -3; k <= 3; ++k) {
        const QPointF tip =
            px.at({boardCentre(lane, 20 + 5 * k), lane.foulLine + middleArrow - arrowStep * std::abs(k)});
        const QPointF corners[] = {tip, tip + QPointF(1.6 * unit, 6 * unit),
                                   tip + QPointF(-1.6 * unit, 6 * unit)};
        painter.drawPolygon(corners, 3);
    }
    for (const int board : dotBoards)
        for (const int b : {board, boards + 1 - board})
            painter.drawEllipse(px.at({boardCentre(lane, b), lane.foulLine + dotRow}), unit * 0.8,
                                unit * 0.8);
    const QPointF foul[] = {px.at({lane.left, lane.foulLine}), px.at({lane.right, lane.foulLine})};
    painter.setPen(QPen(look.text(), std::max(1.0, px.length(0.01))));
    painter.drawLine(foul[0], foul[1]);
}

// A film of oil: cooler than the wood, with a sheen that runs along the lane, and its edges drawn thin.
void paintOil(QPainter& painter, const Pixels& px, const Scene& scene, const Appearance& look,
              const QRectF& all) {
    const QColor tint = mixed(look.ink(Ink::First), look.quietText(), 0.55);
    const double strength = look.projector() ? 0.2 : 0.13;
    constexpr double far = 1e5;
    for (const OilZone& zone : scene.friction->oil) {
        const double left = scene.lane ? scene.lane->left : -far;
        const double right = scene.lane ? scene.lane->right : far;
        const QRectF film = px.rect({left, zone.from}, {right, zone.to}) & all;
        if (film.isEmpty())
            continue;
        painter.fillRect(film, faded(tint, strength));
        if (scene.lane) {
            const QRectF whole = px.rect({left, zone.from}, {right, zone.to});
            QLinearGradient sheen(whole.topLeft(), whole.topRight());
            for (const auto& [at, share] : {std::pair{0.0, 0.0},
                                            {0.3, 0.0},
                                            {0.42, 0.5},
                                            {0.5, 0.1},
                                            {0.58, 0.32},
                                            {0.7, 0.0},
                                            {1.0, 0.0}})
                sheen.setColorAt(at, faded(QColor(Qt::white), share));
            painter.fillRect(film, sheen);
        }
        painter.setPen(QPen(faded(tint, 0.75), look.projector() ? 2 : 1, Qt::DashLine));
        for (const double y : {zone.from, zone.to}) {
            const double at = px.at({0, y}).y();
            if (at > all.top() && at < all.bottom())
                painter.drawLine(QPointF(film.left(), at), QPointF(film.right(), at));
        }
    }
}

// What the film is, at its far end, where it has room for that.
void paintOilWords(QPainter& painter, const Pixels& px, const Scene& scene, const Appearance& look) {
    painter.setFont(look.font(Appearance::Size::Small));
    painter.setPen(mixed(look.ink(Ink::First), look.text(), 0.35));
    const QFontMetricsF metrics(painter.font());
    const double inset = 0.75 * look.unit();
    const double left = scene.lane ? scene.lane->left : scene.frame ? scene.frame->left.value_or(0) : 0;
    for (const OilZone& zone : scene.friction->oil) {
        const QString words =
            QCoreApplication::translate("thetalane::Floor", "oil, μ = %1").arg(numberText(zone.friction));
        const double wide = metrics.horizontalAdvance(words) + 2 * inset;
        if (scene.lane && px.length(scene.lane->right - scene.lane->left) < wide)
            continue;
        if (px.length(zone.to - zone.from) > metrics.height() + inset)
            painter.drawText(px.at({left, zone.to}) + QPointF(inset, metrics.ascent() + inset / 2), words);
    }
}

// Plates that stand over the outer edges of the gutters.
void paintKickbacks(QPainter& painter, const Pixels& px, const Lane& lane, const Appearance& look) {
    constexpr double thickness = 0.05; // [m] as drawn
    const double outer = lane.gutterWidth;
    const double thick = std::max(px.length(thickness), 2 * look.lineWidth());
    const QColor plate = mixed(look.text(), look.quietText(), 0.4);
    const double top = px.at({0, lane.end}).y();
    const double bottom = px.at({0, lane.kickbacks->from}).y();
    const double left = px.at({lane.left - outer, 0}).x();
    const double right = px.at({lane.right + outer, 0}).x();
    for (const QRectF& band :
         {QRectF(left - thick, top, thick, bottom - top), QRectF(right, top, thick, bottom - top)}) {
        painter.fillRect(band, mixed(plate, look.window(), 0.35));
        paintHatch(painter, band, mixed(plate, look.window(), 0.8), 0.75 * look.unit());
    }
    painter.setPen(QPen(plate, look.lineWidth(), Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(left, top), QPointF(left, bottom));
    painter.drawLine(QPointF(right, top), QPointF(right, bottom));
}

// Wood, gutters, oil and pit: the same along the lane, but where one of them begins or ends.
void paintGround(QPainter& painter, const Pixels& px, const Scene& scene, const Lane& lane,
                 const Appearance& look, const QRectF& all) {
    painter.fillRect(all, look.window());
    const double start = lane.foulLine - approach;
    const double outer = lane.gutterWidth;
    painter.fillRect(px.rect({lane.left - outer, start}, {lane.right + outer, lane.foulLine}), look.wood());
    for (const double x : {lane.left - outer, lane.right}) {
        const QRectF gutter = px.rect({x, lane.foulLine}, {x + outer, lane.end});
        QLinearGradient round(gutter.topLeft(), gutter.topRight());
        const QColor deep = look.gutter().darker(116);
        round.setColorAt(0, deep);
        round.setColorAt(0.5, look.gutter());
        round.setColorAt(1, deep);
        painter.fillRect(gutter, round);
    }
    painter.fillRect(px.rect({lane.left, lane.foulLine}, {lane.right, lane.end}), look.wood());
    painter.fillRect(px.rect({lane.left, -deckBefore}, {lane.right, lane.end}),
                     mixed(look.woodLine(), look.wood(), 0.35));
    paintBoards(painter, px, lane, look, all);
    if (scene.friction)
        paintOil(painter, px, scene, look, all);
    painter.fillRect(px.rect({lane.left - outer, lane.end}, {lane.right + outer, lane.end + lane.pitDepth}),
                     mixed(look.dark() ? look.window() : look.quietText(), look.gutter(), 0.55));
}

void paintLane(QPainter& painter, const Pixels& px, const Scene& scene, const Lane& lane,
               const Appearance& look, const QRectF& all) {
    const double start = lane.foulLine - approach;
    const double outer = lane.gutterWidth;
    std::vector<double> heights{start, lane.foulLine, -deckBefore, lane.end, lane.end + lane.pitDepth};
    if (scene.friction)
        for (const OilZone& zone : scene.friction->oil)
            heights.insert(heights.end(), {zone.from, zone.to});
    std::vector<double> borders;
    for (const double y : heights)
        borders.push_back(px.at({0, y}).y());
    constexpr double widestLine = 4; // of the oil's edges, and to spare
    paintInBands(painter, all, std::move(borders), widestLine,
                 [&](QPainter& p, const QRectF& part) { paintGround(p, px, scene, lane, look, part); });
    paintMarks(painter, px, lane, look);
    const QRectF sides = px.rect({lane.left - outer, start}, {lane.right + outer, lane.end + lane.pitDepth});
    painter.setPen(QPen(mixed(look.quietText(), look.gutter(), 0.5), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(sides);
    if (lane.kickbacks)
        paintKickbacks(painter, px, lane, look);
}

} // namespace

double roundLength(double most) {
    const double ten = std::pow(10, std::floor(std::log10(most)));
    for (const double k : {5.0, 2.0})
        if (k * ten <= most)
            return k * ten;
    return ten;
}

Scene floorOf(const Scene& scene) {
    Scene floor;
    floor.lane = scene.lane;
    floor.frame = scene.frame;
    floor.friction = scene.friction;
    for (const Body& body : scene.bodies)
        if (body.kind == BodyKind::Pin) // its spot
            floor.bodies.push_back({body.id, body.kind, body.mass, body.radius, body.position, {}});
    return floor;
}

void paintFloor(QPainter& painter, const Scene& scene, const Appearance& look, const QRectF& exposed) {
    const QRectF all = painter.worldTransform().mapRect(exposed).adjusted(-2, -2, 2, 2);
    painter.setRenderHint(QPainter::Antialiasing);
    const Pixels px(painter);
    if (scene.lane) {
        paintLane(painter, px, scene, *scene.lane, look, all);
    } else {
        painter.fillRect(all, look.floor());
        paintGrid(painter, px, look, all);
        if (scene.friction)
            paintOil(painter, px, scene, look, all);
        if (scene.frame)
            paintFrame(painter, px, *scene.frame, look, all);
    }
    paintPinSpots(painter, px, scene, look);
    if (scene.friction)
        paintOilWords(painter, px, scene, look);
}

void paintScaleBar(QPainter& painter, double pixelsPerMetre, const QPointF& corner, const Appearance& look) {
    const double metres = roundLength(100 / pixelsPerMetre);
    const double length = metres * pixelsPerMetre;
    const double tick = 0.75 * look.unit();
    const QPointF left = corner + QPointF(0, -tick / 2);
    painter.setPen(QPen(look.quietText(), look.lineWidth() * 0.75, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(left, left + QPointF(length, 0));
    painter.drawLine(left - QPointF(0, tick / 2), left + QPointF(0, tick / 2));
    painter.drawLine(left + QPointF(length, -tick / 2), left + QPointF(length, tick / 2));
    painter.setFont(look.font(Appearance::Size::Small));
    painter.drawText(left + QPointF(0, -tick), QString("%1 m").arg(metres));
}

void paintSpeedScale(QPainter& painter, double pixelsPerSpeed, const QPointF& corner,
                     const Appearance& look) {
    if (!(pixelsPerSpeed > 0) || !std::isfinite(pixelsPerSpeed))
        return;
    const double speed = roundLength(90 / pixelsPerSpeed);
    const double tick = 0.75 * look.unit();
    const QPointF left = corner + QPointF(0, -tick / 2);
    paintArrow(painter, left, left + QPointF(speed * pixelsPerSpeed, 0),
               {look.quietText(), look.lineWidth() * 0.75, false});
    painter.setPen(look.quietText());
    painter.setFont(look.font(Appearance::Size::Small));
    painter.drawText(left + QPointF(0, -tick), QString("%1 m/s").arg(speed));
}

} // namespace thetalane
