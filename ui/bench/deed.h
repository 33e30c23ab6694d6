// What an edit did, as a value: so that it can be said in the language of now, and edits of one kind told
// from others.
#pragma once

#include "ui/session.h"

#include <QString>

namespace thetalane {

struct Deed {
    enum class Kind {
        Scene, // more than one kind of thing
        Move,
        MoveSeveral,
        Velocity,
        Mass,
        Radius,
        BodyKind,
        Name,
        Spin,
        Inertia,
        Add,
        Remove,
        Restitution,
        Walls,
        WallRestitution,
        Title,
        BallMass, // of a throw, and what follows
        ThrowSpeed,
        ThrowDirection,
        ThrowPosition,
        ThrowSpin,
        Throw,
        Pins,
        Floor,
        Reset,
        Open,
    };

    Kind kind = Kind::Scene;
    std::string body{}; // its id, where it is about one

    friend bool operator==(const Deed&, const Deed&) = default;
};

Deed deedOf(const Subject& before, const Subject& after);

// "move A", as in "Undo: move A".
QString deedText(const Deed& deed);

} // namespace thetalane
