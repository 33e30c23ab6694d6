#include "ui/who/hit_tree_view.h"

#include "core/engine/engine.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double trunk = 6; // from a disc to the line that its other hits hang on
constexpr double headLength = 7;
constexpr int longestName = 4; // letters in a disc

double discSize(const Appearance& a) {
    return a.projector() ? 38 : 26;
}

double rowHeight(const Appearance& a) {
    return std::max(discSize(a) + a.unit(), 2.6 * a.pixels(Appearance::Size::Small) + a.unit());
}

double edgeSpace(const Appearance& a) {
    return a.unit() / 4.0;
}

} // namespace

HitTreeView::HitTreeView(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("hitTree"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    connect(&appearance, &Appearance::changed, this, [this] {
        measure();
        update();
    });
    retranslate();
}

void HitTreeView::show(std::shared_ptr<const Run> run, std::shared_ptr<const HitTree> tree,
                       const std::optional<PerfectLinks>& perfect) {
    m_run = std::move(run);
    m_tree = std::move(tree);
    m_perfect = perfect;
    m_layout = m_tree ? layOut(*m_tree, mostDrawn) : HitTreeLayout();
    m_current = m_hovered = -1;
    measure();
    describe();
    update();
}

void HitTreeView::setTime(double time) {
    const auto passed = [this](double t) {
        return std::count_if(m_layout.nodes.begin(), m_layout.nodes.end(),
                             [&](const TreeNode& node) { return node.edge >= 0 && hitOf(node).time <= t; });
    };
    const bool changed = passed(m_time) != passed(time);
    m_time = time;
    if (changed)
        update();
}

void HitTreeView::setOpen(std::optional<std::size_t> collision) {
    if (collision == m_open)
        return;
    m_open = collision;
    for (std::size_t k = 0; k < m_layout.nodes.size(); ++k)
        if (m_layout.nodes[k].edge >= 0 && hitOf(m_layout.nodes[k]).collision == collision)
            m_current = int(k);
    describe();
    update();
}

// A millisecond, unless hits follow one another faster.
void HitTreeView::chooseDecimals() {
    m_decimals = 3;
    for (const TreeNode& node : m_layout.nodes) {
        const TreeNode* above = node.parent >= 0 ? &m_layout.nodes[std::size_t(node.parent)] : nullptr;
        if (node.edge >= 0 && above->edge >= 0 && hitOf(node).time - hitOf(*above).time < 1.5e-3)
            m_decimals = 4;
    }
}

void HitTreeView::measure() {
    chooseDecimals();
    const double disc = discSize(m_appearance), letters = m_appearance.unit();
    const QFontMetricsF name(m_appearance.font(Appearance::Size::Normal, true));
    const QFontMetricsF number(m_appearance.font(Appearance::Size::Small));
    const auto columns = std::size_t(m_layout.columns);
    m_columnWidth.assign(columns, disc);
    std::vector<double> labels(columns, 0);
    for (const TreeNode& node : m_layout.nodes) {
        const auto c = std::size_t(node.column);
        const QString text = bodyName(m_run->scene, node.body).left(longestName);
        m_columnWidth[c] = std::max(m_columnWidth[c], std::ceil(name.horizontalAdvance(text)) + letters);
        if (node.edge >= 0)
            for (const QString& label : {timeText(node), impulseText(node)})
                labels[c] = std::max(labels[c], std::ceil(number.horizontalAdvance(label)));
    }
    m_columnLeft.assign(columns, edgeSpace(m_appearance));
    for (std::size_t c = 1; c < columns; ++c)
        m_columnLeft[c] = m_columnLeft[c - 1] + m_columnWidth[c - 1] + trunk + 3 + labels[c] + headLength + 1;
    updateGeometry();
}

QSize HitTreeView::minimumSizeHint() const {
    if (m_columnLeft.empty())
        return {0, 0};
    const double space = edgeSpace(m_appearance);
    return QSizeF(m_columnLeft.back() + m_columnWidth.back() + space,
                  m_layout.rows * rowHeight(m_appearance) + 2 * space)
        .toSize();
}

QRectF HitTreeView::nodeRect(std::size_t k) const {
    const TreeNode& node = m_layout.nodes[k];
    const double disc = discSize(m_appearance), row = rowHeight(m_appearance);
    const auto c = std::size_t(node.column);
    return {m_columnLeft[c], edgeSpace(m_appearance) + node.row * row + (row - disc) / 2, m_columnWidth[c],
            disc};
}

QPointF HitTreeView::arrowMiddle(std::size_t k) const {
    const TreeNode& node = m_layout.nodes[k];
    const QRectF to = nodeRect(k), from = nodeRect(std::size_t(node.parent));
    return {(from.right() + trunk + to.left()) / 2, to.center().y()};
}

bool HitTreeView::happened(std::size_t k) const {
    const TreeNode& node = m_layout.nodes[k];
    return node.edge < 0 || hitOf(node).time <= m_time;
}

QString HitTreeView::timeText(const TreeNode& node) const {
    return QString::number(hitOf(node).time, 'f', m_decimals);
}

QString HitTreeView::impulseText(const TreeNode& node) const {
    return numberText(hitOf(node).impulse, 3);
}

QString HitTreeView::sentence(const Hit& hit) const {
    const QString from = bodyName(m_run->scene, hit.from), to = bodyName(m_run->scene, hit.to);
    const QString time = QString::number(hit.time, 'f', 4), impulse = numberText(hit.impulse);
    return hit.setMoving ? tr("%1 hits %2 at %3 s, impulse %4 N·s").arg(from, to, time, impulse)
                         : tr("%1 and %2 meet at %3 s, impulse %4 N·s").arg(from, to, time, impulse);
}

void HitTreeView::retranslate() {
    setAccessibleName(tr("Who hit whom"));
    describe();
}

void HitTreeView::describe() {
    const bool at = m_current >= 0 && m_layout.nodes[std::size_t(m_current)].edge >= 0;
    setAccessibleDescription(at ? sentence(hitOf(m_layout.nodes[std::size_t(m_current)])) : QString());
}

int HitTreeView::nodeAt(const QPointF& point) const {
    for (std::size_t k = 0; k < m_layout.nodes.size(); ++k) {
        const TreeNode& node = m_layout.nodes[k];
        if (node.edge < 0)
            continue;
        QRectF area = nodeRect(k).adjusted(0, -2, 2, 2);
        area.setLeft(nodeRect(std::size_t(node.parent)).right() + trunk / 2);
        if (area.contains(point))
            return int(k);
    }
    return -1;
}

void HitTreeView::go(int k) {
    if (k < 0)
        return;
    m_current = k;
    describe();
    update();
    QRectF where = nodeRect(std::size_t(k));
    where.setLeft(nodeRect(std::size_t(m_layout.nodes[std::size_t(k)].parent)).left());
    emit moved(where.toAlignedRect());
    emit chosen(hitOf(m_layout.nodes[std::size_t(k)]).collision);
}

// Along the arrows to the left and right, to the nearest hit above or below.
int HitTreeView::neighbour(int key) const {
    const auto& nodes = m_layout.nodes;
    const bool none = m_current < 0;
    if (none || key == Qt::Key_Home || key == Qt::Key_End) { // the first and the last in time
        int best = -1;
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (nodes[k].edge >= 0 &&
                (best < 0 || (key == Qt::Key_End) == (nodes[k].edge > nodes[std::size_t(best)].edge)))
                best = int(k);
        return best;
    }
    const TreeNode& at = nodes[std::size_t(m_current)];
    if (key == Qt::Key_Left)
        return nodes[std::size_t(at.parent)].edge >= 0 ? at.parent : -1;
    int best = -1, least = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const TreeNode& n = nodes[k];
        if (key == Qt::Key_Right) {
            if (n.parent == m_current)
                return int(k);
            continue;
        }
        const int rows = key == Qt::Key_Down ? n.row - at.row : at.row - n.row;
        const int far = 100 * rows + std::abs(n.column - at.column);
        if (n.edge >= 0 && rows > 0 && (best < 0 || far < least)) {
            best = int(k);
            least = far;
        }
    }
    return best;
}

bool HitTreeView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) { // the window's own arrows wait
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier && key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const int k = nodeAt(help->pos());
        if (k >= 0)
            QToolTip::showText(help->globalPos(), sentence(hitOf(m_layout.nodes[std::size_t(k)])), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

void HitTreeView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Home:
    case Qt::Key_End:
        return go(neighbour(event->key()));
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return go(m_current >= 0 ? m_current : neighbour(Qt::Key_Home));
    default:
        QWidget::keyPressEvent(event);
    }
}

void HitTreeView::mousePressEvent(QMouseEvent* event) {
    const int k = event->button() == Qt::LeftButton ? nodeAt(event->position()) : -1;
    if (k >= 0)
        go(k);
}

void HitTreeView::mouseMoveEvent(QMouseEvent* event) {
    const int k = nodeAt(event->position());
    if (k == m_hovered)
        return;
    m_hovered = k;
    setCursor(k >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    update();
}

void HitTreeView::leaveEvent(QEvent* event) {
    m_hovered = -1;
    update();
    QWidget::leaveEvent(event);
}

void HitTreeView::focusInEvent(QFocusEvent* event) {
    update();
    QWidget::focusInEvent(event);
}

void HitTreeView::focusOutEvent(QFocusEvent* event) {
    update();
    QWidget::focusOutEvent(event);
}

void HitTreeView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

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
                                                          : a.line().darker(110);
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
    p.setPen(happened(index) ? a.text() : a.quietText().lighter(130));
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
    QColor edge = done ? a.text() : a.line().darker(110), fill = ball ? edge : a.pin();
    if (chosen.isValid())
        edge = fill = chosen;
    p.setPen(QPen(edge, a.lineWidth() * 0.8));
    p.setBrush(fill);
    p.drawRoundedRect(r, r.height() / 2, r.height() / 2);
    p.setFont(a.font(Appearance::Size::Normal, true));
    p.setPen(chosen.isValid() || ball ? a.card() : done ? a.text() : a.quietText().lighter(130));
    p.drawText(r, Qt::AlignCenter, bodyName(m_run->scene, node.body).left(longestName));
    if (hasFocus() && int(index) == m_current) {
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
