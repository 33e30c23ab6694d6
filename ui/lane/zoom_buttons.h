// Zoom in, zoom out, show everything; on a lane also the rack, the foul line and a camera that follows the
// ball: small buttons in a corner.
#pragma once

#include "ui/appearance.h"

#include <QAbstractButton>
#include <QWidget>

#include <vector>

namespace thetalane {

class LaneView;

class ZoomButtons : public QWidget {
    Q_OBJECT
public:
    ZoomButtons(LaneView& view, const Appearance& appearance, QWidget* parent = nullptr);

    void setLane(bool lane); // with the lane's own
    QSize sizeHint() const override;

signals:
    void resized();
    void followChosen(bool on); // by the button

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Place { Rack, FoulLine, Follow, In, Out, Fit, placeCount };

    void retranslate();
    void arrange();

    const Appearance& m_appearance;
    std::vector<QAbstractButton*> m_buttons; // by Place
    bool m_lane = false;
};

} // namespace thetalane
