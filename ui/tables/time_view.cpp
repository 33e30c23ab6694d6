#include "ui/tables/time_view.h"

#include "ui/appearance.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPaintEngine>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double reach = 8; // of a click, to a bar [px]

} // namespace

PlotStyle plotStyleOf(const Appearance& look) {
    PlotStyle style;
    style.font = look.font(Appearance::Size::Small);
    style.text = look.text();
    style.quiet = look.quietText();
    style.grid = look.line();
    style.paper = look.card();
    style.lineWidth = look.lineWidth();
    style.locale = QLocale::c();
    return style;
}

TimeView::TimeView(const Appearance& appearance, const char* name, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QLatin1String(name));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::CrossCursor);
    connect(&appearance, &Appearance::changed, this, &TimeView::forget);
}

void TimeView::setPlot(Plot plot, std::vector<TimeBar> bars) {
    m_plot = std::move(plot);
    m_bars = std::move(bars);
    forget();
}

void TimeView::setCursor(double time, bool shown) {
    if (m_time == time && m_hasCursor == shown)
        return;
    m_time = time;
    m_hasCursor = shown;
    update();
}

void TimeView::forget() {
    m_layout.reset();
    m_picture = {};
    update();
}

const PlotLayout& TimeView::layout() const {
    if (!m_layout)
        m_layout.emplace(rect(), m_plot, plotStyleOf(m_appearance));
    return *m_layout;
}

QPointF TimeView::at(double time, double value) const {
    return {layout().xOf(time), layout().yOf(value)};
}

double TimeView::timeAt(double x) const {
    const double low = m_plot.x.low.value_or(0), high = m_plot.x.high.value_or(1);
    const QRectF& frame = layout().frame;
    return std::clamp(low + (high - low) * (x - frame.left()) / frame.width(), low, high);
}

void TimeView::paintBars(QPainter& painter) const {
    const double wide = m_appearance.lineWidth();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const bool open : {false, true}) // the open one on top
        for (const TimeBar& bar : m_bars) {
            if (bar.open != open)
                continue;
            const QPointF head = at(bar.time, bar.value);
            const double r = open ? 2.4 * wide : 1.5 * wide;
            painter.setPen(QPen(bar.colour, open ? 1.8 * wide : wide));
            painter.drawLine(QPointF(head.x(), layout().yOf(0)), head);
            painter.setPen(QPen(m_appearance.card(), 1));
            painter.setBrush(bar.colour);
            if (bar.wall)
                painter.drawRect(QRectF(head.x() - r, head.y() - r, 2 * r, 2 * r));
            else
                painter.drawEllipse(head, r, r);
        }
}

void TimeView::paintEvent(QPaintEvent*) {
    if (m_picture.size() != size() * devicePixelRatioF()) {
        m_layout.reset();
        m_picture = QPixmap(size() * devicePixelRatioF());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        m_picture.fill(m_appearance.card());
        QPainter painter(&m_picture);
        paintPlot(painter, rect(), m_plot, plotStyleOf(m_appearance));
        paintBars(painter);
    }
    QPainter painter(this);
    // A picture that is larger than the screen is drawn anew, not enlarged.
    if (painter.paintEngine()->paintDevice()->devicePixelRatioF() > devicePixelRatioF()) {
        paintPlot(painter, rect(), m_plot, plotStyleOf(m_appearance));
        paintBars(painter);
    } else {
        painter.drawPixmap(0, 0, m_picture);
    }
    if (!m_hasCursor)
        return;
    const double x = layout().xOf(m_time);
    const QRectF& frame = layout().frame;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_appearance.accent(), m_appearance.lineWidth()));
    painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_appearance.accent());
    const double r = 2.5 * m_appearance.lineWidth();
    painter.drawPolygon(
        QPolygonF({{x - r, frame.top() - r}, {x + r, frame.top() - r}, {x, frame.top() + r}}));
    if (!m_bars.empty()) // the open one stands at the very time
        paintBars(painter);
}

// The nearest in time; of those just as near, the one whose head is nearest.
std::optional<std::size_t> TimeView::barAt(QPointF where) const {
    std::optional<std::size_t> best;
    double least = reach;
    for (std::size_t k = 0; k < m_bars.size(); ++k) {
        const QPointF head = at(m_bars[k].time, m_bars[k].value);
        const double away = std::abs(head.x() - where.x()) + 1e-3 * std::abs(head.y() - where.y());
        if (away >= least)
            continue;
        least = away;
        best = k;
    }
    return best;
}

void TimeView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    if (const auto bar = barAt(event->position())) {
        m_dragging = false;
        emit barPicked(*bar);
        return;
    }
    m_dragging = true;
    emit timeChosen(timeAt(event->position().x()));
}

void TimeView::mouseMoveEvent(QMouseEvent* event) {
    if (m_dragging && (event->buttons() & Qt::LeftButton))
        emit timeChosen(timeAt(event->position().x()));
}

bool TimeView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip || m_bars.empty())
        return QWidget::event(event);
    auto* help = static_cast<QHelpEvent*>(event);
    const auto bar = barAt(help->pos());
    QToolTip::showText(help->globalPos(), bar ? m_bars[*bar].hover : toolTip(), this);
    return true;
}

} // namespace thetalane
