// Slow motion at impact: pressed, time slows by itself where the ball meets the pins.
#pragma once

#include "ui/context.h"

#include <QAbstractButton>

namespace thetalane {

class SlowMotionButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit SlowMotionButton(const Context& context, QWidget* parent = nullptr);

    void retranslate();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    Context m_context;
};

} // namespace thetalane
