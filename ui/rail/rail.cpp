#include "ui/rail/rail.h"

#include "ui/rail/rail_button.h"

#include <QKeyEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {

Rail::Rail(const Appearance& appearance, QStackedWidget& stack, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_stack(stack)
    , m_column(new QVBoxLayout(this)) {
    setObjectName("rail");
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(0);
    for (int k = 0; k < roomCount; ++k) {
        const Room room{k};
        auto* button = new RailButton(appearance, room, this);
        button->setObjectName(QStringLiteral("room%1").arg(k));
        button->hide(); // until there is something in it
        connect(button, &RailButton::clicked, this, [this, room] { click(room); });
        place(room).button = button;
        m_column->addWidget(button);
    }
    m_column->addStretch(1);
    connect(&appearance, &Appearance::changed, this, &Rail::restyle);
}

void Rail::furnish(Room room, std::function<QWidget*(QWidget*)> make) {
    place(room).make = std::move(make);
    setOffered(room, true);
}

void Rail::setWords(Room room, const QString& name, const QString& toolTip) {
    RailButton& button = *place(room).button;
    button.setText(name);
    button.setToolTip(toolTip);
    button.setAccessibleName(toolTip);
    arrange();
}

void Rail::setOffered(Room room, bool offered) {
    if (isOffered(room) == offered)
        return;
    place(room).button->setVisible(offered);
    arrange();
}

bool Rail::isOffered(Room room) const {
    return !m_places[std::size_t(room)].button->isHidden();
}

std::optional<Room> Rail::offered(int k) const {
    for (int r = 0; r < roomCount; ++r)
        if (isOffered(Room{r}) && k-- == 0)
            return Room{r};
    return std::nullopt;
}

QWidget* Rail::panel(Room room) {
    Place& p = place(room);
    if (!p.panel) {
        p.panel = p.make(&m_stack);
        m_stack.addWidget(p.panel);
    }
    return p.panel;
}

void Rail::enter(Room room) {
    m_current = room;
    m_stack.setCurrentWidget(panel(room));
    setOpen(true);
    for (const Place& p : m_places)
        p.button->setChecked(p.button->room() == room);
    emit entered(room);
}

void Rail::setOpen(bool open) {
    m_stack.setVisible(open);
    place(m_current).button->setChecked(open);
    if (std::exchange(m_open, open) != open)
        emit openChanged(open);
}

// The entry of the room that is open folds it away, as a drawer is pushed shut.
void Rail::click(Room room) {
    if (room == m_current && m_open)
        setOpen(false);
    else
        enter(room);
}

void Rail::restyle() {
    arrange();
    update();
}

QSize Rail::sizeHint() const {
    int width = 0;
    for (const Place& p : m_places)
        width = std::max(width, p.button->fullSize().width());
    return {width, 0};
}

// Names below the icons where there is room for all of them and in a window that is wide enough, else icons.
void Rail::arrange() {
    int needed = 0;
    for (const Place& p : m_places)
        if (!p.button->isHidden())
            needed += p.button->fullSize().height();
    const bool narrow = window()->width() < 100 * m_appearance.unit(); // the lane needs it more
    const bool compact = narrow || needed > height();
    for (const Place& p : m_places)
        p.button->setCompact(compact);
    int width = 0;
    for (const Place& p : m_places)
        if (!p.button->isHidden())
            width = std::max(width, p.button->sizeHint().width());
    setFixedWidth(std::max(width, 1));
}

void Rail::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

// Up and down among the entries, as in a list.
void Rail::keyPressEvent(QKeyEvent* event) {
    const int way = event->key() == Qt::Key_Down ? 1 : event->key() == Qt::Key_Up ? -1 : 0;
    const auto* from = qobject_cast<RailButton*>(focusWidget());
    if (!way || !from)
        return QWidget::keyPressEvent(event);
    for (int r = int(from->room()) + way; r >= 0 && r < roomCount; r += way)
        if (isOffered(Room{r})) {
            place(Room{r}).button->setFocus(Qt::TabFocusReason);
            return;
        }
}

} // namespace thetalane
