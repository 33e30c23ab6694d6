// The members of one JSON object, each taken out as what it must be; what is wrong becomes a SceneError.
#pragma once

#include "core/motion/floor_state.h"
#include "core/scene/scene.h"
#include "core/scene/validation.h"

#include <QJsonArray>
#include <QJsonObject>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace thetalane {

// Nobody reads more, and a file of a million wrong keys should not take a minute.
inline constexpr std::size_t enoughErrors = 1000;

enum class Need { Required, Optional };

class Members {
public:
    // Every key that is not `known` is an error. object and errors must outlive this.
    Members(const QJsonObject& object, std::string path, std::span<const std::string_view> known,
            std::vector<SceneError>& errors);

    std::string pathOf(const std::string& key) const { return m_path.empty() ? key : m_path + '.' + key; }

    // Nothing where the key is absent; an error too, where it is required and not there misspelt.
    std::optional<QJsonValue> value(const char* key, Need need);

    // What is absent or of the wrong type leaves `out` as it is.
    std::optional<double> number(const char* key, Need need = Need::Required);
    void number(const char* key, double& out, Need need = Need::Required);
    void string(const char* key, std::string& out, Need need = Need::Required);
    void pair(const char* key, Vec2d& out);
    void triple(const char* key, Spin<double>& out, Need need);
    void kind(const char* key, BodyKind& out);
    std::optional<QJsonObject> object(const char* key);
    std::optional<QJsonArray> array(const char* key, Need need);

    void wrongType(std::string path, ExpectedType expected);

private:
    void numbers(const char* key, std::span<double* const> out, ExpectedType expected, Need need);

    const QJsonObject& m_object;
    std::string m_path;
    std::vector<SceneError>& m_errors;
    std::vector<std::string> m_misspelt; // what the unknown keys were probably meant to be
};

} // namespace thetalane
