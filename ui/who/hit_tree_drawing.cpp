#include "core/engine/engine.h"
#include "ui/who/hit_tree_sizes.h"
#include "ui/who/hit_tree_view.h"
#include "ui/words/worked_steps.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace thetalane {

using namespace hittree;

QPainterPath HitTreeView::arrowPath(const TreeNode& node, std::size_t index) const {
    const QRectF to = nodeRect(index), from = nodeRect(std::size_t(node.parent));
    const double x = from.right() + trunk, y = to.center().y(), end = to.left() - 2;
    QPainterPath path;
    if (node.row == m_layout.nodes[std::size_t(node.parent)].row) {
        path.moveTo(from.right(), y);
    } else {
        const double bend = 5;
        path.moveTo(from.right(), from.center().y());
        path.lineTo(x - bend, from.center().y());
        path.quadTo(x, from.center().y(), x, from.center().y() + bend);
        path.lineTo(x, y - bend);
        path.quadTo(x, y, x + bend, y);
    }
    path.lineTo(end, y);
    return path;
}

void HitTreeView::paintArrow(QPainter& p, const TreeNode& node, std::size_t index) const {
    const Appearance& a = m_appearance;
    const QPainterPath path = arrowPath(node, index);
    const bool done = happened(index), open = m_open == hitOf(node).collision;
    if (m_perfect && isPerfectLink(m_run->scene, hitOf(node), m_perfect->hand)) {
        QColor amber = a.ink(Ink::Triangle);
        amber.setAlphaF(done ? 0.75F : 0.25F);
        p.setPen(QPen(amber, 3.5 * a.lineWidth(), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
        p.setBrush(Qt::NoBrush);
        p.drawPath(path);
    }
    const QColor colour = open || int(index) == m_hovered ? a.accent()
                          : done                          ? a.text()
                                 : (a.dark() ? a.line().lighter(125) : a.line().darker(110));
    const bool met = !hitOf(node).setMoving; // both moved: an arrow at either end
    p.setPen(QPen(colour, (open ? 1.6 : 0.8) * a.lineWidth(), Qt::SolidLine, Qt::FlatCap));
    p.setBrush(Qt::NoBrush);
    p.drawPath(path);
    const auto head = [&](const QPointF& tip, double way) {
        p.setPen(Qt::NoPen);
        p.setBrush(colour);
        p.drawPolygon(QPolygonF{tip, tip - QPointF(way * headLength, headLength / 2.2),
                                tip - QPointF(way * headLength, -headLength / 2.2)});
    };
    head({nodeRect(index).left() - 1, nodeRect(index).center().y()}, 1);
    if (met)
        head(
            {nodeRect(std::size_t(node.parent)).right() + 1, nodeRect(std::size_t(node.parent)).center().y()},
            -1);
}

void HitTreeView::paintLabels(QPainter& p, const TreeNode& node, std::size_t index) const {
    const Appearance& a = m_appearance;
    const QRectF to = nodeRect(index);
    const double left = nodeRect(std::size_t(node.parent)).right() + trunk + 2, y = to.center().y();
    const double width = to.left() - headLength - left, height = 1.4 * a.pixels(Appearance::Size::Small);
    p.setFont(a.font(Appearance::Size::Small));
    p.setPen(happened(index) ? a.text() : a.faintText());
    p.drawText(QRectF(left, y - height - 1, width, height), Qt::AlignCenter, timeText(node));
    p.drawText(QRectF(left, y + 2, width, height), Qt::AlignCenter, impulseText(node));
}

QColor HitTreeView::nodeColour(int body) const {
    const auto all = m_run->timeline.collisions();
    if (!m_open || *m_open >= all.size() || !all[*m_open].involves(body))
        return {};
    return m_appearance.ink(all[*m_open].first == body ? Ink::First : Ink::Second);
}

void HitTreeView::paintNode(QPainter& p, const TreeNode& node, std::size_t index) const {
    const Appearance& a = m_appearance;
    const Body& body = m_run->scene.bodies[std::size_t(node.body)];
    const bool done = happened(index), ball = body.kind == BodyKind::Ball;
    const QColor chosen = nodeColour(node.body);
    const QRectF r = nodeRect(index).adjusted(1, 1, -1, -1);
    QColor edge = done ? a.text() : (a.dark() ? a.line().lighter(125) : a.line().darker(110)),
           fill = ball ? edge : a.pin();
    if (chosen.isValid())
        edge = fill = chosen;
    p.setPen(QPen(edge, a.lineWidth() * 0.8));
    p.setBrush(fill);
    p.drawRoundedRect(r, r.height() / 2, r.height() / 2);
    p.setFont(a.font(Appearance::Size::Normal, true));
    p.setPen(chosen.isValid() || ball ? a.card() : done ? a.text() : a.faintText());
    p.drawText(r, Qt::AlignCenter, bodyName(m_run->scene, node.body).left(longestName));
    if (hasFocus() && int(index) == std::max(0, m_current)) { // at first where the keys begin
        p.setPen(QPen(a.accent(), a.lineWidth()));
        p.setBrush(Qt::NoBrush);
        const QRectF ring = r.adjusted(-2, -2, 2, 2);
        p.drawRoundedRect(ring, ring.height() / 2, ring.height() / 2);
    }
}

void HitTreeView::paintEvent(QPaintEvent*) {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    // The late below the early, so that a grey trunk does not cover what has happened.
    for (const bool done : {false, true})
        for (std::size_t k = 0; k < m_layout.nodes.size(); ++k)
            if (m_layout.nodes[k].edge >= 0 && happened(k) == done)
                paintArrow(p, m_layout.nodes[k], k);
    for (std::size_t k = 0; k < m_layout.nodes.size(); ++k) {
        if (m_layout.nodes[k].edge >= 0)
            paintLabels(p, m_layout.nodes[k], k);
        paintNode(p, m_layout.nodes[k], k);
    }
}

} // namespace thetalane
