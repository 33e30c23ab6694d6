// Contacts that last: pairs, or a body and a wall, that friction presses together and that move on as one.
#pragma once

#include "core/timeline/recorder.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace thetalane {

// Which two are in contact; a wall has no second.
struct ContactName {
    std::size_t first = 0;
    std::size_t second = nobody;
    Side side = Side::Left;

    static constexpr std::size_t nobody = std::size_t(-1);
    bool isWall() const { return second == nobody; }
    friend bool operator==(const ContactName&, const ContactName&) = default;
};

class HeldContacts {
public:
    bool holds(const ContactName& name) const {
        return std::any_of(m_held.begin(), m_held.end(), [&](const Held& h) { return h.name == name; });
    }
    bool holdsPair(std::size_t i, std::size_t j) const {
        return !m_held.empty() && holds({std::min(i, j), std::max(i, j), Side::Left});
    }
    bool holdsWall(std::size_t i, Side side) const {
        return !m_held.empty() && holds({i, ContactName::nobody, side});
    }

    bool concerns(std::size_t i) const {
        return std::any_of(m_held.begin(), m_held.end(),
                           [i](const Held& h) { return h.name.first == i || h.name.second == i; });
    }

    std::vector<std::size_t> partnersOf(std::size_t i) const {
        std::vector<std::size_t> out;
        for (const Held& h : m_held)
            if (!h.name.isWall() && (h.name.first == i || h.name.second == i))
                out.push_back(h.name.first == i ? h.name.second : h.name.first);
        return out;
    }

    void hold(const ContactName& name, double now) {
        if (!holds(name))
            m_held.push_back({name, now});
    }
    // Ends those that `over` names.
    template <class Over> void release(Over&& over, double now, Recorder& recorder) {
        std::erase_if(m_held, [&](const Held& h) {
            if (!over(h.name))
                return false;
            if (now > h.since)
                recorder.lasting({h.since, now, int(h.name.first), h.name.isWall() ? -1 : int(h.name.second),
                                  h.name.side});
            return true;
        });
    }

private:
    struct Held {
        ContactName name;
        double since = 0;
    };
    std::vector<Held> m_held;
};

} // namespace thetalane
