// Zoom in, zoom out, show everything: three small buttons in a corner of the lane.
#pragma once

#include "ui/appearance.h"

#include <QAbstractButton>
#include <QWidget>

#include <array>

namespace thetalane {

class LaneView;

class ZoomButtons : public QWidget {
    Q_OBJECT
public:
    ZoomButtons(LaneView& view, const Appearance& appearance, QWidget* parent = nullptr);

    QSize sizeHint() const override;

signals:
    void resized();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void arrange();

    const Appearance& m_appearance;
    std::array<QAbstractButton*, 3> m_buttons; // in, out, fit
};

} // namespace thetalane
