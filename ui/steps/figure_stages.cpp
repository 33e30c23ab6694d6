#include "ui/steps/stage_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {

using Size = Appearance::Size;

// The triangle a, b, Z between the centres, θ at the second one, from x to the line of centres.
void StageDrawing::contact() {
    const double second = m_s.second.radius * m_metre;
    const QPointF foot = m_origin - m_along * second; // the second centre, or the point of the wall
    const QPointF centre = at(m_parties[0]);
    const QPointF corner(centre.x(), foot.y());
    const QColor amber = m_appearance.ink(Ink::Triangle);
    const auto letter = [](const char* text) { return symbol(QString::fromUtf8(text), Ink::Triangle); };
    for (const Party& p : m_parties) {
        m_canvas.dot(at(p), m_appearance.ink(p.ink));
        m_canvas.label(upright(indexName(m_scene, p.body), p.ink), at(p),
                       p.body == m_collision.first ? m_along : -m_along, Size::Large);
    }
    const double degrees = std::atan2(m_s.contact.sinTheta, m_s.contact.cosTheta) * 180 / std::numbers::pi;
    const QPointF centroid = (foot + centre + corner) / 3;
    const QPointF normal(-m_along.y(), m_along.x());
    const bool level = std::abs(m_s.contact.b) <= 0.02 * m_s.contact.Z;
    const QPointF away = level                                              ? QPointF(0, -1)
                         : QPointF::dotProduct(centroid - foot, normal) > 0 ? -normal
                                                                            : normal;
    m_canvas.line(foot, corner, amber, m_wide, Qt::DashLine);
    m_canvas.line(corner, centre, amber, m_wide, Qt::DashLine);
    m_canvas.line(foot, centre, amber, 1.2 * m_wide);
    const double radius = std::min(0.34 * m_metre * m_s.contact.Z, 46.0);
    if (degrees != 0) {
        m_canvas.line(foot, foot + QPointF(1.25 * radius, 0), m_appearance.quietText(), 1);
        m_canvas.arc(foot, radius, 0, degrees, amber);
    }
    const double half = degrees / 2 * std::numbers::pi / 180;
    m_canvas.label(letter("Z"), (foot + centre) / 2, away, Size::Normal);
    if (std::abs(m_s.contact.a) > 0.02 * m_s.contact.Z)
        m_canvas.label(letter("a"), (foot + corner) / 2, {0, level || foot.y() > centre.y() ? 1.0 : -1.0},
                       Size::Normal);
    if (std::abs(m_s.contact.b) > 0.02 * m_s.contact.Z)
        m_canvas.label(letter("b"), (corner + centre) / 2, {corner.x() > foot.x() ? 1.0 : -1.0, 0},
                       Size::Normal);
    m_canvas.label(row({letter("θ"), op("="), number(degrees, Ink::Triangle), upright("°")}),
                   foot + radius * QPointF(std::cos(half), -std::sin(half)),
                   {std::cos(half), -std::sin(half)}, Size::Small);
    scaleArrow(m_metre, "m");
}

void StageDrawing::split() {
    for (const Party& p : m_parties) {
        const QPointF x = at(p) + m_speed * flipped({p.before.x, 0});
        const QPointF y = at(p) + m_speed * flipped({0, p.before.y});
        const QPointF sum = at(p) + m_speed * flipped(p.before);
        const QColor color = faint(m_appearance.ink(p.ink), 0.8f);
        if (p.before.x != 0 && p.before.y != 0) {
            m_canvas.line(x, sum, m_appearance.line(), 1, Qt::DotLine);
            m_canvas.line(y, sum, m_appearance.line(), 1, Qt::DotLine);
            for (const auto& [tip, axis] : {std::pair{x, "x"}, {y, "y"}}) {
                m_canvas.arrow(at(p), tip, color, 0.8 * m_wide, ArrowHead::Open, Qt::DashLine);
                symbolAt(p, axis, When::Before, at(p), tip);
            }
        }
        velocity(p, p.before, When::Before);
    }
}

void StageDrawing::rotation() {
    axes(false);
    for (const Party& p : m_parties) {
        velocity(p, p.before, When::Before);
        if (!(p.before == Vec2d{}))
            components(p, p.rotated, When::Before);
    }
}

// x′ before (faint) beside x′ after; y′ as it was, or both where another impulse of the pass changed it.
void StageDrawing::exchange() {
    axes(true);
    const QPointF aside = m_across * (1.6 * m_wide + 2);
    for (const Party& p : m_parties) {
        const QPointF before = at(p) + m_speed * turned({p.rotated.x, 0});
        const QPointF after = at(p) + m_speed * turned({p.exchanged.x, 0});
        const QPointF across = at(p) + m_speed * turned({0, p.exchanged.y});
        const QColor green = m_appearance.ink(Ink::Along);
        m_canvas.arrow(at(p) + aside, before + aside, faint(green), m_wide);
        m_canvas.arrow(at(p) - aside, after - aside, green, m_wide);
        m_canvas.arrow(at(p), across, m_appearance.ink(Ink::Across), m_wide, ArrowHead::Open, Qt::DashLine);
        if (std::abs(p.exchanged.y - p.rotated.y) * m_speed > 1) {
            const QPointF was = at(p) + m_speed * turned({0, p.rotated.y}) + m_along * (1.6 * m_wide + 2);
            m_canvas.arrow(at(p) + m_along * (1.6 * m_wide + 2), was, faint(m_appearance.ink(Ink::Across)),
                           m_wide, ArrowHead::Open, Qt::DashLine);
        }
        symbolAt(p, "x′", When::Before, at(p) + aside, before + aside, aside);
        symbolAt(p, "x′", When::After, at(p) - aside, after - aside, -aside);
        symbolAt(p, "y′", When::After, at(p), across);
    }
}

void StageDrawing::rotationBack() {
    axes(true);
    for (const Party& p : m_parties) {
        components(p, p.exchanged, When::After);
        velocity(p, p.after, When::After);
    }
}

// Tip to tail: the momenta before and after from one origin; both sums end at the same point. At a wall the
// impulse stands between the two. Of contacts resolved together, all the bodies of the pass.
void StageDrawing::momentum() {
    const std::vector<PassBody> bodies = bodiesOf(m_pass);
    std::vector<Vec2d> before{{}};
    std::vector<Vec2d> after{{}};
    for (const PassBody& b : bodies) {
        before.push_back(before.back() + b.mass * b.before);
        after.push_back(after.back() + b.mass * b.after);
    }
    std::vector<QPointF> all;
    for (const auto* chain : {&before, &after})
        for (const Vec2d& v : *chain)
            all.push_back(flipped(v));
    const QRectF box = boundsOf(all);
    const double scale = std::min(box.width() > 0 ? m_room.width() / box.width() : 1e300,
                                  box.height() > 0 ? m_room.height() / box.height() : 1e300);
    if (!(scale < 1e300))
        return;
    const QPointF origin = m_room.center() - box.center() * scale;
    constexpr std::size_t mostNamed = 6; // more letters than that find no place
    const auto chain = [&](const std::vector<Vec2d>& points, When when) {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const QPointF from = origin + scale * flipped(points[i]);
            const QPointF to = origin + scale * flipped(points[i + 1]);
            const bool isAfter = when == When::After;
            const QPointF along = to - from;
            if (std::hypot(along.x(), along.y()) < 3)
                continue;
            const int body = bodies[i].body;
            const Ink ink = body == m_collision.first    ? Ink::First
                            : body == m_collision.second ? Ink::Second
                                                         : Ink::Plain;
            const QColor color = ink == Ink::Plain ? m_appearance.quietText() : m_appearance.ink(ink);
            m_canvas.arrow(from, to, color, m_wide, isAfter ? ArrowHead::Filled : ArrowHead::Open,
                           isAfter ? Qt::SolidLine : Qt::DashLine);
            if (bodies.size() > mostNamed && ink == Ink::Plain)
                continue;
            m_canvas.label(script(symbol("p", ink), upright(indexName(m_scene, body), ink),
                                  isAfter ? symbol("′") : Formula{}),
                           from + 0.5 * along, QPointF(-along.y(), along.x()) * (isAfter ? 1 : -1),
                           Size::Normal);
        }
    };
    const auto plain = [&](QPointF from, QPointF to, const Formula& name, const QColor& color, double wide) {
        const QPointF along = to - from;
        if (std::hypot(along.x(), along.y()) < 3)
            return;
        m_canvas.arrow(from, to, color, wide * m_wide);
        m_canvas.label(name, from + 0.35 * along, QPointF(-along.y(), along.x()), Size::Normal);
    };
    const bool wall =
        std::any_of(m_pass.begin(), m_pass.end(), [](const Collision& c) { return c.isWall(); });
    if (wall)
        plain(origin + scale * flipped(before.back()), origin + scale * flipped(after.back()),
              symbol("I", Ink::Along), m_appearance.ink(Ink::Along), 1);
    else
        plain(origin, origin + scale * flipped(before.back()),
              row({symbol("p"), op("="), script(symbol("p"), {}, symbol("′"))}),
              faint(m_appearance.quietText(), 0.4f), 3);
    chain(before, When::Before);
    chain(after, When::After);
    m_canvas.dot(origin, m_appearance.text());
    scaleArrow(scale, "kg·m/s");
}

FigureCanvas StageDrawing::draw(Stage stage) {
    const double side = std::min(m_room.width(), m_room.height());
    const double reach = m_s.first.radius + m_s.second.radius;
    const double across = 2 * std::max(m_s.first.radius, m_s.second.radius);
    if (stage == Stage::Contact) {
        place(side); // provisional: then as large as fits
        const QRectF box = boundsOf(discPoints());
        const double grow = std::min(m_room.width() / box.width(), (m_room.height() + 8) / box.height());
        place(side * grow);
        centreOn(discPoints());
    } else {
        place(0.4 * side * std::min(1.0, reach / across * 1.2));
        fitVectors();
        if (stage != Stage::Check)
            centreOn(extent(stage, m_speed));
    }
    if (stage != Stage::Check && stage != Stage::Contact)
        scaleArrow(m_speed, "m/s");
    if (stage != Stage::Check)
        bodies();
    switch (stage) {
    case Stage::Contact:
        contact();
        break;
    case Stage::Split:
        split();
        break;
    case Stage::Rotation:
        rotation();
        break;
    case Stage::Exchange:
        exchange();
        break;
    case Stage::RotationBack:
        rotationBack();
        break;
    case Stage::Check:
        momentum();
        break;
    }
    m_canvas.settle();
    return std::move(m_canvas);
}

FigureCanvas stageFigure(const Scene& scene, std::span<const Collision> collisions, std::size_t index,
                         Stage stage, const Appearance& appearance, QSizeF size) {
    return StageDrawing(scene, collisions[index], passOf(collisions, index), appearance, size).draw(stage);
}

} // namespace thetalane
