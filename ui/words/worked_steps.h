// One collision worked through in words and formulas, with the engine's own numbers substituted. Nothing is
// recomputed here: every number comes out of PairCollision.
#pragma once

#include "core/timeline/timeline.h"
#include "ui/words/formula.h"

#include <QString>

#include <span>
#include <vector>

namespace thetalane {

// The paper's steps in order; the number on screen is the value.
enum class Stage { Contact, Split, Rotation, Exchange, RotationBack, Check };
inline constexpr int stageCount = 6;

// left = symbolic = substituted = result; a part that would say nothing new is an empty Row.
struct WorkedLine {
    Formula left;
    Formula symbolic;
    Formula substituted;
    Formula result; // a number with its unit
};

struct WorkedStep {
    Stage stage = Stage::Contact;
    QString title;    // Contact, Velocity split, Rotation by θ, …
    QString sentence; // what happens here and why, one sentence for a class
    std::vector<WorkedLine> lines;
    std::size_t key = 0; // the line that says the step in short
};

// One line of text: a = x_A − x_B = 0.12 − 0 = 0.12 m.
QString plainText(const WorkedLine& line, Digits digits = Digits::Four);

QString stageTitle(Stage stage);

// The name of a collision's partner as shown: a body's id, or a wall ("left wall"). The names of the built-in
// scenes that are words stand in the language of now; a name that somebody gave stays.
QString bodyName(const Body& body);
bool isWordName(const Body& body);
QString bodyName(const Scene& scene, int body);
QString partnerName(const Scene& scene, const Collision& collision);

// The letters of an index: a body's name, cut where it is long; W for a wall.
QString indexName(const Scene& scene, int body);

// v with its index: of a body (-1: a wall), along an axis ("x", "y", "x′", "y′" or none), a prime for after.
enum class When { Before, After };
Formula velocitySymbol(const Scene& scene, const Collision& collision, int body, const QString& axis,
                       When when);

// Six steps, in the order of the stages. At a wall the second body has no lines. Of contacts that were
// resolved together, the exchange and the check are those of the whole pass.
std::vector<WorkedStep> workedSteps(const Scene& scene, std::span<const Collision> collisions,
                                    std::size_t index);
std::vector<WorkedStep> workedSteps(const Scene& scene, const Collision& collision); // one by itself

} // namespace thetalane
