// The open collision in numbers, before and after, with its checks; while none is open, all bodies of now.
#pragma once

#include "ui/tables/table_page.h"

class QScrollArea;
class QStackedLayout;

namespace thetalane {

class BodiesPage;
class SheetTable;

class CollisionPage : public TablePage {
    Q_OBJECT
public:
    explicit CollisionPage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;

protected:
    void showRun() override;
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeOpen();
    QWidget* makeNone();
    void showNumbers();

    QLabel* m_which;
    SheetTable* m_numbers;
    SheetTable* m_checks;
    QLabel* m_none;
    BodiesPage* m_bodies;
    QScrollArea* m_scroll;
    QStackedLayout* m_stack;
};

} // namespace thetalane
