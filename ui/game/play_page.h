// While a game is on: whose turn it is and what stands, the one button that goes on, what has just been
// bowled, and every delivery to be seen again.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QBoxLayout;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace thetalane {

class PinDeck;

class PlayPage : public Panel {
    Q_OBJECT
public:
    PlayPage(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;

private:
    void build();
    void adopt();
    void showTurn();
    void showTold();
    void showNotes();
    void showButtons();
    void showList();
    void announce();
    void replayItem(QListWidgetItem* item);

    Alley& m_alley;
    QBoxLayout* m_column;
    QLabel* m_name;
    QLabel* m_place;
    PinDeck* m_deck;
    QLabel* m_standing;
    QPushButton* m_go;
    QLabel* m_told;
    QLabel* m_detail;
    QLabel* m_note;
    QLabel* m_fault;
    QPushButton* m_undo;
    QPushButton* m_foul;
    QPushButton* m_again;
    QLabel* m_heading;
    QListWidget* m_list;
    QLabel* m_conditions;
    QPushButton* m_leave;
    std::vector<DeliveryPlace> m_places; // of the rows of the list
};

} // namespace thetalane
