// A run that is too long to be kept whole: chapters of it, computed again when they are asked for, to the
// very bits that a run kept whole has.
#pragma once

#include "core/engine/engine_in_steps.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace thetalane {

// What happened in [from, to). At `from` a collision happens, but in the first chapter. A run to whoever
// wants one: its timeline is of this chapter alone, with its collisions, and states at from <= t < to.
// Segments may have begun before; groups count from 1 in every chapter; what lasts beyond the chapter lasts
// to its end.
struct Chapter : Run {
    std::size_t index = 0;
    double from = 0;                   // s
    double to = 0;                     // s; timeline.endTime()
    std::int64_t collisionsBefore = 0; // its first collision has the number collisionsBefore + 1
    bool last = false;                 // it holds the end of the run, at `to`

    bool holdsTime(double t) const { return from <= t && (t < to || last); }
    bool holdsCollision(std::int64_t number) const { // from 1
        return collisionsBefore < number &&
               number - collisionsBefore <= std::int64_t(timeline.collisions().size());
    }
};

class LongRun {
public:
    struct Limits {
        std::int64_t chapter = 25'000;                     // collisions, or a few more
        std::size_t snapshotBytes = std::size_t(96) << 20; // about
        std::size_t chaptersKept = 2;
    };

    // For a scene and settings that simulate() takes, of the next-event engine; settings.keepDetail says
    // nothing.
    LongRun(Scene scene, const EngineSettings& settings)
        : LongRun(std::move(scene), settings, Limits{}) {}
    LongRun(Scene scene, const EngineSettings& settings, const Limits& limits);

    // Computes one chapter more; false if there was none.
    bool goOn();
    // Until t is computed, or the run has ended [s].
    void computeTo(double t);

    const Scene& scene() const { return m_scene; }
    const EngineSettings& settings() const { return m_settings; }
    double computedTo() const { return m_starts.back().time; }                 // s
    std::int64_t collisionCount() const { return m_starts.back().collisions; } // so far
    bool ended() const { return m_end.has_value(); }
    std::optional<EndReason> endReason() const { return m_end; }

    // The one that holds t; computes on to it if need be. Beyond the end: the last one.
    std::shared_ptr<const Chapter> chapterAt(double t);
    // The one that holds the collision of that number, from 1.
    std::shared_ptr<const Chapter> chapterOfCollision(std::int64_t number);

    std::size_t snapshotCount() const { return m_snapshots.size(); }

private:
    struct Start {
        double time = 0;
        std::int64_t collisions = 0; // before it
    };

    std::size_t chapterCount() const { return m_starts.size() - 1; }
    std::shared_ptr<const Chapter> chapter(std::size_t index);
    std::shared_ptr<const Chapter> computeAgain(std::size_t index) const;
    void keepSnapshot();

    Scene m_scene;
    EngineSettings m_settings;
    Limits m_limits;
    std::size_t m_mostSnapshots;
    std::unique_ptr<EngineInSteps> m_front; // where the run is computed to
    std::vector<Start> m_starts;            // of every chapter, and where the last one computed ends
    std::vector<std::unique_ptr<const EngineSnapshot>>
        m_snapshots; // at the start of every m_every-th chapter
    std::size_t m_every = 1;
    std::optional<EndReason> m_end;
    std::vector<std::shared_ptr<const Chapter>> m_kept; // the last one asked for at the end
};

} // namespace thetalane
