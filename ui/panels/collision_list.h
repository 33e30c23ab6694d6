// All collisions of the run, to look through, to choose from, and to copy with every digit.
#pragma once

#include "ui/panels/panel.h"

class QStackedLayout;
class QTableView;

namespace thetalane {

class CollisionModel;

class CollisionList : public Panel {
    Q_OBJECT
public:
    explicit CollisionList(const Context& context, QWidget* parent = nullptr);

    void copySelected() const;

    void retranslate() override;

protected:
    void restyle() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showRun();
    void fitColumns();
    QString widestText(int column) const;
    void followPlayhead();
    void open(int row);

    CollisionModel* m_model;
    QTableView* m_table;
    QLabel* m_empty;
    QStackedLayout* m_stack;
    bool m_following = false;
};

} // namespace thetalane
