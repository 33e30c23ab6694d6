#include "ui/lane/overlay_painter.h"

#include "ui/lane/arrow.h"
#include "ui/lane/label.h"
#include "ui/lane/scale.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

constexpr double roomy = 680; // [px] a larger view has larger labels

class Overlay {
public:
    Overlay(QPainter& painter, const StepOverlay& overlay, const Appearance& look, const QRectF& area)
        : m_painter(painter)
        , m_o(overlay)
        , m_look(look)
        , m_px(painter)
        , m_layout(area.adjusted(6, 6, -6, -6))
        , m_textSize(std::min(area.width(), area.height()) < roomy ? Appearance::Size::Normal
                                                                   : Appearance::Size::Large) {}

    OverlayPlaces paint(const Scene& scene, const QRectF& area, const std::vector<QRectF>& keepOut) {
        for (const QRectF& rect : keepOut)
            m_layout.avoid(rect);
        if (m_o.wall && scene.frame)
            paintWall(*scene.frame, area);
        for (const OverlayLine& line : m_o.lines)
            paintLine(line);
        for (const OverlayArc& arc : m_o.arcs)
            paintArc(arc);
        for (const OverlayArrow& arrow : m_o.arrows)
            paintOne(arrow);
        m_painter.setPen(Qt::NoPen);
        m_painter.setBrush(m_look.text());
        m_painter.drawEllipse(m_px.at(m_o.contact), 1.4 * m_look.lineWidth(), 1.4 * m_look.lineWidth());
        paintNames();
        paintLabels();
        return std::move(m_places);
    }

private:
    struct Waiting {
        OverlayLabel label;
        QPointF anchor, away;
        QColor colour;
    };

    void wait(const OverlayLabel& label, const QPointF& anchor, const QPointF& away, Ink ink) {
        if (!label.symbol.isEmpty() || !label.text.isEmpty())
            m_waiting.push_back({label, anchor, away, m_look.textInk(ink)});
    }

    QPointF awayFromContact(const QPointF& p) const {
        const QPointF d = p - m_px.at(m_o.contact);
        return std::hypot(d.x(), d.y()) > 1 ? d : QPointF(0, -1);
    }

    void paintWall(const Frame& frame, const QRectF& area) {
        const bool upright = *m_o.wall == Side::Left || *m_o.wall == Side::Right;
        const double far = 1e4;
        const Vec2d low{frame.left.value_or(-far), frame.bottom.value_or(-far)};
        const Vec2d high{frame.right.value_or(far), frame.top.value_or(far)};
        const Vec2d at = m_o.contact;
        const QLineF wall = upright ? QLineF(m_px.at({at.x, low.y}), m_px.at({at.x, high.y}))
                                    : QLineF(m_px.at({low.x, at.y}), m_px.at({high.x, at.y}));
        m_painter.setPen(QPen(m_look.ink(Ink::Second), 2.5 * m_look.lineWidth(), Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(wall);
        if (area.isValid())
            m_layout.avoid(wall);
    }

    void paintLine(const OverlayLine& line) {
        const QLineF at(m_px.at(line.from), m_px.at(line.to));
        const bool axis = line.labelAtEnd;
        QPen pen(axis ? faded(m_look.ink(line.ink), 0.75) : m_look.ink(line.ink),
                 line.bold ? 1.5 * m_look.lineWidth() : 0.6 * m_look.lineWidth(), Qt::SolidLine,
                 Qt::RoundCap);
        if (line.dashed)
            pen.setDashPattern(axis ? QList<qreal>{7, 4} : QList<qreal>{2, 4});
        m_painter.setPen(pen);
        m_painter.drawLine(at);
        if (line.bold || axis)
            m_layout.avoid(at);
        if (axis)
            wait(line.label, at.p2(), at.p2() - at.p1(), line.ink);
        else
            wait(line.label, at.center(), triangleSide(at), line.ink);
    }

    // Outwards from the triangle: from its middle to the side's middle.
    QPointF triangleSide(const QLineF& side) const {
        QPointF middle;
        for (const OverlayLine& line : m_o.lines)
            if (line.bold)
                middle += (m_px.at(line.from) + m_px.at(line.to)) / 2;
        const auto sides = std::count_if(m_o.lines.begin(), m_o.lines.end(), [](auto& l) { return l.bold; });
        const QPointF normal(-side.dy(), side.dx());
        const QPointF out = side.center() - (sides > 0 ? middle / double(sides) : side.center());
        return QPointF::dotProduct(normal, out) < 0 ? -normal : normal;
    }

    void paintArc(const OverlayArc& arc) {
        const QPointF centre = m_px.at(arc.centre);
        const double r = std::max(m_px.length(arc.radius), 14.0);
        m_painter.setPen(QPen(m_look.ink(Ink::Triangle), m_look.lineWidth()));
        m_painter.setBrush(Qt::NoBrush);
        const double degrees = arc.angle * 180 / std::numbers::pi;
        m_painter.drawArc(QRectF(centre.x() - r, centre.y() - r, 2 * r, 2 * r), 0,
                          int(std::lround(degrees * 16)));
        const double middle = arc.angle / 2;
        const QPointF out(std::cos(middle), -std::sin(middle));
        for (int k = 0; k < 8; ++k) {
            const double from = -arc.angle * k / 8;
            const double to = -arc.angle * (k + 1) / 8;
            m_layout.avoid(QLineF(centre + r * QPointF(std::cos(from), std::sin(from)),
                                  centre + r * QPointF(std::cos(to), std::sin(to))));
        }
        wait(arc.label, centre + out * r, out, Ink::Triangle);
    }

    void paintOne(const OverlayArrow& arrow) {
        const double width = (arrow.bold ? 1.75 : 1.1) * m_look.lineWidth();
        QLineF at(m_px.at(arrow.from), m_px.at(arrow.to));
        if (arrow.shift != 0 && at.length() > 0) {
            // To the same side whichever way the arrow points, or two opposite ones would meet again.
            QPointF side = QPointF(-at.dy(), at.dx()) / at.length();
            if (side.y() < 0 || (side.y() == 0 && side.x() < 0))
                side = -side;
            at.translate(side * arrow.shift * 1.3 * width);
        }
        paintArrow(m_painter, at.p1(), at.p2(),
                   {faded(m_look.ink(arrow.ink), arrow.opacity), width, arrow.dashed});
        const bool none = at.length() < 1;
        if (!none) {
            m_layout.avoid(at);
            m_places.arrows.push_back(at);
        }
        wait(arrow.label, at.p2(), none ? awayFromContact(at.p2()) : at.p2() - at.p1(), arrow.ink);
    }

    void paintNames() {
        for (const OverlayDisc& disc : m_o.discs) {
            QFont font = m_look.font(Appearance::Size::Large, true);
            const double radius = m_px.length(disc.radius);
            const QSizeF size = QFontMetricsF(font).size(Qt::TextSingleLine, disc.name);
            const QRectF at = m_layout.placeInside(size, m_px.at(disc.centre), radius,
                                                   awayFromContact(m_px.at(disc.centre)));
            m_layout.avoidSoftly(m_px.at(disc.centre), radius);
            m_painter.setFont(font);
            m_painter.setPen(m_look.textInk(disc.ink));
            m_painter.drawText(at, Qt::AlignCenter, disc.name);
        }
    }

    void paintLabels() {
        for (const Waiting& w : m_waiting) {
            const QRectF at = m_layout.place(labelSize(w.label, m_look, m_textSize), w.anchor, w.away);
            paintLabel(m_painter, at, w.label, w.colour, m_look, m_textSize);
            m_places.labels.push_back(at);
        }
    }

    QPainter& m_painter;
    const StepOverlay& m_o;
    const Appearance& m_look;
    const Pixels m_px;
    LabelLayout m_layout;
    Appearance::Size m_textSize;
    std::vector<Waiting> m_waiting;
    OverlayPlaces m_places;
};

} // namespace

OverlayPlaces paintOverlay(QPainter& painter, const StepOverlay& overlay, const Scene& scene,
                           const Appearance& appearance, const QRectF& area,
                           const std::vector<QRectF>& keepOut) {
    painter.setRenderHint(QPainter::Antialiasing);
    return Overlay(painter, overlay, appearance, area).paint(scene, area, keepOut);
}

} // namespace thetalane
