// Where an engine writes what happens. A summary keeps the last segment of each body and no list.
#pragma once

#include "core/timeline/timeline.h"

#include <algorithm>
#include <type_traits>

namespace thetalane {

class Recorder {
public:
    Recorder(std::size_t bodyCount, bool keepDetail);

    void segment(int body, const Segment& segment);
    void segment(int body, const Segment& segment,
                 const Rotation& rotation); // with friction, for every segment
    // `second` is -1 for a wall; contacts that were resolved together come one after another with the same
    // `pass`, not 0. Counted always, converted and kept only where details are.
    template <class Real>
    void collision(double time, int first, int second, Side side, const PairCollision<Real>& steps,
                   int pass = 0) {
        countCollision(first, second, steps.after);
        if (!m_keepDetail)
            return;
        if constexpr (std::is_same_v<Real, double>)
            m_record.collisions.push_back({time, first, second, side, 0, pass, 1, steps});
        else
            m_record.collisions.push_back({time, first, second, side, 0, pass, 1, convert<double>(steps)});
    }
    // Where details are not kept: the velocities after it, of which a wall has none.
    template <class Real> void countCollision(int first, int second, const VelocityPair<Real>& after) {
        ++m_record.collisionCount;
        notice(first, after.first);
        if (second >= 0)
            notice(second, after.second);
    }
    void departure(const Departure& departure);
    void lasting(const LastingContact& contact);

    bool keepsDetail() const { return m_keepDetail; }
    std::int64_t collisionCount() const { return m_record.collisionCount; }

    Timeline finish(double endTime, EndReason reason);

private:
    template <class Real> void notice(int body, const Vec2<Real>& velocity) {
        double& fastest = m_record.struckSpeeds[std::size_t(body)]; // squared until the end
        fastest = std::max(fastest, static_cast<double>(dot(velocity, velocity)));
    }

    std::size_t m_bodyCount;
    bool m_keepDetail;
    TimelineRecord m_record;
};

} // namespace thetalane
