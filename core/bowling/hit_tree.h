// Who hit whom: of each body the collision that set it moving, which makes a tree, and the hits after that.
#pragma once

#include "core/scene/bowling_scene.h"
#include "core/timeline/timeline.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace thetalane {

// One body hit another. collision: index into Timeline::collisions(); time [s], impulse [N·s].
struct Hit {
    std::size_t collision = 0;
    int from = 0; // body that moved already; of two that did, Collision::first
    int to = 0;
    double time = 0;
    double impulse = 0;
    bool setMoving = false; // `to` was at rest from the beginning until then

    friend bool operator==(const Hit&, const Hit&) = default;
};

struct HitTree {
    // Each body's first hit at most, in the order of time; following them backwards ends at a root. Bodies
    // that move from the beginning are joined by their first meeting.
    std::vector<Hit> edges;
    std::vector<Hit> later;     // all other hits between two bodies; walls are nobody
    std::vector<int> roots;     // that hit something before anything hit them
    std::vector<int> untouched; // by any body
    std::size_t leftOut = 0;    // hits beyond `most`: they are in neither list

    const Hit* hitOn(int body) const; // its edge; null of a root
};

// most: how many hits are looked at; the rest is counted.
HitTree hitTree(const Scene& scene, const Timeline& timeline, std::size_t most = 100'000);

// The perfect strike of the books: the ball touches four pins (another pin may have come first), the pins
// themselves do the rest.
enum class Hand { Right, Left };

// Who is to hit pin k + 1 in it: 0 is the ball, else the pin's number. Left is the mirror image.
std::array<int, 10> perfectStrikers(Hand hand);

struct PerfectLinks {
    Hand hand = Hand::Right; // of which more came about
    int links = 0;           // of ten: pins that the ball touches, pins set moving by the right one
    bool perfect = false;    // all of them, and the ball touched no other pin

    friend bool operator==(const PerfectLinks&, const PerfectLinks&) = default;
};

// Of a ball thrown at ten pins named "1" to "10"; nothing for any other scene.
std::optional<PerfectLinks> perfectLinks(const Scene& scene, const HitTree& tree);

// Whether the edge is one of the perfect strike's.
bool isPerfectLink(const Scene& scene, const Hit& edge, Hand hand);

// The number of a pin of the rack, 1 to 10; nothing of any other body.
std::optional<int> pinNumber(const Body& body);

} // namespace thetalane
