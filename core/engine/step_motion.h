// The bodies of an engine that goes in equal steps: times count from the start of the present step.
//
// A stretch of motion is one closed form from where it began, however many steps ago: what a body does
// between contacts does not depend on the step.
#pragma once

#include "core/engine/floor_motion.h"
#include "core/timeline/recorder.h"

#include <cstdint>
#include <vector>

namespace thetalane {

template <class Real, bool Friction> class StepMotion {
public:
    using Index = std::size_t;

    StepMotion(const Scene& scene, const Real& step)
        : m_step(step)
        , m_discs(scene.bodies)
        , m_floor(scene)
        , m_began(scene.bodies.size()) {
        for (Index i = 0; i < m_discs.count(); ++i)
            goOn(i, m_discs.velocity(i), Real(0), true);
    }

    const MovingDiscs<Real, Friction>& discs() const { return m_discs; }

    // Body i to `now`, at most the end of its stretch; then goOn().
    void moveTo(Index i, const Real& now) {
        if constexpr (Friction)
            m_floor.moveTo(m_discs, i, now);
        else
            m_discs.moveTo(i, now);
    }
    // From where it was moved to, with velocity v.
    void goOn(Index i, const Vec2<Real>& v, const Real& now, bool inPlay) {
        m_discs.setVelocity(i, v);
        m_began[i] = {m_steps, now, Real(0)};
        if constexpr (Friction) {
            m_floor.begin(m_discs, i, now, inPlay, {}, Real(0));
            m_began[i].lasts = m_discs.until(i) - now;
        }
    }
    bool atRest(Index i) const {
        return m_discs.velocity(i) == Vec2<Real>{} && m_discs.acceleration(i) == Vec2<Real>{};
    }
    bool allAtRest() const {
        for (Index i = 0; i < m_discs.count(); ++i)
            if (!atRest(i))
                return false;
        return true;
    }

    // Times count from one step later.
    void nextStep() {
        ++m_steps;
        for (Index i = 0; i < m_discs.count(); ++i) {
            if (atRest(i))
                continue; // it is where it is at any time
            const Began& b = m_began[i];
            const Real since = b.at - Real(double(m_steps - b.step)) * m_step;
            m_discs.put(i, m_discs.position(i), m_discs.velocity(i), since);
            if constexpr (Friction)
                m_discs.setAcceleration(i, m_discs.acceleration(i), since + b.lasts);
        }
    }

    // Everybody a step further, alone; times count from there. The last step of all may be shorter.
    // `changed(i, at)`: on the way, at a time of the old step, body i went over to another stretch. Without
    // friction by v·h, as the paper moves them.
    template <class InPlay, class Changed>
    void advance(const Real& step, InPlay&& inPlay, Changed&& changed) {
        for (Index i = 0; i < m_discs.count(); ++i) {
            if constexpr (Friction) {
                while (m_discs.until(i) <= step) {
                    const Real at = std::max(m_discs.until(i), Real(0));
                    moveTo(i, at);
                    goOn(i, m_discs.velocity(i), at, inPlay(i));
                    changed(i, at);
                }
            } else {
                const Vec2<Real> v = m_discs.velocity(i);
                m_discs.put(i, m_discs.position(i) + v * step, v, Real(0));
            }
        }
        if constexpr (Friction)
            nextStep();
    }

    // The stretch on which body i goes on.
    void record(Recorder& recorder, Index i, double time, Place place) const {
        const Segment segment{time, convert<double>(m_discs.position(i)),
                              convert<double>(m_discs.velocity(i)), convert<double>(m_discs.acceleration(i)),
                              place};
        if constexpr (Friction)
            recorder.segment(int(i), segment, m_floor.rotation(i));
        else
            recorder.segment(int(i), segment);
    }

private:
    // When the present stretch began.
    struct Began {
        std::int64_t step = 0;
        Real at{}; // in that step
        Real lasts{};
    };

    Real m_step;
    std::int64_t m_steps = 0;
    MovingDiscs<Real, Friction> m_discs;
    FloorMotion<Real> m_floor;
    std::vector<Began> m_began;
};

} // namespace thetalane
