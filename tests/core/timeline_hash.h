// All bits of a run in one number.
#pragma once

#include "core/timeline/timeline.h"

#include <bit>
#include <cstdint>

namespace thetalane::testing {

class Fnv1a {
public:
    void add(std::uint64_t word) {
        for (int i = 0; i < 8; ++i)
            m_hash = (m_hash ^ (word >> (8 * i) & 0xff)) * 0x100000001b3u;
    }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
    void add(Vec2d v) { add(v.x), add(v.y); }
    void add(const VelocityPair<double>& v) { add(v.first), add(v.second); }
    std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325u;
};

inline std::uint64_t hashOf(const Timeline& timeline) {
    Fnv1a hash;
    for (const Collision& c : timeline.collisions()) {
        hash.add(c.time);
        hash.add(std::uint64_t(c.first) << 32 | std::uint64_t(c.second + 1) << 8 | std::uint64_t(c.side));
        hash.add(c.steps.first.position);
        hash.add(c.steps.second.position);
        hash.add(c.steps.contact.cosTheta);
        hash.add(c.steps.contact.sinTheta);
        hash.add(c.steps.before);
        hash.add(c.steps.rotated);
        hash.add(c.steps.exchanged);
        hash.add(c.steps.after);
        hash.add(c.steps.impulse);
        hash.add(c.steps.energyLoss);
    }
    for (const Departure& d : timeline.departures())
        hash.add(d.time);
    hash.add(timeline.endTime());
    for (const BodyState& s : timeline.stateAt(timeline.endTime())) {
        hash.add(s.position);
        hash.add(s.velocity);
        hash.add(std::uint64_t(s.place));
    }
    return hash.value();
}

} // namespace thetalane::testing
