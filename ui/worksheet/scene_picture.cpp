#include "ui/worksheet/scene_picture.h"

#include "ui/words/number_text.h"
#include "ui/words/worked_lines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

using Size = Appearance::Size;

struct Shown {
    int body = 0;
    Disc<double> disc;
    Vec2d velocity; // before
};

std::vector<Shown> bodiesShown(std::span<const Collision> pass) {
    std::vector<Shown> shown;
    const auto take = [&](int body, const Disc<double>& disc, const Vec2d& before) {
        if (std::none_of(shown.begin(), shown.end(), [&](const Shown& s) { return s.body == body; }))
            shown.push_back({body, disc, before});
    };
    for (const Collision& c : pass) {
        take(c.first, c.steps.first, c.steps.before.first);
        if (!c.isWall())
            take(c.second, c.steps.second, c.steps.before.second);
    }
    return shown;
}

QPointF onScreen(const Vec2d& v) {
    return {v.x, -v.y};
}

class Picture {
public:
    Picture(const Scene& scene, const Collision& collision, std::vector<Shown> shown, const Appearance& look,
            QSizeF size)
        : m_scene(scene)
        , m_collision(collision)
        , m_shown(std::move(shown))
        , m_look(look)
        , m_canvas(look, size)
        , m_room(QRectF(QPointF(), size).adjusted(34, 26, -34, -34)) {
        fit();
    }

    FigureCanvas draw() {
        if (m_collision.isWall())
            wall();
        lineOfCentres();
        for (const Shown& s : m_shown)
            body(s);
        scaleBar();
        m_canvas.settle();
        return std::move(m_canvas);
    }

private:
    QPointF at(const Vec2d& metres) const { return m_origin + m_metre * onScreen(metres); }

    // Half the room for the bodies, and the arrows as long as still fits.
    void fit() {
        double fastest = 0, lowX = 1e300, lowY = 1e300, highX = -1e300, highY = -1e300;
        for (const Shown& s : m_shown) {
            fastest = std::max(fastest, norm(s.velocity));
            const double r = s.disc.radius;
            lowX = std::min(lowX, s.disc.position.x - r);
            highX = std::max(highX, s.disc.position.x + r);
            lowY = std::min(lowY, s.disc.position.y - r);
            highY = std::max(highY, s.disc.position.y + r);
        }
        const double share = fastest > 0 ? 0.86 : 0.95;
        m_metre = std::min(share * m_room.width() / std::max(highX - lowX, 1e-9),
                           share * m_room.height() / std::max(highY - lowY, 1e-9));
        if (!(m_metre < 1e12))
            m_metre = 1;
        m_speed = fastest > 0 ? 0.42 * m_room.height() / fastest : 1;
        QRectF box;
        for (int k = 0; k < 40; ++k) {
            box = extent();
            if (box.width() <= m_room.width() && box.height() <= m_room.height())
                break;
            m_speed *= 0.95;
            m_metre *= 0.985;
        }
        m_origin = m_room.center() - box.center();
    }

    // The arrows begin at the centres.
    QRectF extent() const {
        double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
        const auto take = [&](QPointF p, double r) {
            left = std::min(left, p.x() - r);
            right = std::max(right, p.x() + r);
            top = std::min(top, p.y() - r);
            bottom = std::max(bottom, p.y() + r);
        };
        for (const Shown& s : m_shown) {
            const QPointF centre = m_metre * onScreen(s.disc.position);
            take(centre, s.disc.radius * m_metre);
            take(centre + m_speed * onScreen(s.velocity), 8);
        }
        return {left, top, right - left, bottom - top};
    }

    void body(const Shown& s) {
        const Ink ink = inkOf(m_collision, s.body, {});
        const QColor colour = ink == Ink::Plain ? m_look.quietText() : m_look.ink(ink);
        const QPointF centre = at(s.disc.position);
        m_canvas.disc(centre, s.disc.radius * m_metre, colour);
        m_canvas.dot(centre, colour);
        m_canvas.label(upright(indexName(m_scene, s.body), ink), centre, away(s), Size::Large);
        const QPointF way = m_speed * onScreen(s.velocity);
        if (std::hypot(way.x(), way.y()) < 2)
            return;
        m_canvas.arrow(centre, centre + way, colour, 1.4 * m_look.lineWidth());
        const Formula name = velocitySymbol(m_scene, m_collision, s.body, {}, When::Before);
        m_canvas.label(row({name, op("="), number(norm(s.velocity), ink), upright("m/s")}), centre + way, way,
                       Size::Normal);
    }

    // Its name stands on the side that its velocity and its partner leave free.
    QPointF away(const Shown& s) const {
        const Contact<double>& c = m_collision.steps.contact;
        const QPointF along(c.cosTheta, -c.sinTheta);
        const QPointF side = s.body == m_collision.first ? along : -along;
        const QPointF way = onScreen(s.velocity);
        return QPointF::dotProduct(side, way) > 0 ? QPointF(-side.y(), side.x()) : side;
    }

    // Through both centres, with θ at the second one.
    void lineOfCentres() {
        const Contact<double>& c = m_collision.steps.contact;
        const QPointF along(c.cosTheta, -c.sinTheta);
        const PairCollision<double>& s = m_collision.steps;
        const QPointF foot = at(s.second.position), tip = at(s.first.position);
        const QColor amber = m_look.ink(Ink::Triangle);
        const double beyond = 0.5 * s.first.radius * m_metre + 10;
        m_canvas.line(foot, tip + along * beyond, amber, m_look.lineWidth(), Qt::DashLine);
        const double degrees = std::atan2(c.sinTheta, c.cosTheta) * 180 / std::numbers::pi;
        if (std::abs(degrees) < 2)
            return;
        const double radius = std::min(0.5 * c.Z * m_metre, 34.0);
        m_canvas.line(foot, foot + QPointF(1.6 * radius, 0), m_look.quietText(), 1, Qt::DotLine);
        m_canvas.arc(foot, radius, 0, degrees, amber);
        const double half = degrees / 2 * std::numbers::pi / 180;
        const QPointF middle(std::cos(half), -std::sin(half));
        m_canvas.label(symbol(QString::fromUtf8("θ"), Ink::Triangle), foot + radius * middle, middle,
                       Size::Normal);
    }

    void wall() {
        const Contact<double>& c = m_collision.steps.contact;
        const QPointF along(c.cosTheta, -c.sinTheta), across(-c.sinTheta, -c.cosTheta);
        const QPointF foot = at(m_collision.steps.second.position);
        const double reach = 0.45 * std::min(m_room.width(), m_room.height());
        m_canvas.line(foot - across * reach, foot + across * reach, m_look.text(), 2);
        for (double s = -reach; s < reach; s += 9)
            m_canvas.line(foot + across * s, foot + across * (s + 5) - along * 8, m_look.quietText(), 1);
    }

    void scaleBar() {
        const double about = 0.22 * m_canvas.size().width() / m_metre;
        const double power = std::pow(10, std::floor(std::log10(about)));
        const double value = 5 * power <= about ? 5 * power : 2 * power <= about ? 2 * power : power;
        const double y = m_canvas.size().height() - 12;
        const QPointF from(12, y), to(12 + value * m_metre, y);
        m_canvas.line(from, to, m_look.quietText(), 1.3);
        for (const QPointF& end : {from, to})
            m_canvas.line(end - QPointF(0, 3), end + QPointF(0, 3), m_look.quietText(), 1.3);
        m_canvas.label(row({number(value), upright("m")}), to, {1, 0}, Size::Small);
    }

    const Scene& m_scene;
    const Collision& m_collision;
    std::vector<Shown> m_shown;
    const Appearance& m_look;
    FigureCanvas m_canvas;
    QRectF m_room;
    QPointF m_origin;
    double m_metre = 1; // pixels a metre
    double m_speed = 1; // pixels a m/s
};

} // namespace

FigureCanvas scenePicture(const Scene& scene, const Collision& collision, std::span<const Collision> pass,
                          const Appearance& appearance, QSizeF size) {
    return Picture(scene, collision, bodiesShown(pass), appearance, size).draw();
}

} // namespace thetalane
