#include "ui/tables/momentum_figure.h"

#include "ui/words/instant.h"
#include "ui/words/worked_lines.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

using Size = Appearance::Size;

QPointF onScreen(const Vec2d& v) {
    return {v.x, -v.y};
}

double lengthOf(QPointF v) {
    return std::hypot(v.x(), v.y());
}

// The sums p₁, p₁ + p₂, …, from zero.
std::vector<QPointF> chainOf(const std::vector<PassBody>& bodies, When when) {
    std::vector<QPointF> points{{}};
    for (const PassBody& b : bodies)
        points.push_back(points.back() + b.mass * onScreen(when == When::After ? b.after : b.before));
    return points;
}

QRectF boundsOf(const std::vector<QPointF>& points) {
    QRectF box(points.front(), QSizeF());
    for (const QPointF& p : points) {
        box.setLeft(std::min(box.left(), p.x()));
        box.setRight(std::max(box.right(), p.x()));
        box.setTop(std::min(box.top(), p.y()));
        box.setBottom(std::max(box.bottom(), p.y()));
    }
    return box;
}

// Arrows on one line would lie on each other: then each stands a little beside the last.
bool areOnOneLine(const std::vector<QPointF>& chain, double scale) {
    QPointF longest;
    for (std::size_t i = 0; i + 1 < chain.size(); ++i)
        if (lengthOf(chain[i + 1] - chain[i]) > lengthOf(longest))
            longest = chain[i + 1] - chain[i];
    const double length = lengthOf(longest);
    if (length == 0)
        return true;
    return std::all_of(chain.begin(), chain.end(), [&](QPointF p) {
        return std::abs(p.x() * longest.y() - p.y() * longest.x()) / length * scale < 6;
    });
}

double roundLength(double about) {
    const double power = std::pow(10, std::floor(std::log10(about)));
    for (const double step : {5.0, 2.0})
        if (step * power <= about)
            return step * power;
    return power;
}

class Drawer {
public:
    Drawer(const Scene& scene, const Collision& collision, std::vector<PassBody> bodies,
           const Appearance& appearance, MomentumDrawing& drawing)
        : m_scene(scene)
        , m_collision(collision)
        , m_bodies(std::move(bodies))
        , m_look(appearance)
        , m_drawing(drawing)
        , m_wide(1.25 * appearance.lineWidth()) {}

    void chain(const std::vector<QPointF>& points, QPointF origin, When when) {
        const bool beside = areOnOneLine(points, m_drawing.scale);
        const QPointF total = m_drawing.scale * points.back();
        QPointF along = total;
        for (std::size_t i = 0; i + 1 < points.size() && lengthOf(along) < 1; ++i)
            along = m_drawing.scale * (points[i + 1] - points[i]);
        const QPointF step = beside && lengthOf(along) > 0
                                 ? QPointF(-along.y(), along.x()) / lengthOf(along) * (4.5 * m_wide)
                                 : QPointF();
        sum(origin - step, total, when);
        for (std::size_t i = 0; i < m_bodies.size(); ++i)
            part(m_bodies[i], origin + m_drawing.scale * points[i] + step * double(i),
                 m_drawing.scale * (points[i + 1] - points[i]), when);
        m_drawing.canvas.dot(origin, m_look.text());
    }

    void scaleArrow() {
        const double value = roundLength(0.22 * m_drawing.canvas.size().width() / m_drawing.scale);
        const double y = m_drawing.canvas.size().height() - 0.75 * m_look.pixels(Size::Small);
        const QPointF from(8, y), to(8 + value * m_drawing.scale, y);
        m_drawing.canvas.arrow(from, to, m_look.quietText(), 1.3);
        m_drawing.canvas.label(row({number(value), upright("kg·m/s")}), to, {1, 0}, Size::Small);
    }

private:
    void sum(QPointF from, QPointF way, When when) {
        if (lengthOf(way) < 3)
            return;
        QColor quiet = m_look.quietText();
        quiet.setAlphaF(0.45f);
        m_drawing.canvas.arrow(from, from + way, quiet, 2.6 * m_wide);
        m_drawing.canvas.label(
            row({upright("Σ"), when == When::After ? script(symbol("p"), {}, symbol("′")) : symbol("p")}),
            from + 0.4 * way, {way.y(), -way.x()}, Size::Normal);
    }

    void part(const PassBody& b, QPointF from, QPointF way, When when) {
        if (lengthOf(way) < 3)
            return;
        const Ink ink = inkOf(m_collision, b.body, {});
        const bool first = ink == Ink::First, second = ink == Ink::Second;
        m_drawing.canvas.arrow(from, from + way, ink == Ink::Plain ? m_look.quietText() : m_look.ink(ink),
                               m_wide, first ? ArrowHead::Filled : ArrowHead::Open,
                               first    ? Qt::SolidLine
                               : second ? Qt::DashLine
                                        : Qt::DotLine);
        if (m_bodies.size() > mostNamed && ink == Ink::Plain)
            return;
        m_drawing.canvas.label(script(symbol("p", ink), upright(indexName(m_scene, b.body), ink),
                                      when == When::After ? symbol("′") : Formula{}),
                               from + 0.5 * way, {-way.y(), way.x()}, Size::Normal);
    }

    static constexpr std::size_t mostNamed = 6; // more letters than that find no place

    const Scene& m_scene;
    const Collision& m_collision;
    std::vector<PassBody> m_bodies;
    const Appearance& m_look;
    MomentumDrawing& m_drawing;
    double m_wide;
};

} // namespace

MomentumDrawing momentumDrawing(const Scene& scene, std::span<const Collision> collisions, std::size_t index,
                                const Appearance& appearance, QSizeF size) {
    const std::vector<PassBody> bodies = bodiesOf(passOf(collisions, index));
    MomentumDrawing drawing{FigureCanvas(appearance, size), {}, {}, {}, {}, 0};
    const double foot = 2.2 * appearance.pixels(Size::Small);
    const QRectF all(0, 0, size.width(), size.height() - foot);
    const bool beside = all.width() > 1.25 * all.height();
    const QSizeF half =
        beside ? QSizeF(all.width() / 2, all.height()) : QSizeF(all.width(), all.height() / 2);
    drawing.beforeArea = QRectF(all.topLeft(), half);
    drawing.afterArea =
        QRectF(beside ? all.center().x() : 0, beside ? 0 : all.center().y(), half.width(), half.height());
    const auto before = chainOf(bodies, When::Before), after = chainOf(bodies, When::After);
    const QRectF boxes[] = {boundsOf(before), boundsOf(after)};
    const double margin = 2.4 * appearance.pixels(Size::Normal);
    const double title = 1.8 * appearance.pixels(Size::Normal);
    const QSizeF room(half.width() - 2 * margin, half.height() - title - 1.4 * margin);
    double scale = 1e300;
    for (const QRectF& box : boxes) {
        if (box.width() > 0)
            scale = std::min(scale, room.width() / box.width());
        if (box.height() > 0)
            scale = std::min(scale, room.height() / box.height());
    }
    if (!(scale < 1e300) || !(scale > 0))
        return drawing;
    drawing.scale = scale;
    const QPointF down(0, title / 2);
    drawing.before = drawing.beforeArea.center() + down - scale * boxes[0].center();
    drawing.after = drawing.afterArea.center() + down - scale * boxes[1].center();
    Drawer drawer(scene, collisions[index], bodies, appearance, drawing);
    drawer.chain(before, drawing.before, When::Before);
    drawer.chain(after, drawing.after, When::After);
    drawer.scaleArrow();
    drawing.canvas.settle();
    return drawing;
}

MomentumFigure::MomentumFigure(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("momentumFigure"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&appearance, &Appearance::changed, this, [this] {
        m_drawing.reset();
        update();
    });
    retranslate();
}

void MomentumFigure::retranslate() {
    setAccessibleName(tr("Momenta tip to tail, before and after"));
    setToolTip(tr("First body solid, second dashed, the total broad; before and after to one scale"));
    update();
}

void MomentumFigure::setCollision(std::shared_ptr<const Run> run, std::size_t collision) {
    m_run = std::move(run);
    m_collision = collision;
    m_drawing.reset();
    update();
}

void MomentumFigure::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_appearance.card());
    if (!m_run || m_collision >= m_run->timeline.collisions().size())
        return;
    if (!m_drawing || m_drawing->canvas.size() != QSizeF(size()))
        m_drawing.emplace(
            momentumDrawing(m_run->scene, m_run->timeline.collisions(), m_collision, m_appearance, size()));
    painter.setFont(m_appearance.font(Size::Normal, true));
    painter.setPen(m_appearance.text());
    const double gap = m_appearance.unit();
    for (const auto& [area, title] :
         {std::pair{m_drawing->beforeArea, tr("Before")}, {m_drawing->afterArea, tr("After")}})
        painter.drawText(area.adjusted(gap, gap / 2, -gap, 0), Qt::AlignLeft | Qt::AlignTop, title);
    m_drawing->canvas.paint(painter);
}

} // namespace thetalane
