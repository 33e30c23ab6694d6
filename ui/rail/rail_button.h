// An entry of the rail: an icon with its name below, or the icon alone where the room is short.
#pragma once

#include "ui/appearance.h"
#include "ui/rail/rooms.h"

#include <QAbstractButton>

namespace thetalane {

class RailButton : public QAbstractButton {
    Q_OBJECT
public:
    RailButton(const Appearance& appearance, Room room, QWidget* parent);

    Room room() const { return m_room; }
    void setCompact(bool compact);

    QSize fullSize() const;    // with its name
    QSize compactSize() const; // the icon alone
    QSize sizeHint() const override { return m_compact ? compactSize() : fullSize(); }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    int iconSide() const;

    const Appearance& m_appearance;
    Room m_room;
    bool m_compact = false;
};

} // namespace thetalane
