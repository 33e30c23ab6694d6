#include "core/bowling/hit_tree.h"

#include <algorithm>
#include <charconv>
#include <span>

namespace thetalane {
namespace {

bool movesAtFirst(const Timeline& timeline, std::size_t body) {
    const Segment& s = timeline.segments(body).front();
    if (s.velocity.x != 0 || s.velocity.y != 0)
        return true;
    const auto rotations = timeline.rotations(body); // a ball that spins on the spot will go
    return !rotations.empty() && rotations.front().phase != FloorPhase::Rest;
}

class Maker {
public:
    Maker(const Timeline& timeline, std::size_t bodies)
        : m_moving(bodies)
        , m_hit(bodies)
        , m_below(bodies) {
        for (std::size_t k = 0; k < bodies; ++k)
            m_moving[k] = movesAtFirst(timeline, k);
    }

    // Contacts of one pass happen together, in whatever order they stand: first those that a moving body
    // makes, then those of the bodies that these set moving.
    void takePass(std::span<const Collision> pass, std::size_t first) {
        std::vector<std::size_t> waiting;
        for (std::size_t k = 0; k < pass.size(); ++k)
            if (!pass[k].isWall())
                waiting.push_back(k);
        bool any = true;
        while (any && !waiting.empty()) {
            any = false;
            std::vector<std::size_t> rest;
            for (const std::size_t k : waiting) {
                if (take(pass[k], first + k))
                    any = true;
                else
                    rest.push_back(k);
            }
            waiting = std::move(rest);
        }
        for (const std::size_t k : waiting) // neither moves: an overlap that was exchanged
            m_tree.later.push_back(hitOf(pass[k], first + k, false));
    }

    HitTree finish() {
        for (std::size_t k = 0; k < m_moving.size(); ++k) {
            if (!m_hit[k])
                m_tree.untouched.push_back(int(k));
            else if (!m_below[k])
                m_tree.roots.push_back(int(k));
        }
        const auto earlier = [](const Hit& a, const Hit& b) { return a.collision < b.collision; };
        std::sort(m_tree.later.begin(), m_tree.later.end(), earlier);
        return std::move(m_tree);
    }

private:
    static Hit hitOf(const Collision& c, std::size_t index, bool swapped) {
        const int from = swapped ? c.second : c.first, to = swapped ? c.first : c.second;
        return {index, from, to, c.time, c.steps.impulse, false};
    }

    bool take(const Collision& c, std::size_t index) {
        const bool first = m_moving[std::size_t(c.first)], second = m_moving[std::size_t(c.second)];
        if (!first && !second)
            return false;
        Hit hit = hitOf(c, index,
                        !first || (second && m_hit[std::size_t(c.second)] && !m_hit[std::size_t(c.first)]));
        const bool firstOfIt = !m_hit[std::size_t(hit.to)];
        hit.setMoving = !m_moving[std::size_t(hit.to)];
        m_hit[std::size_t(hit.from)] = m_hit[std::size_t(hit.to)] = true;
        m_moving[std::size_t(hit.to)] = true;
        m_below[std::size_t(hit.to)] = m_below[std::size_t(hit.to)] || firstOfIt;
        if (firstOfIt) // it hangs together with nothing yet, so this makes no ring
            m_tree.edges.push_back(hit);
        else
            m_tree.later.push_back(hit);
        return true;
    }

    std::vector<bool> m_moving;
    std::vector<bool> m_hit;   // it met another
    std::vector<bool> m_below; // it has an edge of its own
    HitTree m_tree;
};

bool samePass(const Collision& a, const Collision& b) {
    return a.group != 0 && a.group == b.group && a.pass == b.pass && a.time == b.time;
}

} // namespace

const Hit* HitTree::hitOn(int body) const {
    const auto at = std::find_if(edges.begin(), edges.end(), [=](const Hit& h) { return h.to == body; });
    return at == edges.end() ? nullptr : &*at;
}

HitTree hitTree(const Scene& scene, const Timeline& timeline, std::size_t most) {
    const std::size_t bodies = std::min(scene.bodies.size(), timeline.bodyCount());
    const auto all = timeline.collisions();
    Maker maker(timeline, bodies);
    std::size_t begin = 0;
    while (begin < all.size() && begin < most) {
        std::size_t end = begin + 1;
        while (end < all.size() && samePass(all[begin], all[end]))
            ++end;
        maker.takePass(all.subspan(begin, end - begin), begin);
        begin = end;
    }
    HitTree tree = maker.finish();
    tree.leftOut = std::size_t(std::max<std::int64_t>(0, timeline.collisionCount() - std::int64_t(begin)));
    return tree;
}

std::array<int, 10> perfectStrikers(Hand hand) {
    //                                    pin: 1  2  3  4  5  6  7  8  9  10
    return hand == Hand::Right ? std::array{0, 1, 0, 2, 0, 3, 4, 5, 0, 6}
                               : std::array{0, 0, 1, 2, 0, 3, 4, 0, 5, 6};
}

std::optional<int> pinNumber(const Body& body) {
    int number = 0;
    const char* end = body.id.data() + body.id.size();
    const auto [at, fault] = std::from_chars(body.id.data(), end, number);
    const bool read = body.kind == BodyKind::Pin && fault == std::errc() && at == end;
    return read && number >= 1 && number <= 10 ? std::optional(number) : std::nullopt;
}

bool isPerfectLink(const Scene& scene, const Hit& edge, Hand hand) {
    const auto pin = pinNumber(scene.bodies[std::size_t(edge.to)]);
    const Body& from = scene.bodies[std::size_t(edge.from)];
    if (!pin)
        return false;
    const int striker = perfectStrikers(hand)[std::size_t(*pin - 1)];
    return striker == 0 ? from.kind == BodyKind::Ball : pinNumber(from) == striker;
}

std::optional<PerfectLinks> perfectLinks(const Scene& scene, const HitTree& tree) {
    PinSet pins, byBall;
    int balls = 0;
    for (const Body& body : scene.bodies) {
        balls += body.kind == BodyKind::Ball;
        if (const auto number = pinNumber(body))
            pins.set(std::size_t(*number - 1));
    }
    if (balls != 1 || !pins.all() || scene.bodies.size() != 11)
        return std::nullopt;
    const auto note = [&](const Hit& hit) {
        const Body &a = scene.bodies[std::size_t(hit.from)], &b = scene.bodies[std::size_t(hit.to)];
        if (a.kind != b.kind)
            byBall.set(std::size_t(*pinNumber(a.kind == BodyKind::Pin ? a : b) - 1));
    };
    std::for_each(tree.edges.begin(), tree.edges.end(), note);
    std::for_each(tree.later.begin(), tree.later.end(), note);
    PerfectLinks best;
    for (const Hand hand : {Hand::Right, Hand::Left}) {
        PerfectLinks now{hand, 0, false};
        PinSet wanted;
        const auto strikers = perfectStrikers(hand);
        for (std::size_t k = 0; k < strikers.size(); ++k)
            wanted.set(k, strikers[k] == 0);
        now.links = int((wanted & byBall).count());
        for (const Hit& edge : tree.edges)
            now.links += isPerfectLink(scene, edge, hand) &&
                         scene.bodies[std::size_t(edge.from)].kind == BodyKind::Pin;
        now.perfect = now.links == 10 && byBall == wanted;
        if (now.links > best.links || now.perfect)
            best = now;
    }
    return best;
}

} // namespace thetalane
