// Strikes, spares, opens, averages, pocket hits: of this game or of all saved ones, each player a column.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace thetalane {

class StatisticsPanel : public Panel {
    Q_OBJECT
public:
    StatisticsPanel(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;
    void showEvent(QShowEvent* event) override;

private:
    struct Column {
        QString name;
        int colour = -1; // none: of all together
        Statistics statistics;
    };

    void refresh();
    void fitNames();
    std::vector<Column> ofThisGame() const;
    std::vector<Column> ofAllGames() const;
    void fill(const std::vector<Column>& columns);

    Alley& m_alley;
    QComboBox* m_which;
    QLabel* m_empty;
    QTableWidget* m_table;
    QLabel* m_note;
};

} // namespace thetalane
