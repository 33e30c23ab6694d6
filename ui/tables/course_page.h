// Kinetic energy and momentum of all bodies over time. Between events the lines are exact; the playhead
// stands in both plots and can be moved there.
#pragma once

#include "core/timeline/history.h"
#include "ui/tables/table_page.h"

#include <memory>

namespace thetalane {

class TimeView;

class CoursePage : public TablePage {
    Q_OBJECT
public:
    static constexpr std::size_t mostMoments = 1200;

    explicit CoursePage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;
    const History& shown() const { return m_history; }

protected:
    void showRun() override;
    void showTime() override;
    void restyle() override;

private:
    void showPlots();

    History m_history;
    std::shared_ptr<const Run> m_of; // the chapter it is of: another selection needs no other history
    std::pair<double, double> m_times;
    TimeView* m_energy;
    TimeView* m_momentum;
    QLabel* m_note;
};

} // namespace thetalane
