#include "core/format/json_keys.h"
#include "core/format/nearest.h"
#include "core/format/scene_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <unordered_set>

namespace thetalane {
namespace {

using Errors = std::vector<SceneError>;

constexpr std::string_view sceneKeys[] = {"format", "version", "title", "restitution",
                                          "bodies", "frame",   "lane"};
constexpr std::string_view titleKeys[] = {"en", "ko"};
constexpr std::string_view bodyKeys[] = {"id", "kind", "mass", "radius", "position", "velocity"};
constexpr std::string_view frameKeys[] = {"left", "right", "bottom", "top", "restitution"};
constexpr std::string_view laneKeys[] = {"left", "right", "foul_line", "end", "gutter_width", "pit_depth"};

// Nobody reads more, and a file of a million wrong keys should not take a minute.
constexpr std::size_t enoughErrors = 1000;

enum class Need { Required, Optional };

// The members of one object: takes each out as what it must be, and notes what is wrong with it.
class Members {
public:
    Members(const QJsonObject& object, std::string path, std::span<const std::string_view> known,
            Errors& errors)
        : m_object(object)
        , m_path(std::move(path))
        , m_errors(errors) {
        for (auto it = object.begin(); it != object.end() && m_errors.size() < enoughErrors; ++it) {
            const std::string key = it.key().toStdString();
            if (std::find(known.begin(), known.end(), key) != known.end())
                continue;
            m_misspelt.push_back(nearest(key, known));
            m_errors.push_back(
                {.code = SceneErrorCode::UnknownKey, .path = pathOf(key), .other = m_misspelt.back()});
        }
    }

    std::string pathOf(const std::string& key) const { return m_path.empty() ? key : m_path + '.' + key; }

    // Nothing where the key is absent; an error too, where it is required and not there misspelt.
    std::optional<QJsonValue> value(const char* key, Need need) {
        const QJsonValue v = m_object.value(QLatin1String(key));
        if (!v.isUndefined())
            return v;
        const bool told = std::find(m_misspelt.begin(), m_misspelt.end(), key) != m_misspelt.end();
        if (need == Need::Required && !told)
            m_errors.push_back({.code = SceneErrorCode::MissingKey, .path = pathOf(key)});
        return std::nullopt;
    }

    std::optional<double> number(const char* key, Need need = Need::Required) {
        const auto v = value(key, need);
        if (!v)
            return std::nullopt;
        if (v->isDouble())
            return v->toDouble();
        wrongType(pathOf(key), ExpectedType::Number);
        return std::nullopt;
    }

    void number(const char* key, double& out, Need need = Need::Required) {
        out = number(key, need).value_or(out);
    }

    void string(const char* key, std::string& out, Need need = Need::Required) {
        const auto v = value(key, need);
        if (v && v->isString())
            out = v->toString().toStdString();
        else if (v)
            wrongType(pathOf(key), ExpectedType::String);
    }

    void pair(const char* key, Vec2d& out) {
        const auto v = value(key, Need::Required);
        if (!v)
            return;
        const QJsonArray array = v->toArray();
        if (!v->isArray() || array.size() != 2)
            return wrongType(pathOf(key), ExpectedType::Pair);
        double* const parts[] = {&out.x, &out.y};
        for (int i = 0; i < 2; ++i) {
            if (array[i].isDouble())
                *parts[i] = array[i].toDouble();
            else
                wrongType(pathOf(key) + '[' + std::to_string(i) + ']', ExpectedType::Number);
        }
    }

    void kind(const char* key, BodyKind& out) {
        const auto v = value(key, Need::Required);
        if (!v)
            return;
        if (v->toString() == "ball" || v->toString() == "pin")
            out = v->toString() == "ball" ? BodyKind::Ball : BodyKind::Pin;
        else
            wrongType(pathOf(key), ExpectedType::BodyKind);
    }

    std::optional<QJsonObject> object(const char* key) {
        const auto v = value(key, Need::Optional);
        if (v && v->isObject())
            return v->toObject();
        if (v)
            wrongType(pathOf(key), ExpectedType::Object);
        return std::nullopt;
    }

    void wrongType(std::string path, ExpectedType expected) {
        m_errors.push_back(
            {.code = SceneErrorCode::WrongType, .path = std::move(path), .expected = expected});
    }

private:
    const QJsonObject& m_object;
    std::string m_path;
    Errors& m_errors;
    std::vector<std::string> m_misspelt; // what the unknown keys were probably meant to be
};

Body readBody(const QJsonObject& object, const std::string& path, Errors& errors) {
    Body body;
    Members m(object, path, bodyKeys, errors);
    m.string("id", body.id);
    m.kind("kind", body.kind);
    m.number("mass", body.mass);
    m.number("radius", body.radius);
    m.pair("position", body.position);
    m.pair("velocity", body.velocity);
    return body;
}

void readBodies(Members& scene, std::vector<Body>& bodies, Errors& errors) {
    const auto value = scene.value("bodies", Need::Required);
    if (!value)
        return;
    if (!value->isArray())
        return scene.wrongType("bodies", ExpectedType::Array);
    const QJsonArray array = value->toArray();
    if (array.size() > qsizetype(maxBodies)) {
        errors.push_back({.code = SceneErrorCode::TooManyBodies,
                          .path = "bodies",
                          .value = double(array.size()),
                          .high = double(maxBodies)});
        return;
    }
    bodies.reserve(std::size_t(array.size()));
    for (qsizetype i = 0; i < array.size() && errors.size() < enoughErrors; ++i) {
        const std::string path = "bodies[" + std::to_string(i) + ']';
        const QJsonValue item = array[i];
        if (!item.isObject())
            errors.push_back({.code = SceneErrorCode::NotAnObject, .path = path});
        bodies.push_back(item.isObject() ? readBody(item.toObject(), path, errors) : Body{});
    }
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
    out = lane;
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
    return scene;
}

// bodies[1].mass -> bodies[1] -> bodies -> nothing
std::string parentOf(const std::string& path) {
    const auto cut = path.find_last_of(".[");
    return cut == std::string::npos ? std::string() : path.substr(0, cut);
}

// A fault stands where its key stands; one of a key that is missing, where the object begins that lacks it.
void sortByPlace(Errors& errors, const QByteArray& json) {
    std::unordered_set<std::string> wanted;
    for (const SceneError& e : errors)
        for (std::string p = e.path; !p.empty() && wanted.insert(p).second;)
            p = parentOf(p);
    const auto offsets = keyOffsets(json, wanted);
    const auto offsetOf = [&](std::string path) {
        for (; !path.empty(); path = parentOf(path))
            if (const auto it = offsets.find(path); it != offsets.end())
                return it->second;
        return qsizetype(0);
    };
    std::vector<std::pair<qsizetype, SceneError>> placed;
    placed.reserve(errors.size());
    for (SceneError& e : errors)
        placed.emplace_back(offsetOf(e.path), std::move(e));
    std::stable_sort(placed.begin(), placed.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = std::move(placed[i].second);
}

// Faults of single values; where bodies stand to each other means nothing while some value is missing.
void addValueErrors(const Scene& scene, Errors& errors) {
    std::unordered_set<std::string> told;
    for (const SceneError& e : errors)
        told.insert(e.path);
    for (SceneError& e : validate(scene)) {
        const bool ofValue = e.code == SceneErrorCode::NotPositive || e.code == SceneErrorCode::OutOfRange ||
                             e.code == SceneErrorCode::EmptyId || e.code == SceneErrorCode::DuplicateId;
        if (ofValue && !told.contains(e.path) && !told.contains(parentOf(e.path)))
            errors.push_back(std::move(e));
    }
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
