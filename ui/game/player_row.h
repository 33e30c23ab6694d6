// One player before a game: the colour, the name, and out again.
#pragma once

#include "core/bowling/game.h"
#include "ui/panels/panel.h"

class QLineEdit;
class QMenu;
class QPushButton;

namespace thetalane {

class IconButton;

class PlayerRow : public Panel {
    Q_OBJECT
public:
    PlayerRow(const Context& context, int number, int colour, QWidget* parent); // number from 0

    Player player() const; // a name left empty is "Player 1"
    int colour() const { return m_colour; }
    void setNumber(int number);
    void setRemovable(bool on);
    QLineEdit* nameEdit() const { return m_name; }

    void retranslate() override;

signals:
    void removeAsked();
    void entered(); // Return in the name

protected:
    void restyle() override;

private:
    void setColour(int colour);
    void fillMenu();

    int m_number;
    int m_colour;
    QPushButton* m_colourButton;
    QMenu* m_menu;
    QLineEdit* m_name;
    IconButton* m_remove;
};

} // namespace thetalane
