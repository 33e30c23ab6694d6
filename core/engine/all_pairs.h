// The search for a few bodies: each disc is compared with all others, the earliest event is found by looking
// at all. Nothing is prepared and nothing kept, which no cleverness beats for a rack.
#pragma once

#include "core/engine/moving_discs.h"
#include "core/engine/surroundings.h"

#include <vector>

namespace thetalane {

template <class Real> class AllPairs {
public:
    using Index = std::size_t;
    static constexpr Index nobody = Index(-1);
    static constexpr bool rebasesTime = false;

    explicit AllPairs(const Scene& scene)
        : m_discs(scene.bodies)
        , m_next(m_discs.count())
        , m_in(m_discs.count()) {}

    MovingDiscs<Real>& discs() { return m_discs; }
    const MovingDiscs<Real>& discs() const { return m_discs; }

    template <class Around> void start(const Around& around) {
        for (Index i = 0; i < m_discs.count(); ++i)
            findNext(around, i, Real(0), i + 1);
    }

    struct First {
        Index body;
        NextEvent<Real> event;
    };
    template <class Around> First earliest(const Around&) const {
        Index best = 0;
        for (Index i = 1; i < m_next.size(); ++i)
            if (m_next[i].time < m_next[best].time)
                best = i;
        return {best, m_next[best]};
    }

    // Bodies i and j (or i alone) move otherwise from now on: they and whoever counted on them look again.
    template <class Around> void changedCourse(const Around& around, Index i, Index j, const Real& now) {
        m_lookAgain.clear();
        for (Index k = 0; k < m_next.size(); ++k) {
            const bool countedOnThem =
                m_next[k].kind == EventKind::Pair && (m_next[k].partner == i || m_next[k].partner == j);
            if (k == i || k == j || countedOnThem)
                m_lookAgain.push_back(k);
        }
        for (const Index k : m_lookAgain)
            findNext(around, k, now, 0);
    }

private:
    // Finds what happens next to body i, by itself or with bodies from `from` on. Each pair is looked at by
    // the one that changed course last, so a body that only waits to be struck keeps no event and is not
    // asked again.
    template <class Around> void findNext(const Around& around, Index i, const Real& now, Index from) {
        m_next[i] = {};
        if constexpr (Around::hasFrame || Around::hasLane)
            m_next[i] =
                around.next(i, now, m_discs.positionAt(i, now), m_discs.velocity(i), m_discs.radiusOf(i));
        if (!around.inPlay(i))
            return;
        m_discs.timesToImpact(i, from, now, m_in.data());
        for (Index j = from; j < m_discs.count(); ++j) {
            if (!(m_in[j] < std::numeric_limits<Real>::infinity()) || !around.inPlay(j))
                continue;
            const Real time = now + m_in[j];
            if (time < m_next[i].time)
                m_next[i] = {time, unsigned(j), EventKind::Pair, 0};
        }
    }

    MovingDiscs<Real> m_discs;
    std::vector<NextEvent<Real>> m_next;
    std::vector<Real> m_in;         // of the last timesToImpact()
    std::vector<Index> m_lookAgain; // of the last changedCourse()
};

} // namespace thetalane
