// All bodies at the time of the playhead. Only the rows that are seen are looked up, so a crowd costs no more
// than a pair.
#pragma once

#include "ui/tables/table_page.h"

class QTableView;

namespace thetalane {

class BodiesModel;

class BodiesPage : public TablePage {
    Q_OBJECT
public:
    explicit BodiesPage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;

protected:
    void showRun() override;
    void showTime() override;
    void restyle() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fit();
    Sheet rowsOf(const std::vector<int>& rows) const;

    BodiesModel* m_model;
    QLabel* m_when;
    QTableView* m_table;
};

} // namespace thetalane
