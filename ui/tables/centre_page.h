// Where the centre of mass is, how fast it goes, and the way it takes.
#pragma once

#include "ui/tables/table_page.h"

#include <memory>

namespace thetalane {

class CentreFigure;
class SheetTable;

class CentrePage : public TablePage {
    Q_OBJECT
public:
    static constexpr std::size_t mostMoments = 400;

    explicit CentrePage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;

protected:
    void showRun() override;
    void showTime() override;
    void restyle() override;

private:
    CentreFigure* m_figure;
    SheetTable* m_numbers;
    QLabel* m_note;
    std::shared_ptr<const Run> m_of;
    std::pair<double, double> m_times;
};

} // namespace thetalane
