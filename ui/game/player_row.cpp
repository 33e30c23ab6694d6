#include "ui/game/player_row.h"

#include "ui/game/player_colours.h"
#include "ui/panels/icon_button.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>

namespace thetalane {

PlayerRow::PlayerRow(const Context& context, int number, int colour, QWidget* parent)
    : Panel(context, parent)
    , m_number(number)
    , m_colour(colour)
    , m_colourButton(new QPushButton(this))
    , m_menu(new QMenu(this))
    , m_name(new QLineEdit(this))
    , m_remove(new IconButton(appearance(), Icon::Minus, "removePlayer", this)) {
    m_colourButton->setMenu(m_menu);
    m_colourButton->setFocusPolicy(Qt::TabFocus);
    m_colourButton->setProperty("quiet", true);
    m_name->setMaxLength(24);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_colourButton);
    layout->addWidget(m_name, 1);
    layout->addWidget(m_remove);
    connect(m_remove, &IconButton::clicked, this, &PlayerRow::removeAsked);
    connect(m_name, &QLineEdit::returnPressed, this, &PlayerRow::entered);
    restyle();
    setNumber(number);
}

Player PlayerRow::player() const {
    const QString typed = m_name->text().trimmed();
    return {(typed.isEmpty() ? m_name->placeholderText() : typed).toStdString(), m_colour};
}

void PlayerRow::setNumber(int number) {
    m_number = number;
    m_name->setObjectName(QStringLiteral("playerName%1").arg(number + 1));
    m_colourButton->setObjectName(QStringLiteral("playerColour%1").arg(number + 1));
    m_remove->setObjectName(QStringLiteral("removePlayer%1").arg(number + 1));
    retranslate();
}

void PlayerRow::setRemovable(bool on) {
    m_remove->setVisible(on);
}

void PlayerRow::setColour(int colour) {
    m_colour = colour;
    restyle();
    retranslate();
}

void PlayerRow::retranslate() {
    const QString name = tr("Player %1").arg(m_number + 1);
    m_name->setPlaceholderText(name);
    m_name->setAccessibleName(tr("Name of player %1").arg(m_number + 1));
    m_name->setToolTip(tr("The name on the score sheet; left empty, it is \"%1\"").arg(name));
    const QString colour = tr("Colour of player %1: %2").arg(m_number + 1).arg(playerColourName(m_colour));
    m_colourButton->setAccessibleName(colour);
    m_colourButton->setToolTip(colour);
    const QString remove = tr("Take player %1 out").arg(m_number + 1);
    m_remove->setWords(remove, remove);
    fillMenu();
}

void PlayerRow::restyle() {
    Panel::restyle();
    const int side = 2 * appearance().unit();
    layout()->setSpacing(appearance().unit() / 2);
    m_colourButton->setIcon(playerIcon(m_colour, side));
    m_colourButton->setIconSize(QSize(side, side));
    m_name->setFont(appearance().font(Appearance::Size::Normal));
    m_menu->setFont(appearance().font(Appearance::Size::Normal));
}

void PlayerRow::fillMenu() {
    m_menu->clear();
    for (int colour = 0; colour < int(mostPlayers); ++colour)
        m_menu->addAction(playerIcon(colour, 2 * appearance().unit()), playerColourName(colour),
                          [this, colour] { setColour(colour); });
}

} // namespace thetalane
