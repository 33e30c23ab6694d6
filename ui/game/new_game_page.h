// Before a game: who plays, by which rules, on which lane, with how sure a hand; or a saved game goes on.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace thetalane {

class NumberField;
class PlayerRow;
class SavedGamesList;

class NewGamePage : public Panel {
    Q_OBJECT
public:
    NewGamePage(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void refresh(); // what lies on the disk
    void retranslate() override;

protected:
    void restyle() override;

private:
    void build();
    QLabel* addChoice(const char* name, QWidget* field);
    PlayerRow* addPlayer();
    void removePlayer(PlayerRow* row);
    void countPlayers();
    void takeRelease();
    void showRelease();
    void start();

    Context m_context;
    Alley& m_alley;
    QVBoxLayout* m_column;
    QVBoxLayout* m_rows;
    QFormLayout* m_choices = nullptr;
    QPushButton* m_continue;
    QLabel* m_heading;
    std::vector<PlayerRow*> m_players;
    QPushButton* m_add;
    QComboBox* m_rules;
    QComboBox* m_lane;
    QComboBox* m_release;
    NumberField* m_seed;
    QLabel* m_rulesLabel = nullptr;
    QLabel* m_laneLabel = nullptr;
    QLabel* m_releaseLabel = nullptr;
    QLabel* m_seedLabel = nullptr;
    QPushButton* m_start;
    SavedGamesList* m_saved;
};

} // namespace thetalane
