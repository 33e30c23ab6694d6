// The rail: one entry for each room, and the panel of the one that is open. A room is furnished when it is
// first entered, so that the program starts at once and pays for what is looked at.
#pragma once

#include "ui/appearance.h"
#include "ui/rail/rooms.h"

#include <QWidget>

#include <array>
#include <functional>
#include <optional>

class QStackedWidget;
class QVBoxLayout;

namespace thetalane {

class RailButton;

class Rail : public QWidget {
    Q_OBJECT
public:
    // stack: where the panels stand; not owned.
    Rail(const Appearance& appearance, QStackedWidget& stack, QWidget* parent = nullptr);

    // make: called once, with the parent the panel is to have.
    void furnish(Room room, std::function<QWidget*(QWidget* parent)> make);
    void setWords(Room room, const QString& name, const QString& toolTip);
    void setOffered(Room room, bool offered); // whether it has an entry now
    bool isOffered(Room room) const;

    Room current() const { return m_current; }
    bool isOpen() const { return m_open; }
    QWidget* panel(Room room); // furnished if it was not
    bool isFurnished(Room room) const { return m_places[std::size_t(room)].panel; }
    // The k-th entry on offer, from 0; nothing beyond the last.
    std::optional<Room> offered(int k) const;

    QSize sizeHint() const override;

public slots:
    void enter(thetalane::Room room);
    void setOpen(bool open); // folded away, the lane has all the room
    void restyle();

signals:
    void entered(thetalane::Room room);
    void openChanged(bool open);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Place {
        RailButton* button = nullptr;
        std::function<QWidget*(QWidget*)> make{};
        QWidget* panel = nullptr;
    };
    Place& place(Room room) { return m_places[std::size_t(room)]; }
    void arrange();
    void click(Room room);

    const Appearance& m_appearance;
    QStackedWidget& m_stack;
    QVBoxLayout* m_column;
    std::array<Place, roomCount> m_places;
    Room m_current = Room::Steps;
    bool m_open = true;
};

} // namespace thetalane
