// The lane as the window embeds it: one large view, and for a bowling lane the whole lane beside it.
#pragma once

#include "ui/context.h"

#include <QWidget>

#include <vector>

namespace thetalane {

class LaneScene;
class LaneStrip;
class LaneTool;
class LaneView;
class PinBadge;
class ZoomButtons;

class LanePanel : public QWidget {
    Q_OBJECT
public:
    explicit LanePanel(const Context& context, QWidget* parent = nullptr);

    LaneScene& scene() { return *m_scene; }
    LaneView& view() { return *m_view; }
    LaneStrip& strip() { return *m_strip; } // hidden unless the scene is a lane
    PinBadge& badge() { return *m_badge; }

    // What can be grabbed in the large view and on the strip. Not owned; it must live as long.
    void addTool(LaneTool& tool);
    // As the user left them: whether the camera follows the ball.
    void restoreChoices();

    QSize sizeHint() const override { return {960, 640}; }
    QSize minimumSizeHint() const override { return {320, 240}; }

public slots:
    void fit();
    void zoomIn();
    void zoomOut();

private:
    void adoptRun();
    void showArrows();

    LaneScene* m_scene;
    LaneView* m_view;
    LaneStrip* m_strip;
    PinBadge* m_badge;
    ZoomButtons* m_buttons = nullptr;
    std::vector<LaneTool*> m_tools;
};

} // namespace thetalane
