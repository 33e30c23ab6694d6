// Floor, bodies, arrows and paths of the present run at the present time; any number of views look at it.
#pragma once

#include "ui/context.h"
#include "ui/lane/falling.h"
#include "ui/lane/turning.h"

#include <QGraphicsScene>

#include <optional>
#include <vector>

namespace thetalane {

class BodyItem;
class LastingItem;
class PathsItem;
class VelocityItem;

class LaneScene : public QGraphicsScene {
    Q_OBJECT
public:
    explicit LaneScene(const Context& context, QObject* parent = nullptr);

    const Run& run() const { return *m_run; }
    const std::vector<BodyState>& states() const { return m_states; }
    const std::vector<BodyItem*>& bodies() const { return m_bodies; }
    const LastingItem& lasting() const { return *m_lasting; }
    double metresPerSpeed() const { return m_metresPerSpeed; } // the arrows' scale [m/(m/s)]

    QRectF fitRect() const { return m_fit; }     // what to show at first [units]
    QRectF wholeRect() const { return m_whole; } // beyond it there is nothing to see [units]
    const Collision* selected() const;

    // The body at a point, or within `slack` of its edge [units].
    std::optional<int> bodyNear(const QPointF& at, double slack) const;
    void setHovered(std::optional<int> body);
    void setArrows(bool shown);      // of the velocities; a tool may draw its own
    QString bodyTip(int body) const; // mass, speed, direction as they are now

    // The first collision of a body at or after the present time, after the one that is selected; in the
    // present chapter.
    std::optional<std::size_t> nextCollisionOf(int body) const;

    // While a hand moves things the arrows keep their scale.
    void holdScale(bool held);
    // While someone predicts, the ways to come are not shown.
    void hideFuture(bool hidden);

signals:
    void rebuilt(); // another run
    void touched(); // something is about to look otherwise

private:
    void rebuild();
    void showChapter();
    void showTime(double time);
    void showSelection();
    void buildTurnings();
    QStringList motionOf(int body) const;

    Context m_context;
    std::shared_ptr<const Run> m_run;
    std::vector<BodyState> m_states; // kept from frame to frame
    std::vector<BodyItem*> m_bodies;
    PathsItem* m_paths;
    VelocityItem* m_velocities;
    LastingItem* m_lasting;
    std::vector<Turning> m_turnings;          // of the balls, in a scene with friction
    std::vector<std::optional<Fall>> m_falls; // of the pins
    std::optional<int> m_hovered;
    double m_metresPerSpeed = 0;
    bool m_scaleHeld = false;
    std::vector<Ink> m_inks; // the bodies' while nothing is selected
    bool m_arrows = true;
    QRectF m_fit;
    QRectF m_whole;
};

} // namespace thetalane
