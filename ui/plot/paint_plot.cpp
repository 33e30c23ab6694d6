#include "ui/plot/paint_plot.h"

#include "ui/plot/plot_layout.h"

#include <QPainter>
#include <QPainterPath>

#include <array>
#include <cmath>

namespace thetalane {
namespace {

class PlotPainter {
public:
    PlotPainter(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style)
        : m_p(painter)
        , m_plot(plot)
        , m_style(style)
        , m_metrics(style.font)
        , m_layout(area, plot, style) {
        m_p.fillRect(area, style.paper);
        m_p.setFont(style.font);
    }

    void paint(const std::optional<PlotHit>& lit) {
        axes();
        titles();
        m_p.save();
        m_p.setClipRect(m_layout.frame.adjusted(-2 * markerSize(), -2 * markerSize(), 2 * markerSize(),
                                                2 * markerSize()));
        for (const PlotLine& line : m_plot.lines)
            across(line);
        for (const PlotSeries& s : m_plot.series)
            joined(s);
        for (const PlotSeries& s : m_plot.series)
            for (const PlotPoint& p : s.points)
                point(s, p);
        m_p.restore();
        labels();
        legend();
        if (lit)
            halo(*lit);
    }

private:
    double markerSize() const { return 3 + 1.4 * m_style.lineWidth; }

    void axes() {
        const QRectF& f = m_layout.frame;
        for (const PlotTick& t : m_layout.x.ticks()) {
            const double x = m_layout.xOf(t.value);
            gridLine({x, f.top()}, {x, f.bottom()}, !t.label.isEmpty());
            m_p.setPen(m_style.quiet);
            m_p.drawText(QRectF(x - 60, f.bottom() + m_metrics.height() * 0.25, 120, m_metrics.height()),
                         Qt::AlignHCenter | Qt::AlignTop, t.label);
        }
        for (const PlotTick& t : m_layout.y.ticks()) {
            const double y = m_layout.yOf(t.value);
            gridLine({f.left(), y}, {f.right(), y}, !t.label.isEmpty());
            m_p.setPen(m_style.quiet);
            m_p.drawText(QRectF(f.left() - 200 - m_metrics.height() * 0.4, y - m_metrics.height(), 200,
                                2 * m_metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, t.label);
        }
        m_p.setPen(QPen(m_style.quiet, 1));
        m_p.setBrush(Qt::NoBrush);
        m_p.drawRect(f);
    }

    void gridLine(QPointF from, QPointF to, bool major) {
        QColor colour = m_style.grid;
        colour.setAlphaF(major ? 1.0 : 0.45);
        m_p.setPen(QPen(colour, 1));
        m_p.drawLine(from, to);
    }

    void titles() {
        m_p.setPen(m_style.text);
        m_p.drawText(m_layout.xTitle, Qt::AlignCenter, m_plot.x.title);
        m_p.save();
        m_p.translate(m_layout.yTitle.center());
        m_p.rotate(-90);
        const QRectF turned(-m_layout.yTitle.height() / 2, -m_layout.yTitle.width() / 2,
                            m_layout.yTitle.height(), m_layout.yTitle.width());
        m_p.drawText(turned, Qt::AlignCenter, m_plot.y.title);
        m_p.restore();
        QFont bold = m_style.font;
        bold.setBold(true);
        m_p.setFont(bold);
        m_p.drawText(m_layout.title, Qt::AlignLeft | Qt::AlignTop,
                     QFontMetricsF(bold).elidedText(m_plot.title, Qt::ElideRight, m_layout.title.width()));
        m_p.setFont(m_style.font);
    }

    void across(const PlotLine& line) {
        const QRectF& f = m_layout.frame;
        m_p.setPen(QPen(m_style.text, 1, Qt::DashLine));
        if (line.horizontal) {
            const double y = m_layout.yOf(line.at);
            m_p.drawLine(QPointF(f.left(), y), QPointF(f.right(), y));
            m_p.drawText(QRectF(f.left(), y - m_metrics.height() * 1.1, f.width() - 6, m_metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, line.label);
        } else {
            const double x = m_layout.xOf(line.at);
            m_p.drawLine(QPointF(x, f.top()), QPointF(x, f.bottom()));
            m_p.drawText(QRectF(x + 4, f.top() + 2, f.right() - x, m_metrics.height()), Qt::AlignLeft,
                         line.label);
        }
    }

    void joined(const PlotSeries& s) {
        QPolygonF path;
        for (const PlotPoint& p : s.points)
            path << m_layout.at(p);
        m_p.setBrush(Qt::NoBrush);
        m_p.setPen(QPen(s.colour, m_style.lineWidth, s.line));
        if (s.line != Qt::NoPen)
            m_p.drawPolyline(path);
    }

    void point(const PlotSeries& s, const PlotPoint& p) {
        const QPointF at = m_layout.at(p);
        m_p.setPen(QPen(s.colour, 1.5));
        if (p.spreadX) {
            const double left = m_layout.xOf(p.spreadX->first), right = m_layout.xOf(p.spreadX->second);
            m_p.drawLine(QPointF(left, at.y()), QPointF(right, at.y()));
            for (const double x : {left, right})
                m_p.drawLine(QPointF(x, at.y() - 3), QPointF(x, at.y() + 3));
        }
        mark(s, at, markerSize());
        if (!m_layout.y.shows(p.y)) { // beyond the edge: an arrow that says so
            const double r = markerSize();
            m_p.drawLine(at, at + QPointF(0, 2.2 * r));
            m_p.drawPolyline(QPolygonF(
                {at + QPointF(-r / 2, 1.5 * r), at + QPointF(0, 2.2 * r), at + QPointF(r / 2, 1.5 * r)}));
        }
    }

    void mark(const PlotSeries& s, QPointF at, double r) {
        m_p.setPen(QPen(m_style.paper, 1));
        m_p.setBrush(s.colour);
        QPolygonF shape;
        switch (s.marker) {
        case Marker::None:
            return;
        case Marker::Circle:
            m_p.drawEllipse(at, r, r);
            return;
        case Marker::Square:
            m_p.drawRect(QRectF(at.x() - 0.9 * r, at.y() - 0.9 * r, 1.8 * r, 1.8 * r));
            return;
        case Marker::Triangle:
            shape << QPointF(0, -1.2 * r) << QPointF(1.1 * r, 0.8 * r) << QPointF(-1.1 * r, 0.8 * r);
            break;
        case Marker::Diamond:
            shape << QPointF(0, -1.3 * r) << QPointF(1.3 * r, 0) << QPointF(0, 1.3 * r)
                  << QPointF(-1.3 * r, 0);
            break;
        case Marker::Cross:
            m_p.setPen(QPen(s.colour, r * 0.7));
            m_p.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
            m_p.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
            return;
        case Marker::Star:
            for (int k = 0; k < 10; ++k) {
                const double angle = k * 0.62831853071795865, length = k % 2 == 0 ? 1.4 * r : 0.6 * r;
                shape << QPointF(length * std::sin(angle), -length * std::cos(angle));
            }
            break;
        }
        m_p.drawPolygon(shape.translated(at));
    }

    // Each where there is still room about its point; where there is none, the hover shows it.
    void labels() {
        std::vector<QRectF> taken;
        for (const PlotSeries& s : m_plot.series)
            for (const PlotPoint& p : s.points) {
                const QPointF at = m_layout.at(p);
                taken.push_back(
                    QRectF(at, at).adjusted(-markerSize(), -markerSize(), markerSize(), markerSize()));
            }
        for (const PlotSeries& s : m_plot.series)
            for (const PlotPoint& p : s.points)
                if (!p.label.isEmpty())
                    label(s, p, taken);
    }

    void label(const PlotSeries& s, const PlotPoint& p, std::vector<QRectF>& taken) {
        const QPointF at = m_layout.at(p);
        const double w = m_metrics.horizontalAdvance(p.label) + 2, h = m_metrics.height(),
                     r = markerSize() + 2;
        const std::array places{
            QRectF(at.x() + r, at.y() - h, w, h),     QRectF(at.x() - w / 2, at.y() - r - h, w, h),
            QRectF(at.x() - w / 2, at.y() + r, w, h), QRectF(at.x() - r - w, at.y() - h, w, h),
            QRectF(at.x() + r, at.y(), w, h),         QRectF(at.x() - r - w, at.y(), w, h)};
        for (const QRectF& place : places) {
            const bool free = std::none_of(taken.begin(), taken.end(),
                                           [&](const QRectF& t) { return t.intersects(place); });
            if (!free || !m_layout.frame.contains(place))
                continue;
            taken.push_back(place);
            overLines(place, p.label, s.colour.darker(135));
            return;
        }
    }

    // With an edge of paper, where it stands over a line.
    void overLines(const QRectF& place, const QString& text, const QColor& colour) {
        m_p.setPen(m_style.paper);
        for (const QPointF& off : {QPointF(-1.5, 0), QPointF(1.5, 0), QPointF(0, -1.5), QPointF(0, 1.5)})
            m_p.drawText(place.translated(off), Qt::AlignCenter, text);
        m_p.setPen(colour);
        m_p.drawText(place, Qt::AlignCenter, text);
    }

    void legend() {
        for (const auto& entry : m_layout.legend) {
            const PlotSeries& s = m_plot.series[entry.series];
            m_p.setPen(QPen(s.colour, m_style.lineWidth, s.line));
            if (s.line != Qt::NoPen)
                m_p.drawLine(entry.at, entry.at + QPointF(m_layout.sampleWidth, 0));
            mark(s, entry.at + QPointF(m_layout.sampleWidth / 2, 0), markerSize());
            m_p.setPen(m_style.text);
            m_p.drawText(QRectF(entry.at.x() + m_layout.sampleWidth + m_metrics.height() / 2,
                                entry.at.y() - m_metrics.height(), 4000, 2 * m_metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, s.name);
        }
    }

    void halo(const PlotHit& lit) {
        if (lit.series >= m_plot.series.size() || lit.point >= m_plot.series[lit.series].points.size())
            return;
        const PlotSeries& s = m_plot.series[lit.series];
        const QPointF at = m_layout.at(s.points[lit.point]);
        m_p.setBrush(Qt::NoBrush);
        m_p.setPen(QPen(s.colour, 2));
        m_p.drawEllipse(at, 2 * markerSize(), 2 * markerSize());
    }

    QPainter& m_p;
    const Plot& m_plot;
    const PlotStyle& m_style;
    QFontMetricsF m_metrics;
    PlotLayout m_layout;
};

} // namespace

void paintPlot(QPainter& painter, const QRectF& area, const Plot& plot, const PlotStyle& style,
               const std::optional<PlotHit>& lit) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    PlotPainter(painter, area, plot, style).paint(lit);
    painter.restore();
}

std::optional<PlotHit> plotPointAt(const QPointF& where, double reach, const QRectF& area, const Plot& plot,
                                   const PlotStyle& style) {
    const PlotLayout layout(area, plot, style);
    std::optional<PlotHit> best;
    for (std::size_t s = 0; s < plot.series.size(); ++s)
        for (std::size_t k = 0; k < plot.series[s].points.size(); ++k) {
            const QPointF at = layout.at(plot.series[s].points[k]);
            const double distance = std::hypot(at.x() - where.x(), at.y() - where.y());
            if (distance > reach)
                continue;
            reach = distance;
            best = PlotHit{s, k, at};
        }
    return best;
}

} // namespace thetalane
