// The leaves that bowlers practise, and a button for each with the pins drawn.
#pragma once

#include "core/scene/bowling_scene.h"
#include "ui/appearance.h"

#include <QAbstractButton>
#include <QString>

#include <span>

namespace thetalane {

// From single pins to the washout; all ten at the end.
std::span<const PinSet> classicLeaves();
QString leafName(const PinSet& pins); // "Baby split 3-10"; "Pins 2-7" of others

class LeafButton : public QAbstractButton {
    Q_OBJECT
public:
    LeafButton(const Appearance& appearance, const PinSet& pins, QWidget* parent = nullptr);

    const PinSet& pins() const { return m_pins; }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    const Appearance& m_appearance;
    PinSet m_pins;
};

} // namespace thetalane
