// The collisions of the run, to look through, to choose from, and to copy with every digit; of a long run, a
// chapter at a time.
#pragma once

#include "ui/panels/panel.h"

class QStackedLayout;
class QTableView;

namespace thetalane {

class CollisionModel;
class IconButton;

class CollisionList : public Panel {
    Q_OBJECT
public:
    explicit CollisionList(const Context& context, QWidget* parent = nullptr);

    void copySelected() const;

    void retranslate() override;

protected:
    void restyle() override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* makePage();
    void showRun();
    void showChapter();
    void showPart();
    bool stepBeyond(int key); // from the last row on, from the first one back
    void fitColumns();
    QString widestText(int column) const;
    void followPlayhead();
    void open(int row);

    CollisionModel* m_model;
    QTableView* m_table;
    QWidget* m_foot; // which of the run's collisions these are, where they are not all
    QLabel* m_which;
    IconButton* m_earlier;
    IconButton* m_later;
    QWidget* m_page;
    QLabel* m_empty;
    QStackedLayout* m_stack;
    bool m_following = false;
    bool m_stale = false; // emptied while nobody looked
};

} // namespace thetalane
