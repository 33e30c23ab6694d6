// A session whose chapters are short beside the same run kept whole, which says what is right.
#pragma once

#include "core/scene/crowd_scenes.h"
#include "panel_bench.h"

namespace thetalane {

inline constexpr int small = 20; // collisions a chapter

inline Session::Limits smallChapters(int chapter = small) {
    return {.chapters = {.chapter = chapter, .snapshotBytes = 0}};
}

inline Timeline wholeRun(const Scene& scene, double until) {
    EngineSettings settings;
    settings.until = until;
    return std::get<Run>(simulate(scene, settings)).timeline;
}

struct LongRunBench : PanelBench {
    Timeline whole;

    explicit LongRunBench(const Session::Limits& limits = smallChapters(), const Scene& scene = gasScene(25),
                          double until = 1)
        : PanelBench(limits)
        , whole(wholeRun(scene, until)) {
        open(scene, until);
    }
    void open(const Scene& scene, double until) {
        QVERIFY(session.open(scene).empty());
        QVERIFY(!session.setUntil(until));
        session.waitFor(until);
        QVERIFY(session.part().ended);
    }
    std::int64_t count() const { return whole.collisionCount(); }
    bool showsTheWhole() const {
        return session.timeline().stateAt(playhead.time()) == whole.stateAt(playhead.time());
    }
    bool showsCollision(std::int64_t number) const {
        const auto index = playhead.selected();
        if (!index || playhead.selectedNumber() != number)
            return false;
        const Collision& c = session.timeline().collisions()[*index];
        const Collision& same = whole.collisions()[std::size_t(number - 1)];
        return c.time == same.time && c.first == same.first && c.second == same.second &&
               c.steps.impulse == same.steps.impulse && playhead.time() == c.time && showsTheWhole();
    }
};

inline Scene pinsInABox() {
    Scene scene = gasScene(9);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i)
        scene.bodies[i].kind = BodyKind::Pin;
    return scene;
}

} // namespace thetalane
