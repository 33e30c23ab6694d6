// The whole lane, narrow and to scale, with a rectangle where the close-up looks; a press moves it there.
// What the tools offer can be grabbed here too: foul line and rack in one picture.
#pragma once

#include "ui/lane/floor_view.h"
#include "ui/lane/tool_hand.h"

namespace thetalane {

class LaneView;

class LaneStrip : public FloorView {
    Q_OBJECT
public:
    LaneStrip(const Context& context, LaneScene& scene, LaneView& closeUp, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QRectF frameOfCloseUp() const; // [px]
    void addTool(LaneTool& tool);

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    bool viewportEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void adoptRun();
    void showAll();
    Pointer pointerAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;
    void lookThere(const QPointF& pixel);

    LaneView& m_closeUp;
    ToolHand m_hand;
    QPointF m_pressed;    // [px]
    bool m_moved = false; // what is grabbed, since the press
};

} // namespace thetalane
