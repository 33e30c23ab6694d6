#include "ui/steps/stage_drawing.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

using Size = Appearance::Size;

// 1, 2 or 5 times a power of ten: a length for the scale arrow.
double roundLength(double about) {
    const double power = std::pow(10, std::floor(std::log10(about)));
    for (const double step : {5.0, 2.0})
        if (step * power <= about)
            return step * power;
    return power;
}

} // namespace

QRectF boundsOf(const std::vector<QPointF>& points) {
    double left = points[0].x(), right = left, top = points[0].y(), bottom = top;
    for (const QPointF& p : points) {
        left = std::min(left, p.x());
        right = std::max(right, p.x());
        top = std::min(top, p.y());
        bottom = std::max(bottom, p.y());
    }
    return {left, top, right - left, bottom - top};
}

StageDrawing::StageDrawing(const Scene& scene, const Collision& collision, std::span<const Collision> pass,
                           const Appearance& appearance, QSizeF size)
    : m_scene(scene)
    , m_collision(collision)
    , m_pass(pass)
    , m_s(collision.steps)
    , m_appearance(appearance)
    , m_canvas(appearance, size)
    , m_along(m_s.contact.cosTheta, -m_s.contact.sinTheta)
    , m_across(m_s.contact.sinTheta * -1, -m_s.contact.cosTheta)
    , m_wide(m_appearance.lineWidth() * 1.25) {
    const double foot = 1.9 * appearance.pixels(Size::Small); // the scale arrow's row
    const double margin = 1.9 * appearance.pixels(Size::Normal);
    m_room = QRectF(margin, 0.7 * margin, size.width() - 2 * margin, size.height() - foot - 1.4 * margin);
}

// The discs' scale, and the bodies' centres about the contact.
void StageDrawing::place(double discPixels) {
    const double first = m_s.first.radius;
    const double second = m_s.second.radius;
    m_metre = discPixels / (first + second);
    m_parties = {{m_collision.first, Ink::First, m_s.before.first, m_s.rotated.first, m_s.exchanged.first,
                  m_s.after.first, m_s.first.mass, first, m_along * first * m_metre}};
    if (!m_collision.isWall())
        m_parties.push_back({m_collision.second, Ink::Second, m_s.before.second, m_s.rotated.second,
                             m_s.exchanged.second, m_s.after.second, m_s.second.mass, second,
                             -m_along * second * m_metre});
}

std::vector<QPointF> StageDrawing::discPoints() const {
    std::vector<QPointF> points;
    for (const Party& p : m_parties) {
        const double r = p.radius * m_metre;
        points.push_back(p.centre - QPointF(r, r));
        points.push_back(p.centre + QPointF(r, r));
    }
    if (m_collision.isWall())
        points.push_back(-m_along * 8);
    return points;
}

// What a stage shows of a body, as arrows from its centre in x and y.
std::vector<Vec2d> StageDrawing::vectorsOf(Stage stage, const Party& p) const {
    const Contact<double>& c = m_s.contact;
    const auto back = [&](double along, double across) { return rotateBack(Vec2d{along, across}, c); };
    switch (stage) {
    case Stage::Contact:
        return {p.before};
    case Stage::Split:
        return {p.before, {p.before.x, 0}, {0, p.before.y}};
    case Stage::Rotation:
        return {p.before, back(p.rotated.x, 0), back(0, p.rotated.y)};
    case Stage::Exchange:
        return {back(p.rotated.x, 0), back(p.exchanged.x, 0), back(0, p.exchanged.y)};
    case Stage::RotationBack:
        return {p.after, back(p.exchanged.x, 0), back(0, p.exchanged.y)};
    case Stage::Check:
        break;
    }
    return {};
}

std::vector<QPointF> StageDrawing::extent(Stage stage, double scale) const {
    std::vector<QPointF> points = discPoints();
    for (const Party& p : m_parties)
        for (const Vec2d& v : vectorsOf(stage, p))
            points.push_back(p.centre + scale * flipped(v));
    return points;
}

// The largest scale at which every stage fits.
void StageDrawing::fitVectors() {
    double fastest = 0;
    for (const Party& p : m_parties)
        fastest = std::max({fastest, norm(p.before), norm(p.after)});
    if (fastest == 0)
        return;
    double low = 0;
    double high = 2 * std::max(m_room.width(), m_room.height()) / fastest;
    for (int i = 0; i < 40; ++i) {
        const double middle = (low + high) / 2;
        bool fits = true;
        for (int stage = int(Stage::Split); stage <= int(Stage::RotationBack); ++stage) {
            const QRectF box = boundsOf(extent(Stage(stage), middle));
            fits = fits && box.width() <= m_room.width() && box.height() <= m_room.height();
        }
        (fits ? low : high) = middle;
    }
    m_speed = low;
}

void StageDrawing::centreOn(const std::vector<QPointF>& points) {
    m_origin = m_room.center() - boundsOf(points).center();
}

void StageDrawing::wall() {
    const double reach = std::max(m_room.width(), m_room.height());
    const QColor color = m_appearance.quietText();
    m_canvas.line(m_origin - m_across * reach, m_origin + m_across * reach, color, m_wide);
    for (double s = -reach; s < reach; s += 9) {
        const QPointF from = m_origin + m_across * s;
        m_canvas.line(from, from - m_along * 7 + m_across * 5, faint(color, 0.6f), 1);
    }
}

// The bodies that were struck together with these two: where they lie, and no more.
void StageDrawing::others() {
    const Vec2d contact =
        m_s.first.position - Vec2d{m_s.contact.cosTheta, m_s.contact.sinTheta} * m_s.first.radius;
    const auto put = [&](int body, const Disc<double>& disc) {
        if (body < 0 || m_collision.involves(body))
            return;
        const QPointF centre = m_origin + m_metre * flipped(disc.position - contact);
        m_canvas.disc(centre, disc.radius * m_metre, faint(m_appearance.quietText(), 0.45f));
    };
    for (const Collision& c : m_pass) {
        put(c.first, c.steps.first);
        put(c.second, c.steps.second);
    }
}

void StageDrawing::bodies() {
    if (m_collision.isWall())
        wall();
    others();
    for (const Party& p : m_parties)
        m_canvas.disc(at(p), p.radius * m_metre, m_appearance.ink(p.ink));
}

// x′ on the line of centres, y′ across it, through the contact.
void StageDrawing::axes(bool faintly) {
    const QColor color = faint(m_appearance.quietText(), faintly ? 0.45f : 1.0f);
    const double reach = 0.5 * std::hypot(m_room.width(), m_room.height());
    const QRectF frame(4, 4, m_canvas.size().width() - 8,
                       m_canvas.size().height() - 2.4 * m_appearance.pixels(Size::Small));
    const auto clipped = [&](QPointF way) {
        double length = reach;
        while (length > 10 && !frame.contains(m_origin + way * length))
            length -= 2;
        return m_origin + way * length;
    };
    for (const QPointF& way : {m_along, m_across}) {
        const QPointF tip = clipped(way);
        m_canvas.line(clipped(-way), tip, color, 0.9, Qt::DashDotLine);
        m_canvas.label(symbol(way == m_along ? "x′" : "y′"), tip, way, Size::Small);
    }
}

void StageDrawing::scaleArrow(double pixelsPerUnit, const char* unitText) {
    if (!(pixelsPerUnit > 0) || !std::isfinite(pixelsPerUnit))
        return;
    const double value = roundLength(0.24 * m_canvas.size().width() / pixelsPerUnit);
    const double y = m_canvas.size().height() - 0.75 * m_appearance.pixels(Size::Small);
    const QPointF from(8, y);
    const QPointF to = from + QPointF(value * pixelsPerUnit, 0);
    const bool vector = QString::fromUtf8(unitText) != "m";
    if (vector) {
        m_canvas.arrow(from, to, m_appearance.quietText(), 1.3);
    } else {
        m_canvas.line(from, to, m_appearance.quietText(), 1.3);
        for (const QPointF& end : {from, to})
            m_canvas.line(end - QPointF(0, 3), end + QPointF(0, 3), m_appearance.quietText(), 1.3);
    }
    m_canvas.label(row({number(value), upright(QString::fromUtf8(unitText))}), to, {1, 0}, Size::Small);
}

void StageDrawing::symbolAt(const Party& p, const QString& axis, When when, QPointF from, QPointF to,
                            QPointF side) {
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    if (length < 3)
        return;
    // Above a long arrow or on the side asked for; before the tip of a short one.
    const bool isShort = side.isNull() && length < 3.5 * m_appearance.pixels(Size::Normal);
    const QPointF above = QPointF(-along.y(), along.x()) * (along.x() < 0 ? 1 : -1);
    m_canvas.label(velocitySymbol(m_scene, m_collision, p.body, axis, when),
                   isShort ? to : from + 0.72 * along,
                   isShort         ? along
                   : side.isNull() ? above
                                   : side,
                   Size::Normal);
}

void StageDrawing::resting(const Party& p, When when) {
    m_canvas.dot(at(p), m_appearance.ink(p.ink));
    m_canvas.label(row({velocitySymbol(m_scene, m_collision, p.body, {}, when), op("="), number(0, p.ink)}),
                   at(p), p.centre, Size::Small);
}

void StageDrawing::velocity(const Party& p, const Vec2d& v, When when, bool faintly) {
    if (v == Vec2d{}) {
        if (!faintly)
            resting(p, when);
        return;
    }
    const QPointF tip = at(p) + m_speed * flipped(v);
    const QColor color = m_appearance.ink(p.ink);
    m_canvas.arrow(at(p), tip, faintly ? faint(color) : color, m_wide);
    if (!faintly)
        symbolAt(p, {}, when, at(p), tip);
}

// Along x′ (solid, filled head) and across y′ (dashed, open head), with the rectangle that they span.
void StageDrawing::components(const Party& p, const Vec2d& v, When when) {
    // A velocity that lies on an axis hides its component: that one is moved beside it.
    const double gap = 1.5 * m_wide + 2;
    const bool onAlong = std::abs(v.y) * m_speed < 1;
    const bool onAcross = std::abs(v.x) * m_speed < 1;
    const QPointF from = at(p) + (onAlong ? m_across * gap : onAcross ? m_along * gap : QPointF());
    const QPointF along = from + m_speed * turned({v.x, 0});
    const QPointF across = from + m_speed * turned({0, v.y});
    const QPointF sum = from + m_speed * turned(v);
    m_canvas.line(along, sum, m_appearance.line(), 1, Qt::DotLine);
    m_canvas.line(across, sum, m_appearance.line(), 1, Qt::DotLine);
    m_canvas.arrow(from, along, m_appearance.ink(Ink::Along), m_wide);
    m_canvas.arrow(from, across, m_appearance.ink(Ink::Across), m_wide, ArrowHead::Open, Qt::DashLine);
    symbolAt(p, "x′", when, from, along);
    symbolAt(p, "y′", when, from, across);
}

} // namespace thetalane
