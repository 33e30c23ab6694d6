#include "core/format/lesson_reader.h"

#include "core/format/members.h"
#include "core/format/nearest.h"
#include "core/format/scene_file.h"
#include "core/scene/builtin.h"

#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

using Errors = std::vector<LessonError>;
using Words = std::span<const std::string_view>;

constexpr std::string_view lessonKeys[] = {"format",      "version", "title", "summary", "scene",
                                           "restitution", "engine",  "stops", "question"};
constexpr std::string_view wordKeys[] = {"en", "ko"};
constexpr std::string_view engineKeys[] = {"kind", "step", "approaching_only", "until"};
constexpr std::string_view stopKeys[] = {"at",   "collision", "stage",       "text",
                                         "show", "scene",     "restitution", "engine"};
constexpr std::string_view questionKeys[] = {"before",   "kind", "text",  "answer", "options",  "right",
                                             "quantity", "body", "other", "after",  "tolerance"};
constexpr std::string_view engineNames[] = {"event", "stepped", "swept"};
constexpr std::string_view kindNames[] = {"choice", "number", "vector"};
constexpr std::string_view startName[] = {"start"};

std::string item(const std::string& path, std::size_t index) {
    return path + '[' + std::to_string(index) + ']';
}

class LessonReader {
public:
    Lesson read(const QJsonObject& file) {
        QJsonObject title, summary;
        std::string format;
        double version = 0;
        Members m(file, {}, lessonKeys, m_shape);
        m.string("format", format);
        m.number("version", version);
        words(m, "title", m_lesson.title, Need::Required);
        words(m, "summary", m_lesson.summary, Need::Required);
        m_lesson.settings.push_back({});
        setting(m, m_lesson.settings.back(), Need::Required);
        stops(m);
        if (const auto question = m.object("question"))
            readQuestion(*question);
        return std::move(m_lesson);
    }

    Errors takeErrors() {
        for (SceneError& e : m_shape)
            m_errors.push_back({.fault = LessonFault::Shape, .path = e.path, .scene = e});
        m_shape.clear();
        return std::move(m_errors);
    }

private:
    void say(LessonError error) { m_errors.push_back(std::move(error)); }

    void words(Members& m, const char* key, Title& out, Need need) {
        const auto value = m.value(key, need);
        if (!value)
            return;
        readWords(*value, m.pathOf(key), out);
    }

    void readWords(const QJsonValue& value, const std::string& path, Title& out) {
        if (!value.isObject()) {
            m_shape.push_back(
                {.code = SceneErrorCode::WrongType, .path = path, .expected = ExpectedType::Object});
            return;
        }
        const QJsonObject object = value.toObject();
        const auto before = m_shape.size();
        Members m(object, path, wordKeys, m_shape);
        m.string("en", out.en, Need::Optional);
        m.string("ko", out.ko, Need::Optional);
        const auto blank = [](const std::string& s) { return QString::fromStdString(s).trimmed().isEmpty(); };
        if (m_shape.size() == before && blank(out.en) && blank(out.ko))
            say({.fault = LessonFault::NoWords, .path = path});
    }

    // The index of a word among those that are known.
    std::optional<std::size_t> word(Members& m, const char* key, Words known, Need need) {
        std::string text;
        const auto before = m_shape.size();
        m.string(key, text, need);
        if (m_shape.size() != before || (text.empty() && !m.value(key, Need::Optional)))
            return std::nullopt;
        return wordOf(text, m.pathOf(key), known);
    }

    std::optional<std::size_t> wordOf(const std::string& text, const std::string& path, Words known) {
        const auto found = std::find(known.begin(), known.end(), text);
        if (found != known.end())
            return std::size_t(found - known.begin());
        say({.fault = LessonFault::UnknownWord,
             .path = path,
             .text = text,
             .other = nearest(text, known),
             .allowed = {known.begin(), known.end()}});
        return std::nullopt;
    }

    // A whole number from low to high; `unless` where it is absent or wrong.
    std::int64_t whole(Members& m, const char* key, double low, double high, std::int64_t unless, Need need) {
        const auto value = m.number(key, need);
        if (!value)
            return unless;
        if (*value != std::floor(*value))
            say({.fault = LessonFault::NotWhole, .path = m.pathOf(key), .value = *value});
        else if (!(*value >= low && *value <= high))
            say({.fault = LessonFault::OutOfRange,
                 .path = m.pathOf(key),
                 .value = *value,
                 .low = low,
                 .high = high});
        else
            return std::int64_t(*value);
        return unless;
    }

    void setting(Members& m, LessonSetting& out, Need need) {
        if (const auto scene = m.value("scene", need))
            readSceneOf(*scene, m.pathOf("scene"), out);
        if (const auto e = m.number("restitution", Need::Optional)) {
            if (!(*e >= 0 && *e <= 1))
                say({.fault = LessonFault::OutOfRange,
                     .path = m.pathOf("restitution"),
                     .value = *e,
                     .low = 0,
                     .high = 1});
            if (out.scene.restitution != *e)
                out.sceneId.clear();
            out.scene.restitution = *e;
        }
        if (const auto engine = m.object("engine"))
            readEngine(*engine, m.pathOf("engine"), out.engine);
    }

    void readSceneOf(const QJsonValue& value, const std::string& path, LessonSetting& out) {
        if (value.isString()) {
            std::vector<std::string_view> ids;
            for (const BuiltinScene& s : builtinScenes())
                ids.push_back(s.id);
            const std::string id = value.toString().toStdString();
            if (const auto known = wordOf(id, path, ids)) {
                out.scene = builtinScenes()[*known].make();
                out.sceneId = id;
            }
            return;
        }
        if (!value.isObject()) {
            m_shape.push_back(
                {.code = SceneErrorCode::WrongType, .path = path, .expected = ExpectedType::Object});
            return;
        }
        QJsonObject object = value.toObject();
        if (!object.contains("format"))
            object["format"] = "thetalane-scene";
        if (!object.contains("version"))
            object["version"] = 1;
        auto read = readScene(QJsonDocument(object).toJson());
        if (auto* scene = std::get_if<Scene>(&read)) {
            out.scene = std::move(*scene);
            out.sceneId.clear();
            return;
        }
        for (SceneError& e : std::get<std::vector<SceneError>>(read)) {
            e.path = e.path.empty() ? path : path + '.' + e.path;
            m_shape.push_back(std::move(e));
        }
    }

    void readEngine(const QJsonObject& object, const std::string& path, EngineSettings& out) {
        out = {};
        Members m(object, path, engineKeys, m_shape);
        if (const auto kind = word(m, "kind", engineNames, Need::Required))
            out.kind = EngineKind(*kind);
        m.number("step", out.step, Need::Optional);
        m.number("until", out.until, Need::Optional);
        if (const auto only = m.value("approaching_only", Need::Optional)) {
            if (only->isBool())
                out.approachingOnly = only->toBool();
            else
                say({.fault = LessonFault::UnknownWord,
                     .path = m.pathOf("approaching_only"),
                     .text = only->toString().toStdString(),
                     .allowed = {"true", "false"}});
        }
    }

    void stops(Members& lesson) {
        const auto array = lesson.array("stops", Need::Required);
        if (!array)
            return;
        if (array->isEmpty())
            say({.fault = LessonFault::NoStops, .path = "stops"});
        for (qsizetype k = 0; k < array->size() && m_shape.size() < enoughErrors; ++k) {
            const std::string path = item("stops", std::size_t(k));
            m_lesson.stops.emplace_back().setting = m_lesson.settings.size() - 1;
            if (array->at(k).isObject())
                readStop(array->at(k).toObject(), path, m_lesson.stops.back());
            else
                m_shape.push_back({.code = SceneErrorCode::NotAnObject, .path = path});
        }
    }

    void readStop(const QJsonObject& object, const std::string& path, LessonStop& stop) {
        Members m(object, path, stopKeys, m_shape);
        if (object.contains("scene") || object.contains("restitution") || object.contains("engine")) {
            m_lesson.settings.push_back(m_lesson.settings.back());
            setting(m, m_lesson.settings.back(), Need::Optional);
            stop.setting = m_lesson.settings.size() - 1;
        }
        words(m, "text", stop.text, Need::Required);
        if (const auto show = word(m, "show", showNames, Need::Optional))
            stop.show = LessonShow(*show);
        const auto at = m.value("at", Need::Optional);
        const auto collision = m.value("collision", Need::Optional);
        if (at.has_value() == collision.has_value())
            return say({.fault = LessonFault::NoPlace, .path = path});
        if (collision) {
            stop.at = StopAt::Collision;
            stop.collision = whole(m, "collision", 1, 1e9, 1, Need::Required);
        }
        stop.stage = int(whole(m, "stage", 0, 5, 0, Need::Optional));
        if (at)
            readTime(*at, m.pathOf("at"), stop);
    }

    void readTime(const QJsonValue& at, const std::string& path, LessonStop& stop) {
        if (!at.isDouble()) {
            wordOf(at.isString() ? at.toString().toStdString() : std::string(), path, startName);
            return;
        }
        stop.at = StopAt::Time;
        stop.time = at.toDouble();
        if (stop.time < 0)
            say({.fault = LessonFault::OutOfRange,
                 .path = path,
                 .value = stop.time,
                 .low = 0,
                 .high = m_lesson.settings[stop.setting].engine.until});
    }

    void readQuestion(const QJsonObject& object) {
        LessonQuestion q;
        Members m(object, "question", questionKeys, m_shape);
        const auto count = m_lesson.stops.size();
        q.before =
            std::size_t(whole(m, "before", 1, double(count), std::int64_t(count) + 1, Need::Optional) - 1);
        if (count > 0)
            q.setting = m_lesson.stops[std::min(q.before, count - 1)].setting;
        words(m, "text", q.text, Need::Required);
        words(m, "answer", q.answer, Need::Optional);
        const auto kind = word(m, "kind", kindNames, Need::Required);
        if (kind) {
            q.kind = QuestionKind(*kind);
            if (q.kind == QuestionKind::Choice)
                readOptions(m, q);
            else
                readQuantity(m, q);
        }
        m_lesson.question = std::move(q);
    }

    void readOptions(Members& m, LessonQuestion& q) {
        const auto array = m.array("options", Need::Required);
        if (!array)
            return;
        for (qsizetype k = 0; k < array->size(); ++k)
            readWords(array->at(k), item("question.options", std::size_t(k)), q.options.emplace_back());
        if (q.options.size() < 2)
            return say({.fault = LessonFault::TooFewOptions,
                        .path = "question.options",
                        .value = double(q.options.size())});
        q.right = std::size_t(whole(m, "right", 1, double(q.options.size()), 1, Need::Required) - 1);
    }

    // A number is asked for as one, an arrow as one.
    void readQuantity(Members& m, LessonQuestion& q) {
        const auto kind = word(m, "quantity", quantityNames, Need::Required);
        if (!kind)
            return;
        q.quantity.kind = QuantityKind(*kind);
        if (isVector(q.quantity.kind) != (q.kind == QuestionKind::Vector)) {
            std::vector<std::string> fitting;
            for (int k = 0; k < quantityKinds; ++k)
                if (isVector(QuantityKind(k)) == (q.kind == QuestionKind::Vector))
                    fitting.emplace_back(quantityNames[std::size_t(k)]);
            say({.fault = LessonFault::UnknownWord,
                 .path = m.pathOf("quantity"),
                 .text = std::string(quantityNames[*kind]),
                 .allowed = std::move(fitting)});
        }
        q.quantity.collision = whole(m, "after", 1, 1e9, 0, Need::Optional);
        if (needsBody(q.quantity.kind))
            q.quantity.body = body(m, "body", q);
        if (needsOther(q.quantity.kind))
            q.quantity.other = body(m, "other", q);
        if (const auto t = m.number("tolerance", Need::Optional)) {
            if (!(*t > 0 && *t <= 1))
                say({.fault = LessonFault::OutOfRange,
                     .path = m.pathOf("tolerance"),
                     .value = *t,
                     .low = 0,
                     .high = 1});
            q.tolerance = *t;
        }
    }

    int body(Members& m, const char* key, const LessonQuestion& q) {
        std::string id;
        const auto before = m_shape.size();
        m.string(key, id);
        const auto& bodies = m_lesson.settings[q.setting].scene.bodies;
        if (m_shape.size() != before || bodies.empty())
            return 0;
        for (std::size_t k = 0; k < bodies.size(); ++k)
            if (bodies[k].id == id)
                return int(k);
        std::vector<std::string> ids;
        for (const Body& b : bodies)
            ids.push_back(b.id);
        say({.fault = LessonFault::UnknownBody, .path = m.pathOf(key), .text = id, .allowed = ids});
        return 0;
    }

    Lesson m_lesson;
    std::vector<SceneError> m_shape;
    Errors m_errors;
};

} // namespace

Lesson readLessonMembers(const QJsonObject& file, std::vector<LessonError>& errors) {
    LessonReader reader;
    Lesson lesson = reader.read(file);
    for (LessonError& e : reader.takeErrors())
        errors.push_back(std::move(e));
    return lesson;
}

} // namespace thetalane
