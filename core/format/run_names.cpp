#include "core/format/run_names.h"

#include "core/scene/validation.h"

namespace thetalane {
namespace {

std::string nameOf(const Scene& scene, int second, Side side) {
    if (second >= 0)
        return scene.bodies[std::size_t(second)].id;
    static constexpr const char* names[] = {"left", "right", "bottom", "top"};
    return std::string(wallPrefix) + names[int(side)];
}

} // namespace

const char* fileName(EngineKind kind) {
    switch (kind) {
    case EngineKind::Event:
        return "event";
    case EngineKind::Stepped:
        return "stepped";
    case EngineKind::Swept:
        return "swept";
    }
    return "";
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

const char* fileName(FloorPhase phase) {
    switch (phase) {
    case FloorPhase::Rest:
        return "rest";
    case FloorPhase::Sliding:
        return "sliding";
    case FloorPhase::Rolling:
        return "rolling";
    }
    return "";
}

std::string secondName(const Scene& scene, const Collision& collision) {
    return nameOf(scene, collision.second, collision.side);
}

std::string secondName(const Scene& scene, const LastingContact& contact) {
    return nameOf(scene, contact.second, contact.side);
}

} // namespace thetalane
