// The ten pins from above, as the bowler sees them: which stand. With choosable() a click, or the digits 1 to
// 9 and 0, turn a pin over.
#pragma once

#include "core/scene/bowling_scene.h"
#include "ui/appearance.h"

#include <QWidget>

namespace thetalane {

class FrameDeck : public QWidget {
    Q_OBJECT
public:
    explicit FrameDeck(const Appearance& appearance, QWidget* parent = nullptr);

    // `present`: those that take part; `standing`: of them. The others are seen as dots.
    void setPins(const PinSet& present, const PinSet& standing);
    void setChoosable(bool on);
    const PinSet& standing() const { return m_standing; }
    void setTitle(const QString& title); // for screen readers, before the pins

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void chosen(int pin); // 0 to 9; whoever owns the deck decides what that means

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    QPointF centre(int pin) const;
    double radius() const;
    void describe();

    const Appearance& m_appearance;
    PinSet m_present = allPins;
    PinSet m_standing = allPins;
    QString m_title;
    bool m_choosable = false;
};

} // namespace thetalane
