// The built-in scenes. Their ids are public: files, tests and lessons name them.
#pragma once

#include "core/scene/scene.h"

#include <optional>
#include <span>
#include <string_view>

namespace thetalane {

struct BuiltinScene {
    std::string_view id;
    Scene (*make)();
};

// From the simplest to the whole lane, the order in which a class meets them.
std::span<const BuiltinScene> builtinScenes();

std::optional<Scene> builtinScene(std::string_view id);

} // namespace thetalane
