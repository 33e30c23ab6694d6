#include "ui/bench/deed.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

struct DeedText {
    Q_DECLARE_TR_FUNCTIONS(Deed)
};

using Kind = Deed::Kind;

// The first id that one list has and the other has not.
std::string extra(const std::vector<Body>& more, const std::vector<Body>& fewer) {
    for (const Body& body : more)
        if (std::none_of(fewer.begin(), fewer.end(), [&](const Body& b) { return b.id == body.id; }))
            return body.id;
    return more.back().id;
}

// A mass that takes the radius with it is still a mass.
Kind changeOf(const Body& before, const Body& after) {
    Body same = before;
    same.mass = after.mass;
    if (after.mass != before.mass) {
        same.radius = after.radius;
        return same == after ? Kind::Mass : Kind::Scene;
    }
    const auto only = [&](auto Body::*member, Kind kind) {
        Body changed = before;
        changed.*member = after.*member;
        return changed == after ? kind : Kind::Scene;
    };
    for (const Kind kind :
         {only(&Body::position, Kind::Move), only(&Body::velocity, Kind::Velocity),
          only(&Body::radius, Kind::Radius), only(&Body::kind, Kind::BodyKind), only(&Body::id, Kind::Name),
          only(&Body::spin, Kind::Spin), only(&Body::inertia, Kind::Inertia)})
        if (kind != Kind::Scene)
            return kind;
    return Kind::Scene;
}

Deed bodiesDeed(const std::vector<Body>& before, const std::vector<Body>& after) {
    if (after.size() == before.size() + 1)
        return {Kind::Add, extra(after, before)};
    if (after.size() + 1 == before.size())
        return {Kind::Remove, extra(before, after)};
    if (after.size() != before.size())
        return {};
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (!(after[i] == before[i]))
            changed.push_back(i);
    if (changed.size() == 1)
        return {changeOf(before[changed[0]], after[changed[0]]), before[changed[0]].id};
    const bool moved = std::all_of(changed.begin(), changed.end(), [&](std::size_t i) {
        Body same = before[i];
        same.position = after[i].position;
        same.velocity = after[i].velocity;
        return same == after[i];
    });
    return {moved ? Kind::MoveSeveral : Kind::Scene};
}

Deed throwDeed(const Subject& before, const Subject& after) {
    const Throw& a = *before.ballThrow;
    const Throw& b = *after.ballThrow;
    const auto only = [&](auto Throw::*member, Kind kind) {
        Throw changed = a;
        changed.*member = b.*member;
        return changed == b ? kind : Kind::Throw;
    };
    if (before.standing != after.standing)
        return {Kind::Pins};
    if (a == b)
        return {before.scene.restitution != after.scene.restitution ? Kind::Restitution : Kind::Floor};
    for (const Kind kind :
         {only(&Throw::mass, Kind::BallMass), only(&Throw::speed, Kind::ThrowSpeed),
          only(&Throw::direction, Kind::ThrowDirection), only(&Throw::position, Kind::ThrowPosition),
          only(&Throw::spin, Kind::ThrowSpin), only(&Throw::axis, Kind::ThrowSpin)})
        if (kind != Kind::Throw)
            return {kind};
    return {Kind::Throw};
}

Kind frameKind(const std::optional<Frame>& before, const std::optional<Frame>& after) {
    if (!before || !after)
        return Kind::Walls;
    Frame same = *before;
    same.restitution = after->restitution;
    return same == *after ? Kind::WallRestitution : Kind::Walls;
}

QString aboutBody(Kind kind, const QString& id) {
    switch (kind) {
    case Kind::Move:
        return DeedText::tr("move %1").arg(id);
    case Kind::Velocity:
        return DeedText::tr("velocity of %1").arg(id);
    case Kind::Mass:
        return DeedText::tr("mass of %1").arg(id);
    case Kind::Radius:
        return DeedText::tr("radius of %1").arg(id);
    case Kind::BodyKind:
        return DeedText::tr("kind of %1").arg(id);
    case Kind::Name:
        return DeedText::tr("name of %1").arg(id);
    case Kind::Spin:
        return DeedText::tr("spin of %1").arg(id);
    case Kind::Inertia:
        return DeedText::tr("moment of inertia of %1").arg(id);
    case Kind::Add:
        return DeedText::tr("add %1").arg(id);
    case Kind::Remove:
        return DeedText::tr("remove %1").arg(id);
    default:
        return {};
    }
}

QString aboutThrow(Kind kind) {
    switch (kind) {
    case Kind::BallMass:
        return DeedText::tr("mass of the ball");
    case Kind::ThrowSpeed:
        return DeedText::tr("speed of the throw");
    case Kind::ThrowDirection:
        return DeedText::tr("direction of the throw");
    case Kind::ThrowPosition:
        return DeedText::tr("position of the ball");
    case Kind::ThrowSpin:
        return DeedText::tr("spin of the ball");
    case Kind::Throw:
        return DeedText::tr("change the throw");
    case Kind::Pins:
        return DeedText::tr("pins that stand");
    case Kind::Floor:
        return DeedText::tr("friction of the lane");
    default:
        return {};
    }
}

QString aboutScene(Kind kind) {
    switch (kind) {
    case Kind::MoveSeveral:
        return DeedText::tr("arrange the bodies");
    case Kind::Restitution:
        return DeedText::tr("coefficient of restitution");
    case Kind::Walls:
        return DeedText::tr("walls");
    case Kind::WallRestitution:
        return DeedText::tr("coefficient of restitution of the walls");
    case Kind::Title:
        return DeedText::tr("title of the scene");
    case Kind::Reset:
        return DeedText::tr("reset the scene");
    case Kind::Open:
        return DeedText::tr("open another scene");
    default:
        return DeedText::tr("edit the scene");
    }
}

} // namespace

Deed deedOf(const Subject& before, const Subject& after) {
    if (before.ballThrow && after.ballThrow)
        return throwDeed(before, after);
    if (before.ballThrow || after.ballThrow)
        return {after.ballThrow ? Kind::Throw : Kind::Scene};
    const Scene& a = before.scene;
    const Scene& b = after.scene;
    const bool rest = a.lane == b.lane && a.friction == b.friction;
    const bool e = a.restitution == b.restitution;
    const bool walls = a.frame == b.frame;
    const bool bodies = a.bodies == b.bodies;
    const bool title = a.title == b.title;
    if (rest && e && walls && title && !bodies)
        return bodiesDeed(a.bodies, b.bodies);
    if (rest && e && bodies && title && !walls)
        return {frameKind(a.frame, b.frame)};
    if (rest && walls && bodies && title && !e)
        return {Kind::Restitution};
    if (rest && walls && bodies && e && !title)
        return {Kind::Title};
    return {};
}

QString deedText(const Deed& deed) {
    for (const QString& text :
         {aboutBody(deed.kind, QString::fromStdString(deed.body)), aboutThrow(deed.kind)})
        if (!text.isEmpty())
            return text;
    return aboutScene(deed.kind);
}

} // namespace thetalane
