#include "ui/who/hit_tree_view.h"

#include "core/engine/engine.h"
#include "ui/who/hit_tree_sizes.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

#include <QFontMetricsF>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace thetalane {

using namespace hittree;

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

} // namespace thetalane
