// A ball or a pin from above.
#pragma once

#include "core/scene/scene.h"
#include "ui/appearance.h"
#include "ui/lane/turning.h"

#include <QGraphicsItem>

#include <optional>

namespace thetalane {

class BodyItem : public QGraphicsItem {
public:
    enum class Role {
        Usual,
        First,    // of the selected collision
        Second,   // of the selected collision
        Beside,   // resolved together with the selected collision
        Receding, // another collision is selected
    };

    // `ink`: the colour of the body while no collision is selected.
    BodyItem(const Body& body, Ink ink, bool nameBeside, const Appearance& appearance);

    void setRole(Role role);
    void setHovered(bool hovered);
    void setLost(bool lost); // in a gutter or the pit: dimmed
    // Of a pin that goes down: how far, 0 to 1, and which way.
    void setTipped(std::optional<double> share, const Vec2d& along);
    const std::optional<double>& tipped() const { return m_tipped; }
    // A ball that has been given one shows it: two halves, and finger holes.
    void setTurn(const std::optional<Orientation>& turn);
    const std::optional<Orientation>& turn() const { return m_turn; }
    Role role() const { return m_role; }
    bool hovered() const { return m_hovered; }

    QRectF boundingRect() const override;
    void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

private:
    bool chosen() const { return m_role == Role::First || m_role == Role::Second; }
    Ink ownInk() const { return m_role == Role::Beside ? Ink::Plain : m_ink; }
    QColor fill() const;
    QColor edge() const;
    void paintBall(QPainter& painter, const QPointF& at, double radius) const;
    void paintTurn(QPainter& painter, const QPointF& at, double radius) const;
    void paintPin(QPainter& painter, const QPointF& at, double radius) const;
    void paintLying(QPainter& painter, const QPointF& at, double perMetre) const;
    void placeInDepth();
    void takeName(const QString& name);
    void paintName(QPainter& painter, const QPointF& at, double radius) const;

    const Appearance& m_appearance;
    BodyKind m_kind;
    double m_radius; // [units]
    QString m_name;
    double m_nameWidth = 0; // at a size of 1
    Ink m_ink;
    bool m_nameBeside; // where the disc is too small for its name
    Role m_role = Role::Usual;
    bool m_hovered = false;
    bool m_lost = false;
    std::optional<Orientation> m_turn;
    std::optional<double> m_tipped;
    Vec2d m_along;    // unit, where it is tipped
    std::string m_id; // of a name that is a word, and so another one in another language
};

} // namespace thetalane
