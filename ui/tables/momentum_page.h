// The momentum diagram of the open collision, with the sums in numbers below.
#pragma once

#include "ui/tables/table_page.h"

namespace thetalane {

class MomentumFigure;

class MomentumPage : public TablePage {
    Q_OBJECT
public:
    explicit MomentumPage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;

protected:
    void showRun() override;
    void restyle() override;

private:
    MomentumFigure* m_figure;
    QLabel* m_sums;
    QLabel* m_none;
};

} // namespace thetalane
