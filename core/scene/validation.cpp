#include "core/scene/validation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>

namespace thetalane {
namespace {

using Errors = std::vector<SceneError>;

std::string bodyPath(std::size_t i, const char* field) {
    return "bodies[" + std::to_string(i) + "]" + (*field ? "." : "") + field;
}

bool checkFinite(double v, const std::string& path, Errors& out) {
    if (std::isfinite(v))
        return true;
    out.push_back({.code = SceneErrorCode::NotFinite, .path = path});
    return false;
}

void checkPositive(double v, const std::string& path, Errors& out) {
    if (checkFinite(v, path, out) && !(v > 0))
        out.push_back({.code = SceneErrorCode::NotPositive, .path = path, .value = v});
}

void checkRestitution(double e, const std::string& path, Errors& out) {
    if (checkFinite(e, path, out) && !(e >= 0 && e <= 1))
        out.push_back({.code = SceneErrorCode::OutOfRange, .path = path, .value = e, .low = 0, .high = 1});
}

void checkFriction(double mu, const std::string& path, Errors& out) {
    if (checkFinite(mu, path, out) && !(mu >= 0 && mu <= maxFriction))
        out.push_back(
            {.code = SceneErrorCode::OutOfRange, .path = path, .value = mu, .low = 0, .high = maxFriction});
}

void checkInertia(double beta, const std::string& path, Errors& out) {
    if (checkFinite(beta, path, out) && !(beta > 0 && beta <= 1))
        out.push_back(
            {.code = SceneErrorCode::OutOfOpenRange, .path = path, .value = beta, .low = 0, .high = 1});
}

void checkVector(Vec2d v, const std::string& path, Errors& out) {
    checkFinite(v.x, path + "[0]", out);
    checkFinite(v.y, path + "[1]", out);
}

void checkSpin(const Spin<double>& spin, const std::string& path, Errors& out) {
    checkFinite(spin.x, path + "[0]", out);
    checkFinite(spin.y, path + "[1]", out);
    checkFinite(spin.z, path + "[2]", out);
}

void checkBodies(const Scene& scene, Errors& out) {
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (body.id.empty())
            out.push_back({.code = SceneErrorCode::EmptyId, .path = bodyPath(i, "id")});
        else if (!seen.insert(body.id).second)
            out.push_back({.code = SceneErrorCode::DuplicateId, .path = bodyPath(i, "id"), .other = body.id});
        if (body.id.starts_with(wallPrefix))
            out.push_back({.code = SceneErrorCode::ReservedId, .path = bodyPath(i, "id"), .other = body.id});
        checkPositive(body.mass, bodyPath(i, "mass"), out);
        checkPositive(body.radius, bodyPath(i, "radius"), out);
        checkVector(body.position, bodyPath(i, "position"), out);
        checkVector(body.velocity, bodyPath(i, "velocity"), out);
        if (body.spin != Spin<double>{})
            checkSpin(body.spin, bodyPath(i, "spin"), out);
        checkInertia(body.inertia, bodyPath(i, "inertia"), out);
    }
}

void checkFrame(const Frame& frame, Errors& out) {
    static constexpr const char* names[] = {"frame.left", "frame.right", "frame.bottom", "frame.top"};
    for (std::size_t s = 0; s < sides.size(); ++s)
        if (const auto& side = frame.side(sides[s]))
            checkFinite(*side, names[s], out);
    checkRestitution(frame.restitution, "frame.restitution", out);
    if (frame.left && frame.right && *frame.right <= *frame.left)
        out.push_back({.code = SceneErrorCode::WallsCrossed,
                       .path = "frame.right",
                       .value = *frame.right,
                       .low = *frame.left});
    if (frame.bottom && frame.top && *frame.top <= *frame.bottom)
        out.push_back({.code = SceneErrorCode::WallsCrossed,
                       .path = "frame.top",
                       .value = *frame.top,
                       .low = *frame.bottom});
}

void checkKickbacks(const Lane& lane, Errors& out) {
    const double from = lane.kickbacks->from;
    checkRestitution(lane.kickbacks->restitution, "lane.kickbacks.restitution", out);
    if (!checkFinite(from, "lane.kickbacks.from", out) || !(lane.foulLine < lane.end))
        return;
    if (from < lane.foulLine || from > lane.end)
        out.push_back({.code = SceneErrorCode::KickbacksOffTheLane,
                       .path = "lane.kickbacks.from",
                       .value = from,
                       .low = lane.foulLine,
                       .high = lane.end});
}

void checkLane(const Lane& lane, Errors& out) {
    checkFinite(lane.left, "lane.left", out);
    checkFinite(lane.right, "lane.right", out);
    checkFinite(lane.foulLine, "lane.foul_line", out);
    checkFinite(lane.end, "lane.end", out);
    checkPositive(lane.gutterWidth, "lane.gutter_width", out);
    checkPositive(lane.pitDepth, "lane.pit_depth", out);
    if (lane.right <= lane.left)
        out.push_back({.code = SceneErrorCode::WallsCrossed,
                       .path = "lane.right",
                       .value = lane.right,
                       .low = lane.left});
    if (lane.end <= lane.foulLine)
        out.push_back({.code = SceneErrorCode::WallsCrossed,
                       .path = "lane.end",
                       .value = lane.end,
                       .low = lane.foulLine});
    if (lane.kickbacks)
        checkKickbacks(lane, out);
}

void checkOil(const std::vector<OilZone>& oil, Errors& out) {
    const auto pathOf = [](std::size_t i) { return "friction.oil[" + std::to_string(i) + "]"; };
    for (std::size_t i = 0; i < oil.size(); ++i) {
        const std::string path = pathOf(i);
        const bool from = checkFinite(oil[i].from, path + ".from", out);
        const bool to = checkFinite(oil[i].to, path + ".to", out);
        checkFriction(oil[i].friction, path + ".friction", out);
        if (from && to && !(oil[i].from < oil[i].to))
            out.push_back({.code = SceneErrorCode::OilReversed,
                           .path = path + ".to",
                           .value = oil[i].to,
                           .low = oil[i].from});
        if (i > 0 && oil[i].from < oil[i - 1].to)
            out.push_back({.code = SceneErrorCode::OilOverlap,
                           .path = path + ".from",
                           .value = oil[i].from,
                           .low = oil[i - 1].to,
                           .other = pathOf(i - 1)});
    }
}

void checkFloor(const Friction& friction, Errors& out) {
    checkFriction(friction.ball, "friction.ball", out);
    checkFriction(friction.rolling, "friction.rolling", out);
    checkFriction(friction.pin, "friction.pin", out);
    checkPositive(friction.gravity, "friction.gravity", out);
    checkOil(friction.oil, out);
}

// Positions carry rounding of their own size; bodies laid edge to edge by arithmetic may be that deep.
double roundingAllowance(const Body& a, const Body& b) {
    const double scale = std::abs(a.position.x) + std::abs(a.position.y) + std::abs(b.position.x) +
                         std::abs(b.position.y) + a.radius + b.radius;
    return 8 * std::numeric_limits<double>::epsilon() * scale;
}

void checkWalls(const Scene& scene, Errors& out) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& b = scene.bodies[i];
        const Frame& f = *scene.frame;
        const double depth[] = {f.left ? *f.left - (b.position.x - b.radius) : 0,
                                f.right ? b.position.x + b.radius - *f.right : 0,
                                f.bottom ? *f.bottom - (b.position.y - b.radius) : 0,
                                f.top ? b.position.y + b.radius - *f.top : 0};
        static constexpr const char* names[] = {"left", "right", "bottom", "top"};
        const auto deepest = std::max_element(std::begin(depth), std::end(depth)) - std::begin(depth);
        if (depth[deepest] > roundingAllowance(b, b))
            out.push_back({.code = SceneErrorCode::OverlapsWall,
                           .path = bodyPath(i, "position"),
                           .value = depth[deepest],
                           .first = b.id,
                           .other = names[deepest]});
    }
}

void checkOnLane(const Scene& scene, Errors& out) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Vec2d p = scene.bodies[i].position;
        if (p.x < scene.lane->left || p.x > scene.lane->right || p.y > scene.lane->end)
            out.push_back({.code = SceneErrorCode::OffTheLane,
                           .path = bodyPath(i, "position"),
                           .first = scene.bodies[i].id});
    }
}

// Sort and sweep along x, so that a large scene is checked without comparing every pair.
void checkOverlaps(const Scene& scene, Errors& out) {
    const auto& bodies = scene.bodies;
    std::vector<std::size_t> order(bodies.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto leftEdge = [&](std::size_t i) { return bodies[i].position.x - bodies[i].radius; };
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return leftEdge(i) < leftEdge(j); });

    std::vector<std::size_t> open;
    std::vector<std::pair<std::size_t, SceneError>> found;
    for (const std::size_t j : order) {
        std::erase_if(open, [&](auto i) { return bodies[i].position.x + bodies[i].radius < leftEdge(j); });
        for (const std::size_t i : open) {
            const double depth =
                bodies[i].radius + bodies[j].radius - norm(bodies[i].position - bodies[j].position);
            if (depth <= roundingAllowance(bodies[i], bodies[j]))
                continue;
            const auto [low, high] = std::minmax(i, j);
            found.push_back({high,
                             {.code = SceneErrorCode::Overlap,
                              .path = bodyPath(high, "position"),
                              .value = depth,
                              .first = bodies[low].id,
                              .other = bodies[high].id}});
            break;
        }
        open.push_back(j);
    }
    std::stable_sort(found.begin(), found.end(), [](auto& a, auto& b) { return a.first < b.first; });
    for (auto& f : found)
        out.push_back(std::move(f.second));
}

} // namespace

std::vector<SceneError> validate(const Scene& scene) {
    Errors out;
    checkRestitution(scene.restitution, "restitution", out);
    if (scene.bodies.empty())
        out.push_back({.code = SceneErrorCode::NoBodies, .path = "bodies"});
    if (scene.bodies.size() > maxBodies) {
        out.push_back({.code = SceneErrorCode::TooManyBodies,
                       .path = "bodies",
                       .value = double(scene.bodies.size()),
                       .high = double(maxBodies)});
        return out;
    }
    checkBodies(scene, out);
    if (scene.frame)
        checkFrame(*scene.frame, out);
    if (scene.lane)
        checkLane(*scene.lane, out);
    if (scene.friction)
        checkFloor(*scene.friction, out);
    if (!out.empty())
        return out; // where bodies stand means something only for sound numbers
    if (scene.frame)
        checkWalls(scene, out);
    if (scene.lane)
        checkOnLane(scene, out);
    checkOverlaps(scene, out);
    return out;
}

} // namespace thetalane
