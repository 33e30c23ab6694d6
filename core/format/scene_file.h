// Scene files, version 1. See README, "Scene files".
#pragma once

#include "core/scene/scene.h"
#include "core/scene/validation.h"

#include <QByteArray>

#include <string>
#include <variant>
#include <vector>

namespace thetalane {

// A scene that validate() finds nothing wrong with, or everything that is wrong, in the order of the file.
// A file of another format or version has that one error alone; after a thousand the reader stops looking.
std::variant<Scene, std::vector<SceneError>> readScene(const QByteArray& json);

// Laid out to be read and edited by hand; reads back to the same scene, to the last bit (Qt's JSON reader
// drops the sign of a zero; nothing else is lost).
QByteArray writeScene(const Scene& scene);

// SceneError::other of NotJson is Qt's reason in English, one of core/format/json_strict.h, or one of these.
// Of a key that an object has twice, the path names the key; of the others, the line and column.
inline constexpr const char* emptyFileReason = "the file is empty";
inline constexpr const char* missingCommaReason = "a comma or a closing bracket is missing";
inline constexpr const char* duplicateKeyReason = "duplicate key";

// "line 3, column 14" of a byte in UTF-8 text, both counted from 1, columns in characters.
std::string placeInText(const QByteArray& text, qsizetype offset);

// The largest file worth reading: far beyond what maxBodies need [bytes].
inline constexpr qint64 maxSceneFileSize = 64 * 1024 * 1024;

} // namespace thetalane
