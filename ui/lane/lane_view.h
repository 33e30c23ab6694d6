// The large view of the lane: zooms, pans, flies to the selected collision and draws its stage on top.
#pragma once

#include "ui/lane/floor_view.h"
#include "ui/lane/overlay_painter.h"
#include "ui/lane/step_overlay.h"
#include "ui/lane/tool_hand.h"

#include <QVariantAnimation>

#include <optional>
#include <vector>

namespace thetalane {

class LaneView : public FloorView {
    Q_OBJECT
public:
    LaneView(const Context& context, LaneScene& scene, QWidget* parent = nullptr);

    const Camera& camera() const { return m_camera; }
    QRectF visibleRect() const; // [units]
    void lookAt(const QPointF& centre);

    // What is on top of the lane now: nothing while no collision is selected.
    const std::optional<StepOverlay>& overlay() const { return m_overlay; }
    const OverlayPlaces& overlayPlaces() const { return m_places; } // of the last painting [px]

    // The view does not own it; it must live as long. The first one added is asked first.
    void addTool(LaneTool& tool);
    Camera target() const { return m_flight.state() == QVariantAnimation::Running ? m_to : m_camera; }
    void flyToRect(const QRectF& units); // and stay there
    // The camera goes down the lane with the ball and ends at the rack; a hand on the camera ends it.
    bool following() const { return m_follow; }

    // Puts a small widget into a corner; labels keep away from it.
    void addToCorner(QWidget* widget, Qt::Corner corner);
    void placeCorners();

public slots:
    void fit();
    void zoomIn();
    void zoomOut();
    void setFollowing(bool on);
    void showRack();     // of a lane: the pins alone
    void showFoulLine(); // of a lane: from the ball to where one aims

signals:
    void cameraChanged();
    void followingChanged(bool on);
    void gripped(bool on); // a gesture of a tool began, or ended

protected:
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    enum class Aim { Fit, Pair, Follow, Free }; // what the camera keeps to when the window changes its size
    struct Corner {
        QWidget* widget;
        Qt::Corner corner;
    };
    void retranslate();
    void adoptRun();
    void showSelection();
    void showStage();
    void setCamera(const Camera& camera);
    void flyTo(const Camera& camera, Aim aim);
    Camera fitCamera() const;
    Camera followCamera() const;
    Camera cameraOf(Aim aim) const;
    bool hasLane() const;
    void follow();
    double clampScale(double scale) const;
    QPointF clampCentre(const QPointF& centre) const;
    void zoomAbout(const QPointF& pixel, double factor);
    void hover(const QPoint& pixel, Qt::KeyboardModifiers modifiers);
    Pointer pointerAt(const QPointF& pixel, Qt::KeyboardModifiers modifiers) const;
    bool grab(const QMouseEvent& event);
    std::optional<int> bodyAt(const QPoint& pixel) const;
    std::vector<QRectF> cornerRects() const;

    Aim m_aim = Aim::Fit;
    QVariantAnimation m_flight;
    Camera m_camera, m_from, m_to;
    QRectF m_whole; // of the run before [units]
    std::optional<std::pair<Aim, Camera>> m_beforeSelection;
    std::optional<StepOverlay> m_overlay;
    StepOverlay m_previous;
    QVariantAnimation m_turning; // from one stage to the next
    OverlayPlaces m_places;
    std::vector<Corner> m_corners;
    ToolHand m_hand;
    bool m_follow = false;
    std::optional<QPoint> m_pressed;
    QPoint m_dragged; // the last place of the drag
    bool m_dragging = false;
    bool m_clickOpened = false; // the last click opened a collision
};

} // namespace thetalane
