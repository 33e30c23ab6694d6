// The tree of hits, drawn: an arrow for each hit, its time above and its impulse below. What has not happened
// yet is grey.
#pragma once

#include "ui/appearance.h"
#include "ui/who/hit_tree_layout.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace thetalane {

struct Run;

class HitTreeView : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t mostDrawn = 80; // edges

    explicit HitTreeView(const Appearance& appearance, QWidget* parent = nullptr);

    // perfect: whose links are marked.
    void show(std::shared_ptr<const Run> run, std::shared_ptr<const HitTree> tree,
              const std::optional<PerfectLinks>& perfect);
    void setTime(double time);                          // [s]
    void setOpen(std::optional<std::size_t> collision); // marked; nothing is chosen by it

    const HitTreeLayout& layoutOfTree() const { return m_layout; }
    QRectF nodeRect(std::size_t node) const;
    QPointF arrowMiddle(std::size_t node) const; // of the hit on it
    bool happened(std::size_t node) const;       // a root has
    QString sentence(const Hit& hit) const;      // "ball hits 1 at 2.346 s with 12.3 N·s"

    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override;

    void retranslate();

signals:
    void chosen(std::size_t collision); // by mouse or keyboard
    void moved(const QRect& where);     // what was gone to by keyboard

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void measure();
    void chooseDecimals();
    void describe();
    void go(int node);
    int nodeAt(const QPointF& point) const; // whose hit or disc is there; -1
    int neighbour(int key) const;
    const Hit& hitOf(const TreeNode& node) const { return m_tree->edges[std::size_t(node.edge)]; }
    QString timeText(const TreeNode& node) const;
    QString impulseText(const TreeNode& node) const;
    void paintArrow(QPainter& p, const TreeNode& node, std::size_t index) const;
    void paintLabels(QPainter& p, const TreeNode& node, std::size_t index) const;
    void paintNode(QPainter& p, const TreeNode& node, std::size_t index) const;
    QPainterPath arrowPath(const TreeNode& node, std::size_t index) const;
    QColor nodeColour(int body) const; // of the open collision's two; invalid: of no other

    const Appearance& m_appearance;
    std::shared_ptr<const Run> m_run;
    std::shared_ptr<const HitTree> m_tree;
    std::optional<PerfectLinks> m_perfect;
    HitTreeLayout m_layout;
    std::vector<double> m_columnLeft, m_columnWidth; // of the discs [px]
    int m_decimals = 3;                              // of a time
    double m_time = 0;
    std::optional<std::size_t> m_open;
    int m_current = -1; // node
    int m_hovered = -1;
};

} // namespace thetalane
