#include "ui/bench/rules/placing.h"

#include <QString>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

namespace thetalane {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What validate() allows to rounding.
double allowance(Vec2d a, double ra, Vec2d b, double rb) {
    const double scale = std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y) + ra + rb;
    return 8 * std::numeric_limits<double>::epsilon() * scale;
}

struct Circle {
    Vec2d centre;
    double radius;
};

// Where the centre of a disc may be as far as the walls and the lane go.
struct Box {
    Vec2d low{-infinity, -infinity};
    Vec2d high{infinity, infinity};

    bool isEmpty() const { return low.x > high.x || low.y > high.y; }
    Vec2d nearest(Vec2d p) const { return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)}; }
};

Box boxFor(const Scene& scene, const Mover& mover) {
    Box box;
    if (const auto& frame = scene.frame) {
        box.low = {frame->left.value_or(-infinity) + mover.radius,
                   frame->bottom.value_or(-infinity) + mover.radius};
        box.high = {frame->right.value_or(infinity) - mover.radius,
                    frame->top.value_or(infinity) - mover.radius};
    }
    if (const auto& lane = scene.lane) {
        box.low.x = std::max(box.low.x, lane->left);
        box.high = {std::min(box.high.x, lane->right), std::min(box.high.y, lane->end)};
    }
    if (mover.line) {
        box.low.y = std::max(box.low.y, *mover.line);
        box.high.y = std::min(box.high.y, *mover.line);
    }
    return box;
}

bool isInside(const Box& box, Vec2d p, double radius) {
    const double slack = allowance(p, radius, p, radius) / 2;
    return p.x >= box.low.x - slack && p.x <= box.high.x + slack && p.y >= box.low.y - slack &&
           p.y <= box.high.y + slack;
}

void addProjection(const Circle& c, Vec2d wanted, std::vector<Vec2d>& out) {
    const Vec2d away = wanted - c.centre;
    const double distance = norm(away);
    const Vec2d direction = distance > 0 ? away * (1 / distance) : Vec2d{1, 0};
    out.push_back(c.centre + direction * c.radius);
}

void addOnEdges(const Circle& c, const Box& box, std::vector<Vec2d>& out) {
    const auto along = [&](double offset) {
        return std::sqrt(std::max(0.0, (c.radius - offset) * (c.radius + offset)));
    };
    for (const double x : {box.low.x, box.high.x})
        if (std::abs(x - c.centre.x) <= c.radius)
            for (const double sign : {-1.0, 1.0})
                out.push_back({x, c.centre.y + sign * along(x - c.centre.x)});
    for (const double y : {box.low.y, box.high.y})
        if (std::abs(y - c.centre.y) <= c.radius)
            for (const double sign : {-1.0, 1.0})
                out.push_back({c.centre.x + sign * along(y - c.centre.y), y});
}

void addCrossings(const Circle& a, const Circle& b, std::vector<Vec2d>& out) {
    const Vec2d between = b.centre - a.centre;
    const double d = norm(between);
    if (!(d > 0) || d > a.radius + b.radius || d < std::abs(a.radius - b.radius))
        return;
    const Vec2d u = between * (1 / d);
    const double along = (d + (a.radius - b.radius) * (a.radius + b.radius) / d) / 2;
    const double across = std::sqrt(std::max(0.0, (a.radius - along) * (a.radius + along)));
    for (const double sign : {-1.0, 1.0})
        out.push_back(a.centre + u * along + Vec2d{-u.y, u.x} * (sign * across));
}

// The nearest point of what is left of a box when circles are taken out of it is the point itself, its
// projection on one of the circles, or where two boundaries cross.
std::vector<Vec2d> candidates(const std::vector<Circle>& circles, const Box& box, Vec2d wanted) {
    std::vector<Vec2d> out{box.nearest(wanted)};
    for (const double x : {box.low.x, box.high.x})
        for (const double y : {box.low.y, box.high.y})
            if (std::isfinite(x) && std::isfinite(y))
                out.push_back({x, y});
    for (std::size_t i = 0; i < circles.size(); ++i) {
        addProjection(circles[i], wanted, out);
        addOnEdges(circles[i], box, out);
        for (std::size_t j = 0; j < i; ++j)
            addCrossings(circles[i], circles[j], out);
    }
    return out;
}

std::vector<Circle> circlesAround(const Scene& scene, const Mover& mover, double wider) {
    std::vector<Circle> circles;
    for (int i = 0; i < int(scene.bodies.size()); ++i) {
        const Body& body = scene.bodies[std::size_t(i)];
        if (i != mover.index)
            circles.push_back({body.position, (body.radius + mover.radius) * wider});
    }
    return circles;
}

double middleOf(double low, double high, double otherwise) {
    return std::isfinite(low) && std::isfinite(high) ? (low + high) / 2 : otherwise;
}

Vec2d middleOf(const Scene& scene) {
    Vec2d low{infinity, infinity}, high{-infinity, -infinity};
    for (const Body& b : scene.bodies) {
        low = {std::min(low.x, b.position.x), std::min(low.y, b.position.y)};
        high = {std::max(high.x, b.position.x), std::max(high.y, b.position.y)};
    }
    const Box box = boxFor(scene, {});
    return {middleOf(box.low.x, box.high.x, (low.x + high.x) / 2),
            middleOf(box.low.y, box.high.y, (low.y + high.y) / 2)};
}

std::string freshName(const Scene& scene) {
    std::set<std::string> taken;
    for (const Body& body : scene.bodies)
        taken.insert(body.id);
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (!taken.contains(std::string(1, letter)))
            return std::string(1, letter);
    int number = 1;
    while (taken.contains(std::to_string(number)))
        ++number;
    return std::to_string(number);
}

// Pushed apart along the line, first away from the left wall and then away from the right one.
bool pushApart(std::vector<Body*>& row, const Box& walls) {
    double edge = walls.low.x;
    for (Body* body : row) {
        body->position.x = std::max(body->position.x, edge + body->radius);
        edge = body->position.x + body->radius;
    }
    edge = walls.high.x;
    for (auto it = row.rbegin(); it != row.rend(); ++it) {
        Body& body = **it;
        body.position.x = std::min(body.position.x, edge - body.radius);
        edge = body.position.x - body.radius;
    }
    const Body& first = *row.front();
    return edge >= walls.low.x - allowance(first.position, first.radius, first.position, first.radius) / 2;
}

} // namespace

double tidy(double value) {
    return QString::number(value, 'g', 12).toDouble() + 0.0; // and no minus before a zero
}

bool isFree(const Scene& scene, const Mover& mover, Vec2d place) {
    if (!isInside(boxFor(scene, mover), place, mover.radius))
        return false;
    for (int i = 0; i < int(scene.bodies.size()); ++i) {
        const Body& other = scene.bodies[std::size_t(i)];
        if (i == mover.index)
            continue;
        const double depth = mover.radius + other.radius - norm(place - other.position);
        if (depth > allowance(place, mover.radius, other.position, other.radius) / 2)
            return false;
    }
    return true;
}

std::optional<Vec2d> freePlaceNear(const Scene& scene, const Mover& mover, Vec2d wanted) {
    const Box box = boxFor(scene, mover);
    if (box.isEmpty())
        return std::nullopt;
    std::optional<Vec2d> best;
    // Once more a hair wider, for corners so narrow that rounding alone would leave nothing.
    for (const double wider : {1.0, 1 + 1e-9}) {
        for (Vec2d place : candidates(circlesAround(scene, mover, wider), box, wanted)) {
            if (mover.line && std::abs(place.y - *mover.line) <= mover.radius)
                place.y = *mover.line; // to the last bit; whether it is free there is asked next
            if (isFree(scene, mover, place) && (!best || norm(place - wanted) < norm(*best - wanted)))
                best = place;
        }
        if (best)
            break;
    }
    return best;
}

std::optional<double> lineOf(const Scene& scene) {
    const double y = scene.bodies.front().position.y;
    for (const Body& body : scene.bodies)
        if (body.position.y != y || body.velocity.y != 0)
            return std::nullopt;
    return y;
}

std::optional<Scene> linedUp(const Scene& scene) {
    Scene lined = scene;
    Box narrowest;
    for (const Body& body : scene.bodies) {
        const Box box = boxFor(scene, {.radius = body.radius});
        narrowest.low.y = std::max(narrowest.low.y, box.low.y);
        narrowest.high.y = std::min(narrowest.high.y, box.high.y);
    }
    if (narrowest.isEmpty())
        return std::nullopt;
    const double y = std::clamp(scene.bodies.front().position.y, narrowest.low.y, narrowest.high.y);
    std::vector<Body*> row;
    for (Body& body : lined.bodies) {
        body.position.y = y;
        body.velocity.y = 0;
        row.push_back(&body);
    }
    std::stable_sort(row.begin(), row.end(),
                     [](const Body* a, const Body* b) { return a->position.x < b->position.x; });
    if (!pushApart(row, boxFor(scene, {})))
        return std::nullopt;
    return lined;
}

std::optional<Scene> withOneMore(const Scene& scene, std::optional<double> line) {
    if (scene.bodies.size() >= mostOnTheBench)
        return std::nullopt;
    std::vector<double> radii;
    for (const Body& body : scene.bodies)
        radii.push_back(body.radius);
    std::nth_element(radii.begin(), radii.begin() + std::ptrdiff_t(radii.size() / 2), radii.end());
    Body body;
    body.id = freshName(scene);
    body.mass = 1;
    body.radius = radii[radii.size() / 2]; // as large as the others are
    for (const double space : {1.5, 1.0}) {
        const Mover mover{.radius = body.radius * space, .index = -1, .line = line};
        const auto place = freePlaceNear(scene, mover, middleOf(scene));
        if (!place)
            continue;
        const Vec2d rounded{std::round(place->x * 100) / 100 + 0.0,
                            line ? *line : std::round(place->y * 100) / 100 + 0.0};
        body.position = isFree(scene, {body.radius, -1, line}, rounded) ? rounded : *place;
        Scene more = scene;
        more.bodies.push_back(body);
        return more;
    }
    return std::nullopt;
}

Scene without(Scene scene, std::size_t body) {
    scene.bodies.erase(scene.bodies.begin() + std::ptrdiff_t(body));
    return scene;
}

void setMass(Body& body, double mass, bool constantSize) {
    if (!constantSize && mass > 0 && body.mass > 0)
        body.radius = tidy(body.radius * std::cbrt(mass / body.mass));
    body.mass = mass;
}

double placeForWall(const Scene& scene, Side side) {
    constexpr double gap = 0.3;
    const bool alongX = side == Side::Left || side == Side::Right;
    const bool low = side == Side::Left || side == Side::Bottom;
    double edge = -infinity;
    for (const Body& body : scene.bodies) {
        const double centre = alongX ? body.position.x : body.position.y;
        edge = std::max(edge, (low ? -centre : centre) + body.radius);
    }
    const double place = std::ceil((edge + gap) * 10) / 10;
    return low ? -place : place;
}

Scene newScene() {
    Scene scene;
    scene.bodies = {{"A", BodyKind::Ball, 1, 0.1, {-0.5, 0}, {1, 0}},
                    {"B", BodyKind::Ball, 1, 0.1, {0.3, 0}, {0, 0}}};
    scene.frame = Frame{-1, 1, -0.6, 0.6, 1};
    return scene;
}

} // namespace thetalane
