#include "ui/tables/centre_figure.h"

#include "core/engine/engine.h"
#include "ui/words/number_text.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr std::size_t looks = 25; // at the bodies, for how far they come

} // namespace

CentreFigure::CentreFigure(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("centreFigure"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&appearance, &Appearance::changed, this, qOverload<>(&QWidget::update));
    retranslate();
}

void CentreFigure::retranslate() {
    setAccessibleName(tr("Path of the centre of mass"));
    setToolTip(tr("The cross is the centre of mass; solid: where it has been, dotted: where it goes"));
}

void CentreFigure::setRun(std::shared_ptr<const Run> run, History history) {
    m_run = std::move(run);
    m_history = std::move(history);
    findExtent();
    setTime(m_time);
}

void CentreFigure::setTime(double time) {
    m_time = time;
    if (m_run)
        m_run->timeline.stateAt(time, m_states);
    update();
}

void CentreFigure::findExtent() {
    m_low = {1e300, 1e300};
    m_high = {-1e300, -1e300};
    const auto take = [this](const Vec2d& p, double r) {
        m_low = {std::min(m_low.x, p.x - r), std::min(m_low.y, p.y - r)};
        m_high = {std::max(m_high.x, p.x + r), std::max(m_high.y, p.y + r)};
    };
    for (const SummedMoment& m : m_history.moments)
        take(m.centre.position, 0);
    const auto& moments = m_history.moments;
    const std::size_t stride = std::max<std::size_t>(1, moments.size() / looks);
    std::vector<BodyState> states;
    for (std::size_t k = 0; k < moments.size(); k += stride) {
        m_run->timeline.stateAt(moments[k].time, states);
        for (std::size_t i = 0; i < states.size(); ++i)
            take(states[i].position, m_run->scene.bodies[i].radius);
    }
}

QRectF CentreFigure::room() const {
    const double gap = m_appearance.unit();
    return QRectF(rect()).adjusted(gap, gap, -gap, -2.4 * m_appearance.pixels(Appearance::Size::Small));
}

double CentreFigure::scale() const {
    const double wide = std::max(1e-9, m_high.x - m_low.x), high = std::max(1e-9, m_high.y - m_low.y);
    return std::min(room().width() / wide, room().height() / high);
}

QPointF CentreFigure::at(const Vec2d& p) const {
    const Vec2d middle = (m_low + m_high) * 0.5;
    return room().center() + scale() * QPointF(p.x - middle.x, middle.y - p.y);
}

void CentreFigure::paintBodies(QPainter& painter) const {
    const bool two = m_run->scene.bodies.size() == 2;
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        const Ink ink = !two ? Ink::Plain : i == 0 ? Ink::First : Ink::Second;
        const QColor colour = two ? m_appearance.ink(ink) : m_appearance.quietText();
        QColor inside = colour;
        inside.setAlphaF(0.15f);
        painter.setPen(QPen(colour, 1.2, two && i == 1 ? Qt::DashLine : Qt::SolidLine));
        painter.setBrush(inside);
        const double r = std::max(1.5, m_run->scene.bodies[i].radius * scale());
        painter.drawEllipse(at(m_states[i].position), r, r);
    }
}

void CentreFigure::paintPath(QPainter& painter, const Vec2d& now) const {
    QPolygonF been, goes;
    for (const SummedMoment& m : m_history.moments)
        (m.time <= m_time ? been : goes) << at(m.centre.position);
    been << at(now);
    goes.prepend(at(now));
    const double wide = m_appearance.lineWidth();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_appearance.text(), wide, Qt::DotLine));
    painter.drawPolyline(goes);
    painter.setPen(QPen(m_appearance.text(), 1.2 * wide));
    painter.drawPolyline(been);
}

void CentreFigure::paintScale(QPainter& painter) const {
    const double about = 0.25 * width() / scale();
    const double power = std::pow(10, std::floor(std::log10(about)));
    const double value = 5 * power <= about ? 5 * power : 2 * power <= about ? 2 * power : power;
    const double y = height() - 0.8 * m_appearance.pixels(Appearance::Size::Small);
    const QPointF from(m_appearance.unit(), y), to(from.x() + value * scale(), y);
    painter.setPen(QPen(m_appearance.quietText(), 1.3));
    painter.drawLine(from, to);
    for (const QPointF& end : {from, to})
        painter.drawLine(end - QPointF(0, 3), end + QPointF(0, 3));
    painter.setFont(m_appearance.font(Appearance::Size::Small));
    const double h = painter.fontMetrics().height();
    painter.drawText(QRectF(to.x() + 6, y - h / 2, 200, h), Qt::AlignVCenter | Qt::AlignLeft,
                     numberText(value) + QStringLiteral(" m"));
}

void CentreFigure::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_appearance.card());
    if (!m_run || m_history.moments.empty())
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const CentreOfMass centre = centreOfMass(m_run->scene, m_states);
    paintBodies(painter);
    paintPath(painter, centre.position);
    const QPointF here = at(centre.position);
    const double r = 3.5 * m_appearance.lineWidth();
    painter.setPen(QPen(m_appearance.text(), m_appearance.lineWidth()));
    painter.setBrush(m_appearance.ink(Ink::Triangle));
    painter.drawEllipse(here, r, r);
    painter.drawLine(here - QPointF(r, 0), here + QPointF(r, 0));
    painter.drawLine(here - QPointF(0, r), here + QPointF(0, r));
    paintScale(painter);
}

} // namespace thetalane
