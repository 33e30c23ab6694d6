#include "core/format/members.h"

#include "core/format/nearest.h"

#include <algorithm>

namespace thetalane {

Members::Members(const QJsonObject& object, std::string path, std::span<const std::string_view> known,
                 std::vector<SceneError>& errors)
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

std::optional<QJsonValue> Members::value(const char* key, Need need) {
    const QJsonValue v = m_object.value(QLatin1String(key));
    if (!v.isUndefined())
        return v;
    const bool told = std::find(m_misspelt.begin(), m_misspelt.end(), key) != m_misspelt.end();
    if (need == Need::Required && !told)
        m_errors.push_back({.code = SceneErrorCode::MissingKey, .path = pathOf(key)});
    return std::nullopt;
}

std::optional<double> Members::number(const char* key, Need need) {
    const auto v = value(key, need);
    if (!v)
        return std::nullopt;
    if (v->isDouble())
        return v->toDouble();
    wrongType(pathOf(key), ExpectedType::Number);
    return std::nullopt;
}

void Members::number(const char* key, double& out, Need need) {
    out = number(key, need).value_or(out);
}

void Members::string(const char* key, std::string& out, Need need) {
    const auto v = value(key, need);
    if (v && v->isString())
        out = v->toString().toStdString();
    else if (v)
        wrongType(pathOf(key), ExpectedType::String);
}

void Members::pair(const char* key, Vec2d& out) {
    double* const parts[] = {&out.x, &out.y};
    numbers(key, parts, ExpectedType::Pair, Need::Required);
}

void Members::triple(const char* key, Spin<double>& out, Need need) {
    double* const parts[] = {&out.x, &out.y, &out.z};
    numbers(key, parts, ExpectedType::Triple, need);
}

void Members::numbers(const char* key, std::span<double* const> out, ExpectedType expected, Need need) {
    const auto v = value(key, need);
    if (!v)
        return;
    const QJsonArray array = v->toArray();
    if (!v->isArray() || array.size() != qsizetype(out.size()))
        return wrongType(pathOf(key), expected);
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (const QJsonValue item = array[qsizetype(i)]; item.isDouble())
            *out[i] = item.toDouble();
        else
            wrongType(pathOf(key) + '[' + std::to_string(i) + ']', ExpectedType::Number);
    }
}

void Members::kind(const char* key, BodyKind& out) {
    const auto v = value(key, Need::Required);
    if (!v)
        return;
    if (v->toString() == "ball" || v->toString() == "pin")
        out = v->toString() == "ball" ? BodyKind::Ball : BodyKind::Pin;
    else
        wrongType(pathOf(key), ExpectedType::BodyKind);
}

std::optional<QJsonObject> Members::object(const char* key) {
    const auto v = value(key, Need::Optional);
    if (v && v->isObject())
        return v->toObject();
    if (v)
        wrongType(pathOf(key), ExpectedType::Object);
    return std::nullopt;
}

std::optional<QJsonArray> Members::array(const char* key, Need need) {
    const auto v = value(key, need);
    if (v && v->isArray())
        return v->toArray();
    if (v)
        wrongType(pathOf(key), ExpectedType::Array);
    return std::nullopt;
}

void Members::wrongType(std::string path, ExpectedType expected) {
    m_errors.push_back({.code = SceneErrorCode::WrongType, .path = std::move(path), .expected = expected});
}

} // namespace thetalane
