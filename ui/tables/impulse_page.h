// The impulse of every collision over time; a click opens that collision. Of collisions closer together than
// they could be drawn, the one of the greatest impulse stands.
#pragma once

#include "ui/tables/table_page.h"

namespace thetalane {

class TimeView;

class ImpulsePage : public TablePage {
    Q_OBJECT
public:
    static constexpr std::size_t mostBars = 300;

    explicit ImpulsePage(const Context& context, QWidget* parent = nullptr);

    Sheet sheet() const override;
    void retranslate() override;
    const std::vector<std::size_t>& shown() const { return m_shown; } // indices of the bars' collisions

protected:
    void showRun() override;
    void showTime() override;
    void restyle() override;

private:
    std::vector<std::size_t> toShow() const;

    TimeView* m_view;
    QLabel* m_note;
    QLabel* m_key;
    std::vector<std::size_t> m_shown;
};

} // namespace thetalane
