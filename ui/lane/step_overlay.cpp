#include "ui/lane/step_overlay.h"

#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

const QString prime = QStringLiteral("′");

OverlayLabel named(const QString& symbol, const QString& sub, double value, const QString& unit) {
    return {symbol, sub, QStringLiteral(" = %1%2").arg(numberText(value), unit)};
}

// Builds one stage; the names follow the paper.
class Builder {
public:
    Builder(const Scene& scene, const Collision& collision)
        : m_c(collision)
        , m_s(collision.steps)
        , m_xAxis{m_s.contact.cosTheta, m_s.contact.sinTheta}
        , m_yAxis{-m_s.contact.sinTheta, m_s.contact.cosTheta} {
        m_indices[0] = indexName(scene, m_c.first);
        m_indices[1] = indexName(scene, m_c.second);
        double fastest = 0;
        for (const auto& pair : {m_s.before, m_s.after})
            fastest = std::max({fastest, norm(pair.first), norm(pair.second)});
        m_o.metresPerSpeed = fastest > 0 ? 0.57 * overlayReach(m_c) / fastest : 0;
        const double reach = m_s.first.radius + m_s.second.radius;
        m_o.contact = m_s.second.position + m_xAxis * (m_s.contact.Z * m_s.second.radius / reach);
        m_o.discs.push_back({m_s.first.position, m_s.first.radius, bodyName(scene, m_c.first), Ink::First});
        if (m_c.isWall())
            m_o.wall = m_c.side;
        else
            m_o.discs.push_back(
                {m_s.second.position, m_s.second.radius, bodyName(scene, m_c.second), Ink::Second});
    }

    StepOverlay build(Stage stage) {
        const std::array parts{&Builder::contact,  &Builder::split,        &Builder::rotation,
                               &Builder::exchange, &Builder::rotationBack, &Builder::check};
        (this->*parts[std::size_t(stage)])();
        return std::move(m_o);
    }

private:
    int bodies() const { return m_c.isWall() ? 1 : 2; }
    const Vec2d& of(const VelocityPair<double>& pair, int body) const {
        return body == 0 ? pair.first : pair.second;
    }
    const Vec2d& position(int body) const { return body == 0 ? m_s.first.position : m_s.second.position; }
    static Ink ink(int body) { return body == 0 ? Ink::First : Ink::Second; }

    OverlayArrow& arrow(int body, ArrowPart part, const Vec2d& velocity, Ink colour) {
        const Vec2d from = position(body);
        m_o.arrows.push_back({body, part, from, from + velocity * m_o.metresPerSpeed, colour});
        return m_o.arrows.back();
    }
    OverlayLabel speed(int body, const QString& axis, double value) const {
        const QString& name = m_indices[body];
        const bool comma = name.size() > 1 && !axis.isEmpty(); // v_ball,x but v_Ax, as on the cards
        return named(QStringLiteral("v"), name + (comma ? "," : "") + axis, value, QStringLiteral(" m/s"));
    }
    void theta(const Vec2d& centre, double radius) {
        const double angle = std::atan2(m_s.contact.sinTheta, m_s.contact.cosTheta);
        m_o.arcs.push_back(
            {centre, radius, angle,
             named(QStringLiteral("θ"), {}, angle * 180 / std::numbers::pi, QStringLiteral("°"))});
        m_o.lines.push_back({centre, centre + Vec2d{1.5 * radius, 0}, Ink::Triangle, false, true, {}});
    }

    void contact() {
        const auto& t = m_s.contact;
        const Vec2d from = m_s.second.position;
        const Vec2d to = m_s.first.position;
        const Vec2d corner{to.x, from.y};
        const QString metre = QStringLiteral(" m");
        const double visible = 0.02 * t.Z;
        if (std::abs(t.a) > visible && std::abs(t.b) > visible) {
            m_o.lines.push_back(
                {from, corner, Ink::Triangle, true, false, named(QStringLiteral("a"), {}, t.a, metre)});
            m_o.lines.push_back(
                {corner, to, Ink::Triangle, true, false, named(QStringLiteral("b"), {}, t.b, metre)});
        }
        m_o.lines.push_back(
            {from, to, Ink::Triangle, true, false, named(QStringLiteral("Z"), {}, t.Z, metre)});
        theta(from, 0.3 * t.Z);
    }

    void split() {
        for (int i = 0; i < bodies(); ++i) {
            const Vec2d v = of(m_s.before, i);
            arrow(i, ArrowPart::Velocity, v, ink(i)).label = speed(i, {}, norm(v));
            if (norm(v) == 0)
                continue;
            components(i, ArrowPart::FirstComponent, {v.x, 0}, speed(i, QStringLiteral("x"), v.x));
            components(i, ArrowPart::SecondComponent, {0, v.y}, speed(i, QStringLiteral("y"), v.y));
        }
    }

    // A component along x or y, and the dotted side of the rectangle that it spans with the other.
    void components(int body, ArrowPart part, const Vec2d& along, const OverlayLabel& label) {
        OverlayArrow& a = arrow(body, part, along, ink(body));
        a.bold = false;
        a.label = label;
        const Vec2d tip = position(body) + of(m_s.before, body) * m_o.metresPerSpeed;
        m_o.lines.push_back({a.to, tip, ink(body), false, true, {}});
    }

    void axes() {
        const double reach = 0.98 * overlayReach(m_c);
        const auto axis = [&](const Vec2d& direction, Ink colour, bool dashed, const QString& name) {
            m_o.lines.push_back({m_o.contact - direction * reach,
                                 m_o.contact + direction * reach,
                                 colour,
                                 false,
                                 dashed,
                                 {name, {}, {}},
                                 true});
        };
        axis(m_xAxis, Ink::Along, false, QStringLiteral("x") + prime);
        axis(m_yAxis, Ink::Across, true, QStringLiteral("y") + prime);
    }

    OverlayArrow& along(int body, double value) {
        return arrow(body, ArrowPart::FirstComponent, m_xAxis * value, Ink::Along);
    }
    OverlayArrow& across(int body, double value) {
        OverlayArrow& a = arrow(body, ArrowPart::SecondComponent, m_yAxis * value, Ink::Across);
        a.dashed = true;
        return a;
    }

    void rotation() {
        axes();
        theta(m_o.contact, 0.36 * overlayReach(m_c));
        for (int i = 0; i < bodies(); ++i) {
            const Vec2d v = of(m_s.rotated, i);
            arrow(i, ArrowPart::Velocity, of(m_s.before, i), ink(i)).opacity = 0.35;
            along(i, v.x).label = speed(i, QStringLiteral("x") + prime, v.x);
            if (norm(v) > 0)
                across(i, v.y).label = speed(i, QStringLiteral("y") + prime, v.y);
        }
    }

    void exchange() {
        axes();
        for (int i = 0; i < bodies(); ++i) {
            const double was = of(m_s.rotated, i).x;
            const Vec2d is = of(m_s.exchanged, i);
            OverlayArrow& before = arrow(i, ArrowPart::Before, m_xAxis * was, Ink::Along);
            before.opacity = 0.4;
            before.shift = -1;
            OverlayArrow& after = along(i, is.x);
            after.shift = 1;
            after.label = speed(i, QStringLiteral("x") + prime, is.x);
            after.label.text = QStringLiteral("  %1 → %2 m/s").arg(numberText(was), numberText(is.x));
            if (is.y != 0) {
                OverlayArrow& y = across(i, is.y);
                y.bold = false;
            }
        }
    }

    void rotationBack() {
        for (int i = 0; i < bodies(); ++i) {
            const Vec2d v = of(m_s.exchanged, i);
            along(i, v.x).opacity = 0.4;
            across(i, v.y).opacity = 0.4;
            for (auto part = m_o.arrows.end() - 2; part != m_o.arrows.end(); ++part)
                part->bold = false;
            OverlayLabel& label = arrow(i, ArrowPart::Velocity, of(m_s.after, i), ink(i)).label;
            label = speed(i, {}, norm(of(m_s.after, i)));
            label.symbol += prime; // after the collision, as on the cards
        }
    }

    void check() {
        for (int i = 0; i < bodies(); ++i) {
            const Vec2d was = of(m_s.before, i);
            const Vec2d is = of(m_s.after, i);
            const bool parallel = std::abs(cross(was, is)) < 0.08 * norm(was) * norm(is);
            OverlayArrow& before = arrow(i, ArrowPart::Before, was, ink(i));
            before.opacity = 0.4;
            before.label.text = worded(QT_TRANSLATE_NOOP("thetalane::StepOverlay", "before %1 m/s"), was);
            before.shift = parallel ? -1 : 0;
            OverlayArrow& after = arrow(i, ArrowPart::Velocity, is, ink(i));
            after.label.text = worded(QT_TRANSLATE_NOOP("thetalane::StepOverlay", "after %1 m/s"), is);
            after.shift = parallel ? 1 : 0;
        }
    }
    static QString worded(const char* text, const Vec2d& v) {
        return QCoreApplication::translate("thetalane::StepOverlay", text).arg(numberText(norm(v)));
    }

    const Collision& m_c;
    const PairCollision<double>& m_s;
    Vec2d m_xAxis;
    Vec2d m_yAxis;
    QString m_indices[2];
    StepOverlay m_o;
};

} // namespace

StepOverlay stepOverlay(const Scene& scene, const Collision& collision, Stage stage) {
    return Builder(scene, collision).build(stage);
}

double overlayReach(const Collision& collision) {
    const double radii = collision.steps.first.radius + collision.steps.second.radius;
    return (collision.isWall() ? 3.2 : 2.3) * radii;
}

StepOverlay between(const StepOverlay& from, const StepOverlay& to, double t) {
    StepOverlay now = to;
    for (OverlayArrow& arrow : now.arrows) {
        const auto same = [&](const OverlayArrow& a) { return a.body == arrow.body && a.part == arrow.part; };
        auto was = std::find_if(from.arrows.begin(), from.arrows.end(), same);
        arrow.label = {};
        if (was == from.arrows.end()) {
            arrow.opacity *= t;
            continue;
        }
        arrow.to = was->to + (arrow.to - was->to) * t;
        arrow.opacity = was->opacity + (arrow.opacity - was->opacity) * t;
        arrow.shift = was->shift + (arrow.shift - was->shift) * t;
    }
    for (OverlayLine& line : now.lines)
        line.label = {};
    for (OverlayArc& arc : now.arcs) {
        arc.angle *= t;
        arc.label = {};
    }
    return now;
}

} // namespace thetalane
