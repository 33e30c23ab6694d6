#include "core/format/run_names.h"

namespace thetalane {

const char* fileName(EngineKind kind) {
    return kind == EngineKind::Event ? "event" : "stepped";
}

const char* fileName(Precision precision) {
    switch (precision) {
    case Precision::Float:
        return "float";
    case Precision::Double:
        return "double";
    case Precision::Quad:
        return "quad";
    }
    return "";
}

const char* fileName(EndReason reason) {
    switch (reason) {
    case EndReason::Until:
        return "until";
    case EndReason::AtRest:
        return "at rest";
    case EndReason::NoMoreCollisions:
        return "no more collisions";
    case EndReason::MaxCollisions:
        return "max collisions";
    }
    return "";
}

const char* fileName(Place place) {
    switch (place) {
    case Place::Play:
        return "play";
    case Place::Gutter:
        return "gutter";
    case Place::Pit:
        return "pit";
    }
    return "";
}

std::string secondName(const Scene& scene, const Collision& collision) {
    if (!collision.isWall())
        return scene.bodies[std::size_t(collision.second)].id;
    static constexpr const char* names[] = {"wall:left", "wall:right", "wall:bottom", "wall:top"};
    return names[int(collision.side)];
}

} // namespace thetalane
