#include "core/format/json_keys.h"
#include "core/format/json_strict.h"
#include "core/format/members.h"
#include "core/format/scene_file.h"

#include <QJsonDocument>

#include <algorithm>
#include <unordered_set>

namespace thetalane {
namespace {

using Errors = std::vector<SceneError>;

constexpr std::string_view sceneKeys[] = {"format", "version", "title", "restitution",
                                          "bodies", "frame",   "lane",  "friction"};
constexpr std::string_view titleKeys[] = {"en", "ko"};
constexpr std::string_view bodyKeys[] = {"id",       "kind",     "mass", "radius",
                                         "position", "velocity", "spin", "inertia"};
constexpr std::string_view frameKeys[] = {"left", "right", "bottom", "top", "restitution"};
constexpr std::string_view laneKeys[] = {"left",         "right",     "foul_line", "end",
                                         "gutter_width", "pit_depth", "kickbacks"};
constexpr std::string_view kickbacksKeys[] = {"from", "restitution"};
constexpr std::string_view frictionKeys[] = {"ball", "rolling", "pin", "gravity", "oil"};
constexpr std::string_view oilKeys[] = {"from", "to", "friction"};

Body readBody(const QJsonObject& object, const std::string& path, Errors& errors) {
    Body body;
    Members m(object, path, bodyKeys, errors);
    m.string("id", body.id);
    m.kind("kind", body.kind);
    m.number("mass", body.mass);
    m.number("radius", body.radius);
    m.pair("position", body.position);
    m.pair("velocity", body.velocity);
    m.triple("spin", body.spin, Need::Optional);
    m.number("inertia", body.inertia, Need::Optional);
    return body;
}

// One item after the other, each an object.
template <class Item, class Read>
void readItems(const QJsonArray& array, const std::string& path, std::vector<Item>& out, Errors& errors,
               Read&& read) {
    out.reserve(std::size_t(array.size()));
    for (qsizetype i = 0; i < array.size() && errors.size() < enoughErrors; ++i) {
        const std::string place = path + '[' + std::to_string(i) + ']';
        const QJsonValue item = array[i];
        if (!item.isObject())
            errors.push_back({.code = SceneErrorCode::NotAnObject, .path = place});
        out.push_back(item.isObject() ? read(item.toObject(), place, errors) : Item{});
    }
}

void readBodies(Members& scene, std::vector<Body>& bodies, Errors& errors) {
    const auto array = scene.array("bodies", Need::Required);
    if (!array)
        return;
    if (array->size() > qsizetype(maxBodies)) {
        errors.push_back({.code = SceneErrorCode::TooManyBodies,
                          .path = "bodies",
                          .value = double(array->size()),
                          .high = double(maxBodies)});
        return;
    }
    readItems(*array, "bodies", bodies, errors, readBody);
}

void readFrame(Members& scene, std::optional<Frame>& out, Errors& errors) {
    const auto object = scene.object("frame");
    if (!object)
        return;
    Frame frame;
    Members m(*object, "frame", frameKeys, errors);
    frame.left = m.number("left", Need::Optional);
    frame.right = m.number("right", Need::Optional);
    frame.bottom = m.number("bottom", Need::Optional);
    frame.top = m.number("top", Need::Optional);
    m.number("restitution", frame.restitution, Need::Optional);
    out = frame;
}

void readKickbacks(Members& lane, std::optional<Kickbacks>& out, Errors& errors) {
    const auto object = lane.object("kickbacks");
    if (!object)
        return;
    Kickbacks kickbacks;
    Members m(*object, "lane.kickbacks", kickbacksKeys, errors);
    m.number("from", kickbacks.from);
    m.number("restitution", kickbacks.restitution);
    out = kickbacks;
}

void readLane(Members& scene, std::optional<Lane>& out, Errors& errors) {
    const auto object = scene.object("lane");
    if (!object)
        return;
    Lane lane;
    Members m(*object, "lane", laneKeys, errors);
    m.number("left", lane.left);
    m.number("right", lane.right);
    m.number("foul_line", lane.foulLine);
    m.number("end", lane.end);
    m.number("gutter_width", lane.gutterWidth);
    m.number("pit_depth", lane.pitDepth);
    readKickbacks(m, lane.kickbacks, errors);
    out = lane;
}

OilZone readOil(const QJsonObject& object, const std::string& path, Errors& errors) {
    OilZone zone;
    Members m(object, path, oilKeys, errors);
    m.number("from", zone.from);
    m.number("to", zone.to);
    m.number("friction", zone.friction);
    return zone;
}

void readFriction(Members& scene, std::optional<Friction>& out, Errors& errors) {
    const auto object = scene.object("friction");
    if (!object)
        return;
    Friction friction;
    Members m(*object, "friction", frictionKeys, errors);
    m.number("ball", friction.ball);
    m.number("rolling", friction.rolling, Need::Optional);
    m.number("pin", friction.pin, Need::Optional);
    m.number("gravity", friction.gravity, Need::Optional);
    if (const auto oil = m.array("oil", Need::Optional))
        readItems(*oil, "friction.oil", friction.oil, errors, readOil);
    out = std::move(friction);
}

void readTitle(Members& scene, Title& out, Errors& errors) {
    const auto object = scene.object("title");
    if (!object)
        return;
    Members m(*object, "title", titleKeys, errors);
    m.string("en", out.en, Need::Optional);
    m.string("ko", out.ko, Need::Optional);
}

// A file of another kind, or of a later version: whatever else it holds, these rules do not apply to it.
std::optional<SceneError> notForUs(const QJsonObject& file) {
    const QJsonValue format = file.value("format");
    if (format.isString() && format.toString() != "thetalane-scene")
        return SceneError{
            .code = SceneErrorCode::WrongFormat, .path = "format", .other = format.toString().toStdString()};
    const QJsonValue version = file.value("version");
    if (version.isDouble() && version.toDouble() != 1)
        return SceneError{
            .code = SceneErrorCode::WrongVersion, .path = "version", .value = version.toDouble()};
    return std::nullopt;
}

Scene readMembers(const QJsonObject& file, Errors& errors) {
    Scene scene;
    std::string format;
    double version = 0;
    Members m(file, {}, sceneKeys, errors);
    m.string("format", format);
    m.number("version", version);
    readTitle(m, scene.title, errors);
    m.number("restitution", scene.restitution);
    readBodies(m, scene.bodies, errors);
    readFrame(m, scene.frame, errors);
    readLane(m, scene.lane, errors);
    readFriction(m, scene.friction, errors);
    return scene;
}

bool isOfOneValue(SceneErrorCode code) {
    using enum SceneErrorCode;
    return code == NotPositive || code == OutOfRange || code == OutOfOpenRange || code == EmptyId ||
           code == DuplicateId || code == ReservedId;
}

// Faults of single values; what they are to each other means nothing while some value is missing.
void addValueErrors(const Scene& scene, Errors& errors) {
    std::unordered_set<std::string> told;
    for (const SceneError& e : errors)
        told.insert(e.path);
    for (SceneError& e : validate(scene))
        if (isOfOneValue(e.code) && !told.contains(e.path) && !told.contains(parentPath(e.path)))
            errors.push_back(std::move(e));
}

bool partOfNumber(char c) {
    return std::string_view("+-.0123456789eE").find(c) != std::string_view::npos;
}

// Qt's reader tells where it stopped, which for some faults is past what it stopped at, and calls an object
// with a comma lost unterminated.
SceneError notJson(const QByteArray& json, const QJsonParseError& error) {
    if (json.trimmed().isEmpty())
        return {.code = SceneErrorCode::NotJson, .path = placeInText(json, 0), .other = emptyFileReason};
    qsizetype at = std::clamp<qsizetype>(error.offset, 0, json.size());
    std::string reason = error.errorString().toStdString();
    const bool separator = error.error == QJsonParseError::UnterminatedObject ||
                           error.error == QJsonParseError::UnterminatedArray ||
                           error.error == QJsonParseError::MissingValueSeparator;
    if (separator && at < json.size())
        reason = missingCommaReason;
    if ((separator || error.error == QJsonParseError::MissingNameSeparator) && at > 0 && at < json.size())
        --at;
    if (error.error == QJsonParseError::IllegalNumber)
        while (at > 0 && partOfNumber(json[at - 1]))
            --at;
    return {.code = SceneErrorCode::NotJson, .path = placeInText(json, at), .other = std::move(reason)};
}

} // namespace

std::string placeInText(const QByteArray& text, qsizetype offset) {
    const QByteArray before = text.left(std::clamp<qsizetype>(offset, 0, text.size()));
    const qsizetype lineStart = before.lastIndexOf('\n') + 1;
    const auto isCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    const auto column = std::count_if(before.begin() + lineStart, before.end(), isCharacter) + 1;
    return "line " + std::to_string(before.count('\n') + 1) + ", column " + std::to_string(column);
}

std::variant<Scene, std::vector<SceneError>> readScene(const QByteArray& json) {
    QJsonParseError parseError;
    const QJsonDocument document = QJsonDocument::fromJson(json, &parseError);
    if (parseError.error != QJsonParseError::NoError)
        return Errors{notJson(json, parseError)};
    if (const auto lax = firstLaxness(json))
        return Errors{
            {.code = SceneErrorCode::NotJson, .path = placeInText(json, lax->offset), .other = lax->reason}};
    if (!document.isObject())
        return Errors{{.code = SceneErrorCode::NotAnObject, .path = {}}};
    const QJsonObject file = document.object();
    if (auto error = notForUs(file))
        return Errors{std::move(*error)};

    Errors errors;
    for (std::string& path : duplicateKeys(json))
        errors.push_back(
            {.code = SceneErrorCode::NotJson, .path = std::move(path), .other = duplicateKeyReason});
    Scene scene = readMembers(file, errors);
    if (!errors.empty())
        addValueErrors(scene, errors);
    else
        errors = validate(scene);
    if (errors.empty())
        return scene;
    sortByPlace(errors, json);
    return errors;
}

} // namespace thetalane
