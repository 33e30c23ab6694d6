// The lane as the window embeds it: one large view, and for a bowling lane the whole lane beside it.
#pragma once

#include "ui/context.h"

#include <QWidget>

namespace thetalane {

class LaneScene;
class LaneStrip;
class LaneView;
class PinBadge;

class LanePanel : public QWidget {
    Q_OBJECT
public:
    explicit LanePanel(const Context& context, QWidget* parent = nullptr);

    // Nothing flies or turns: what is asked for stands there at once.
    void setReducedMotion(bool reduced);

    LaneScene& scene() { return *m_scene; }
    LaneView& view() { return *m_view; }
    LaneStrip& strip() { return *m_strip; } // hidden unless the scene is a lane
    PinBadge& badge() { return *m_badge; }

    QSize sizeHint() const override { return {960, 640}; }
    QSize minimumSizeHint() const override { return {320, 240}; }

public slots:
    void fit();
    void zoomIn();
    void zoomOut();

private:
    void adoptRun();

    LaneScene* m_scene;
    LaneView* m_view;
    LaneStrip* m_strip;
    PinBadge* m_badge;
};

} // namespace thetalane
