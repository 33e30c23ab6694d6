// A SCENE of the command line: a built-in name, a file, or "-" for standard input.
#pragma once

#include "core/scene/scene.h"

#include <QString>

#include <variant>

namespace thetalane {

class Arguments;

// The scene, or the line to tell: "scene.json: bodies[1].mass: must be greater than 0, is -3".
std::variant<Scene, QString> loadScene(const QString& source);

// Of a built-in scene alone.
std::variant<Scene, QString> loadBuiltin(const QString& name);

bool isBuiltin(const QString& name);

// The positional argument SCENE, with its description.
void takeScene(Arguments& arguments);

} // namespace thetalane
