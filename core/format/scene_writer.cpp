#include "core/format/json_text.h"
#include "core/format/scene_file.h"

#include <QList>

namespace thetalane {
namespace {

QByteArray member(const char* key, const QByteArray& value) {
    return '"' + QByteArray(key) + "\": " + value;
}

QByteArray object(const QList<QByteArray>& members) {
    return '{' + members.join(", ") + '}';
}

QByteArray titleText(const Title& title) {
    QList<QByteArray> members;
    if (!title.en.empty())
        members << member("en", jsonString(title.en));
    if (!title.ko.empty())
        members << member("ko", jsonString(title.ko));
    return object(members);
}

QByteArray bodyText(const Body& body) {
    QList<QByteArray> members{member("id", jsonString(body.id)),
                              member("kind", body.kind == BodyKind::Ball ? "\"ball\"" : "\"pin\""),
                              member("mass", jsonNumber(body.mass)),
                              member("radius", jsonNumber(body.radius)),
                              member("position", jsonPair(body.position)),
                              member("velocity", jsonPair(body.velocity))};
    if (body.spin != Spin<double>{})
        members << member("spin", jsonTriple(body.spin));
    if (body.inertia != Body{}.inertia)
        members << member("inertia", jsonNumber(body.inertia));
    return object(members);
}

QByteArray bodiesText(const std::vector<Body>& bodies) {
    QList<QByteArray> lines;
    lines.reserve(qsizetype(bodies.size()));
    for (const Body& body : bodies)
        lines << "    " + bodyText(body);
    return "[\n" + lines.join(",\n") + "\n  ]";
}

QByteArray frameText(const Frame& frame) {
    static constexpr const char* names[] = {"left", "right", "bottom", "top"};
    QList<QByteArray> members;
    for (const Side side : sides)
        if (const auto& position = frame.side(side))
            members << member(names[int(side)], jsonNumber(*position));
    return object(members << member("restitution", jsonNumber(frame.restitution)));
}

QByteArray laneText(const Lane& lane) {
    QList<QByteArray> members{member("left", jsonNumber(lane.left)),
                              member("right", jsonNumber(lane.right)),
                              member("foul_line", jsonNumber(lane.foulLine)),
                              member("end", jsonNumber(lane.end)),
                              member("gutter_width", jsonNumber(lane.gutterWidth)),
                              member("pit_depth", jsonNumber(lane.pitDepth))};
    if (lane.kickbacks)
        members << member("kickbacks",
                          object({member("from", jsonNumber(lane.kickbacks->from)),
                                  member("restitution", jsonNumber(lane.kickbacks->restitution))}));
    return object(members);
}

// The zones of a pattern one a line, as they lie on the lane.
QByteArray oilText(const std::vector<OilZone>& oil) {
    QList<QByteArray> lines;
    for (const OilZone& zone : oil)
        lines << "    " + object({member("from", jsonNumber(zone.from)), member("to", jsonNumber(zone.to)),
                                  member("friction", jsonNumber(zone.friction))});
    return "[\n" + lines.join(",\n") + "\n  ]";
}

QByteArray frictionText(const Friction& friction) {
    const Friction usual;
    QList<QByteArray> members{member("ball", jsonNumber(friction.ball))};
    if (friction.rolling != usual.rolling)
        members << member("rolling", jsonNumber(friction.rolling));
    if (friction.pin != usual.pin)
        members << member("pin", jsonNumber(friction.pin));
    if (friction.gravity != usual.gravity)
        members << member("gravity", jsonNumber(friction.gravity));
    if (!friction.oil.empty())
        members << member("oil", oilText(friction.oil));
    return object(members);
}

} // namespace

QByteArray writeScene(const Scene& scene) {
    QList<QByteArray> lines{member("format", "\"thetalane-scene\"") + ", " + member("version", "1")};
    if (scene.title != Title{})
        lines << member("title", titleText(scene.title));
    lines << member("restitution", jsonNumber(scene.restitution));
    lines << member("bodies", bodiesText(scene.bodies));
    if (scene.frame)
        lines << member("frame", frameText(*scene.frame));
    if (scene.lane)
        lines << member("lane", laneText(*scene.lane));
    if (scene.friction)
        lines << member("friction", frictionText(*scene.friction));
    return "{\n  " + lines.join(",\n  ") + "\n}\n";
}

} // namespace thetalane
