// Contacts of the same instant: which they are, in which pass they were resolved, and what is said about it.
#pragma once

#include "core/engine/engine.h"

#include <QString>

#include <cstddef>
#include <span>
#include <vector>

namespace thetalane {

// Where one collision stands among those of its instant. Indices into the run's collisions.
struct Instant {
    std::size_t begin = 0; // of the group
    std::size_t size = 1;
    std::size_t passBegin = 0;
    std::size_t passSize = 1; // 1: resolved alone
    int pass = 1;
    int passes = 1; // of the group
};
Instant instantOf(std::span<const Collision> collisions, std::size_t index);

// The contacts that were resolved together with one, itself among them.
std::span<const Collision> passOf(std::span<const Collision> collisions, std::size_t index);

// Every body of a pass once: its velocity before and after the whole pass [m/s].
struct PassBody {
    int body = 0;
    double mass = 0; // [kg]
    Vec2d before;
    Vec2d after;
};
std::vector<PassBody> bodiesOf(std::span<const Collision> pass);

// "Contact 2 of 4 at this instant · pass 1 of 2: 3 contacts resolved together"; empty for one alone.
QString instantText(const Instant& instant, std::size_t index);

// The question a reader has, and the rule that answers it, in a few sentences.
QString instantQuestion(const Instant& instant); // "Why together?"
QString instantRule(const Instant& instant, const EngineSettings& engine);

QString contactName(const Scene& scene, const Collision& collision); // "A → C"

} // namespace thetalane
