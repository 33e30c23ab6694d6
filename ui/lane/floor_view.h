// What the views of the lane have in common: the floor beneath, and painting what changed and no more.
#pragma once

#include "ui/context.h"
#include "ui/lane/camera.h"
#include "ui/lane/changes.h"
#include "ui/lane/floor_picture.h"

#include <QGraphicsView>

namespace thetalane {

class LaneScene;

class FloorView : public QGraphicsView {
    Q_OBJECT
public:
    FloorView(const Context& context, LaneScene& scene, QWidget* parent);

protected:
    // Something may look otherwise; what really does is found when the event loop comes to it.
    void touch();
    // Another language, or other colours.
    void touchFloor();
    // True where the floor is another one than before.
    bool takeFloor();
    // The view stands on whole pixels.
    void look(const Camera& camera);

    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;

    Context m_context;
    LaneScene& m_scene;

private:
    void moved();
    void showChanges();
    void paintOver(QPainter& painter);

    Scene m_floor; // what lies under the bodies
    FloorPicture m_picture;
    Changes m_changes;
    QRegion m_exposed;      // of the present painting
    bool m_touched = false; // and what it changed is yet to be found
    bool m_moved = false;   // since changes were last found
};

} // namespace thetalane
