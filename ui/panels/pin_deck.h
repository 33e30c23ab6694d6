// The pin deck as on an alley's display: ten places seen from the bowler, the head pin nearest. Painted small
// or large, and a widget to pick on by mouse and keyboard.
#pragma once

#include "core/scene/bowling_scene.h"

#include <QRectF>
#include <QString>
#include <QWidget>

class QPainter;

namespace thetalane {

class Appearance;

// A standing pin is a white disc with its number where there is room for legible type, one that is down a
// small grey spot. Fitted into `where`, in the middle.
void paintPinDeck(QPainter& painter, const QRectF& where, const PinSet& standing,
                  const Appearance& appearance);

// Where pin k + 1 is painted, and how large.
QPointF deckPinCentre(const QRectF& where, int k);
double deckPinRadius(const QRectF& where);

// "7-10", as bowlers write a leave; "—" where none stands.
QString pinsText(const PinSet& pins);

class PinDeck : public QWidget {
    Q_OBJECT
public:
    explicit PinDeck(const Appearance& appearance, QWidget* parent = nullptr);

    const PinSet& standing() const { return m_standing; }
    void setStanding(const PinSet& standing);
    // Those that take part, all unless said; the others are spots that cannot be picked.
    void setPresent(const PinSet& present);
    void setTitle(const QString& title); // for screen readers; "Standing pins" unless said

    // Then a click turns a pin over; so do its number (0 is pin 10), or the arrow keys to it and space.
    void setPickable(bool on);
    bool isPickable() const { return m_pickable; }
    int current() const { return m_current; } // the pin that space would pick, 0 to 9

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    void retranslate();

signals:
    void picked(const thetalane::PinSet& standing); // by the user alone
    void turned(int pin);                           // the same: which one, 0 to 9

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QRectF deck() const;
    int pinAt(const QPointF& point) const; // -1: none
    void toggle(int pin);
    void moveBy(int across, int down);
    void describe();

    const Appearance& m_appearance;
    PinSet m_present = allPins;
    PinSet m_standing = allPins;
    QString m_title;
    bool m_pickable = false;
    int m_current = 0;
    int m_hovered = -1;
};

} // namespace thetalane
