#include "ui/lab/ghost_view.h"

#include "ui/lab/lab_plot.h"
#include "ui/lab/lab_words.h"
#include "ui/lab/line_sample.h"
#include "ui/lane/arrow.h"
#include "ui/lane/extent.h"
#include "ui/lane/floor.h"
#include "ui/lane/scale.h"
#include "ui/words/worked_steps.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <set>

namespace thetalane {
namespace {

constexpr double reach = 14;            // of the mouse about a mark [px]
constexpr std::size_t mostBodies = 120; // drawn
constexpr std::size_t mostPieces = 150; // of a path: a pair that is exchanged at every step has thousands

// The bodies that leave the truth first, and then as many as fit.
std::vector<int> bodiesToDraw(const Ghosts& ghosts) {
    std::set<int> chosen;
    for (const Ghost& g : ghosts.all)
        if (g.parting)
            chosen.insert(g.parting->body);
    const std::size_t count = ghosts.truth->scene.bodies.size();
    for (std::size_t i = 0; i < count && chosen.size() < mostBodies; ++i)
        chosen.insert(int(i));
    return {chosen.begin(), chosen.end()};
}

// The way of a body up to `until`, by its stretches of motion, or where they are too many, by the clock.
QPolygonF wayOf(const Run& run, std::size_t body, double until, const Pixels& px) {
    QPolygonF way;
    const auto at = [&](double t) { way << px.at(run.timeline.bodyAt(body, t).position); };
    const auto segments = run.timeline.segments(body);
    if (segments.size() > mostPieces) {
        for (std::size_t k = 0; k <= mostPieces; ++k)
            at(until * double(k) / double(mostPieces));
        return way;
    }
    constexpr int bends = 8; // of a stretch that friction bends
    for (std::size_t k = 0; k < segments.size() && segments[k].start < until; ++k) {
        const double end = std::min(until, k + 1 < segments.size() ? segments[k + 1].start : until);
        const bool bent = segments[k].acceleration.x != 0 || segments[k].acceleration.y != 0;
        for (int j = 0; j < (bent ? bends : 1); ++j)
            at(segments[k].start + (end - segments[k].start) * j / bends);
    }
    at(until);
    return way;
}

// What matters of bodies that fly apart is where they start, and where they are when the last ghost leaves.
QRectF partOfThePlane(const Ghosts& ghosts) {
    const Run& truth = *ghosts.truth;
    if (truth.scene.lane || truth.scene.frame)
        return fitRect(truth, ghosts.shownAt);
    const auto disc = [&](std::size_t body, const Vec2d& p) {
        const double r = truth.scene.bodies[body].radius;
        return toUnits(p - Vec2d{r, r}, p + Vec2d{r, r});
    };
    QRectF start, all;
    double last = 0;
    for (const Ghost& g : ghosts.all)
        if (g.parting)
            last = std::max(last, g.parting->time);
    for (std::size_t i = 0; i < truth.scene.bodies.size(); ++i) {
        start |= disc(i, truth.scene.bodies[i].position);
        all |= disc(i, truth.timeline.bodyAt(i, last > 0 ? last : ghosts.shownAt).position);
    }
    const double more = 0.4 * std::max(start.width(), start.height());
    all = (all | start) & start.adjusted(-more, -more, more, more);
    const double margin = 0.05 * std::max(all.width(), all.height());
    return all.adjusted(-margin, -margin, margin, margin);
}

bool moves(const QPolygonF& way) {
    const QRectF box = way.boundingRect();
    return box.width() > 1 || box.height() > 1;
}

} // namespace

GhostView::GhostView(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("ghostView"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
}

QSize GhostView::sizeHint() const {
    return {320, m_appearance.projector() ? 400 : 280};
}

void GhostView::show(std::shared_ptr<const LabResult> result) {
    const Ghosts* before = ghosts();
    m_result = std::move(result);
    if (ghosts() == before)
        return;
    m_lit.reset();
    m_bodies = ghosts() ? bodiesToDraw(*ghosts()) : std::vector<int>();
    update();
}

void GhostView::setTime(double time) {
    m_time = time;
    update();
}

void GhostView::setLit(std::optional<std::size_t> ghost) {
    m_lit = ghost;
    update();
}

void GhostView::setWords(const QString& name, const QString& empty) {
    setAccessibleName(name);
    setToolTip(name);
    m_empty = empty;
    update();
}

MethodStyle GhostView::styleOf(std::size_t ghost) const {
    MethodStyle style = rowStyle(*m_result->plan, ghosts()->all[ghost].row);
    style.colour = seenColour(style.colour, m_appearance);
    return style;
}

QTransform GhostView::transform() const {
    const QRectF all = partOfThePlane(*ghosts());
    const double margin = 2.0 * m_appearance.unit();
    const double scale = std::min((width() - margin) / all.width(), (height() - margin) / all.height());
    QTransform t;
    t.translate(width() / 2.0, height() / 2.0);
    t.scale(scale, scale);
    t.translate(-all.center().x(), -all.center().y());
    return t;
}

// Of what happened outside of the part that is drawn, at its edge.
std::optional<QPointF> GhostView::markAt(std::size_t ghost) const {
    const auto& parting = ghosts()->all[ghost].parting;
    if (!parting)
        return std::nullopt;
    const QPointF at = transform().map(toUnits(parting->run));
    const double edge = 1.25 * m_appearance.unit();
    return QPointF(std::clamp(at.x(), edge, width() - edge), std::clamp(at.y(), edge, height() - edge));
}

// Marks at the same place are found one after the other: the next after the one that is lit.
std::optional<std::size_t> GhostView::markUnder(const QPointF& where) const {
    if (!ghosts())
        return std::nullopt;
    const std::size_t count = ghosts()->all.size();
    const std::size_t first = m_lit ? *m_lit + 1 : 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t ghost = (first + k) % count;
        const auto at = markAt(ghost);
        if (at && QLineF(*at, where).length() <= reach)
            return ghost;
    }
    return std::nullopt;
}

void GhostView::paintTruth(QPainter& painter) const {
    const Run& truth = *ghosts()->truth;
    const Pixels px(painter);
    const double thin = m_appearance.lineWidth() / 2;
    for (const int i : m_bodies) {
        const QPolygonF way = wayOf(truth, std::size_t(i), m_time, px);
        painter.setPen(QPen(faded(m_appearance.quietText(), 0.55), thin));
        painter.setBrush(Qt::NoBrush);
        if (moves(way))
            painter.drawPolyline(way);
    }
    painter.setFont(m_appearance.font(Appearance::Size::Small));
    const QFontMetricsF metrics(painter.font());
    for (const int i : m_bodies) {
        const Body& body = truth.scene.bodies[std::size_t(i)];
        const double r = px.length(body.radius);
        painter.setPen(QPen(m_appearance.quietText(), thin));
        painter.setBrush(faded(body.kind == BodyKind::Pin ? m_appearance.pin() : m_appearance.line(), 0.85));
        const QPointF at = px.at(truth.timeline.bodyAt(std::size_t(i), m_time).position);
        painter.drawEllipse(at, r, r);
        if (metrics.height() > 2 * r)
            continue;
        painter.setPen(m_appearance.quietText());
        painter.drawText(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r), Qt::AlignCenter,
                         metrics.elidedText(bodyName(truth.scene, i), Qt::ElideRight, 2 * r));
    }
}

// Its discs where they are not where they should be; the ways of all that move.
void GhostView::paintGhost(QPainter& painter, std::size_t ghost) const {
    const Ghost& g = ghosts()->all[ghost];
    const Run& truth = *ghosts()->truth;
    const MethodStyle style = styleOf(ghost);
    const bool recedes = m_lit && *m_lit != ghost;
    const QColor colour = faded(style.colour, recedes ? 0.25 : 1);
    const double width = m_appearance.lineWidth() * (m_lit == ghost ? 1.25 : 0.75);
    const Pixels px(painter);
    painter.setBrush(Qt::NoBrush);
    for (const int i : m_bodies) {
        const std::size_t body = std::size_t(i);
        const QPolygonF way = wayOf(*g.run, body, m_time, px);
        painter.setPen(QPen(colour, width, style.line, Qt::FlatCap));
        if (moves(way))
            painter.drawPolyline(way);
        const Vec2d at = g.run->timeline.bodyAt(body, m_time).position;
        if (norm(at - truth.timeline.bodyAt(body, m_time).position) <= ghosts()->tolerance)
            continue;
        const double r = px.length(truth.scene.bodies[body].radius);
        painter.drawEllipse(px.at(at), r, r);
    }
}

void GhostView::paintMark(QPainter& painter, std::size_t ghost) const {
    const auto at = markAt(ghost);
    if (!at)
        return;
    const MethodStyle style = styleOf(ghost);
    const double r = m_appearance.unit() * (m_lit == ghost ? 1.0 : 0.7);
    const bool happened = m_time >= ghosts()->all[ghost].parting->time;
    painter.setPen(QPen(style.colour, m_appearance.lineWidth() * 1.2));
    painter.setBrush(happened ? style.colour : m_appearance.card());
    const QPointF corners[] = {*at + QPointF(0, -r), *at + QPointF(r, 0), *at + QPointF(0, r),
                               *at + QPointF(-r, 0)};
    painter.drawPolygon(corners, 4);
}

void GhostView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), m_appearance.floor());
    if (!ghosts()) {
        painter.setFont(m_appearance.font(Appearance::Size::Normal));
        painter.setPen(m_appearance.quietText());
        painter.drawText(rect().adjusted(16, 0, -16, 0), Qt::AlignCenter | Qt::TextWordWrap, m_empty);
        return;
    }
    painter.setTransform(transform());
    paintFloor(painter, ghosts()->truth->scene, m_appearance, transform().inverted().mapRect(QRectF(rect())));
    paintTruth(painter);
    for (std::size_t ghost = 0; ghost < ghosts()->all.size(); ++ghost)
        paintGhost(painter, ghost);
    painter.resetTransform();
    for (std::size_t ghost = 0; ghost < ghosts()->all.size(); ++ghost)
        paintMark(painter, ghost);
    const double metre = transform().m11() * unitsPerMetre;
    paintScaleBar(painter, metre, QPointF(m_appearance.unit(), height() - m_appearance.unit()), m_appearance);
}

void GhostView::mousePressEvent(QMouseEvent* event) {
    if (const auto ghost = markUnder(event->position()))
        emit picked(*ghost);
    else
        QWidget::mousePressEvent(event);
}

void GhostView::mouseMoveEvent(QMouseEvent* event) {
    const auto ghost = markUnder(event->position());
    setCursor(ghost ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (ghost)
        QToolTip::showText(event->globalPosition().toPoint(),
                           ghostShortText(*m_result->plan, ghosts()->all[*ghost]), this);
}

} // namespace thetalane
