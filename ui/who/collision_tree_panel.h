// Who hit whom: the tree of hits, what is left standing, and the hits after that. Every one opens.
#pragma once

#include "core/bowling/hit_tree.h"
#include "ui/panels/panel.h"

#include <optional>

class QListWidget;
class QScrollArea;
class QVBoxLayout;

namespace thetalane {

class HitTreeView;
class PinDeck;

class CollisionTreePanel : public Panel {
    Q_OBJECT
public:
    explicit CollisionTreePanel(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void takeRun();
    void showTree();
    void showWords();
    void showStanding();
    void showLater();
    void followPlayhead();
    void followTime(double time);
    void choose(std::size_t collision);
    QString chainText() const;
    QString leftOutText() const;

    std::shared_ptr<const Run> m_run; // the first chapter of a long one
    std::shared_ptr<const HitTree> m_tree;
    std::optional<PerfectLinks> m_perfect;
    QLabel* m_chain;
    QLabel* m_empty;
    QLabel* m_key; // what the numbers and the colours say
    HitTreeView* m_view;
    QScrollArea* m_treeScroll;
    QWidget* m_standing;
    PinDeck* m_deck;
    QLabel* m_left;
    QLabel* m_laterTitle;
    QListWidget* m_later;
    QLabel* m_leftOut;
    QVBoxLayout* m_column;
    bool m_stale = true;
    bool m_following = false;
};

} // namespace thetalane
