// What is said about a scene: its title, what is wrong with it, why an engine will not run it.
#pragma once

#include "core/engine/engine.h"
#include "core/scene/validation.h"
#include "ui/words/language.h"

#include <QString>

namespace thetalane {

// In the language asked for, or the other one where it has none.
QString sceneTitle(const Scene& scene, Language::Code language);

// Without the place: "must be greater than 0, is -3".
QString sceneErrorMessage(const SceneError& error);

// With the place: "bodies[1].mass: must be greater than 0, is -3".
QString sceneErrorText(const SceneError& error);

// Without the option's name: "must be greater than 0, is -1".
QString refusalMessage(const Refusal& refusal);

QString endReasonText(EndReason reason);
QString sideName(Side side); // "left wall"

} // namespace thetalane
