// The whole lane, narrow and to scale, with a rectangle where the close-up looks; a press moves it there.
#pragma once

#include "ui/context.h"

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

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showAll();

    Context m_context;
    LaneScene& m_scene;
    LaneView& m_closeUp;
};

} // namespace thetalane
