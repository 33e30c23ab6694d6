// The whole lane, narrow and to scale, with a rectangle where the close-up looks; a press moves it there.
// What the tools offer can be grabbed here too: foul line and rack in one picture.
#pragma once

#include "ui/context.h"
#include "ui/lane/tool_hand.h"

#include <QGraphicsView>

namespace thetalane {

class LaneScene;
class LaneView;

class LaneStrip : public QGraphicsView {
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

    Context m_context;
    LaneScene& m_scene;
    LaneView& m_closeUp;
    ToolHand m_hand;
    QPointF m_pressed;    // [px]
    bool m_moved = false; // what is grabbed, since the press
    Scene m_floor;        // what the cached background shows
};

} // namespace thetalane
