#include "tests/benchmarks/judge.h"

#include "core/engine/engine.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace thetalane::benchmarks {
namespace {

double wallDepth(const Frame& frame, const Body& body, Vec2d p) {
    const double depth = std::max(
        {frame.left ? *frame.left - p.x : -body.radius, frame.right ? p.x - *frame.right : -body.radius,
         frame.bottom ? *frame.bottom - p.y : -body.radius, frame.top ? p.y - *frame.top : -body.radius});
    return (depth + body.radius) / (2 * body.radius);
}

// Sorted by their left edges, so that only neighbours are compared.
double deepestOverlap(const Scene& scene, std::span<const BodyState> states) {
    double depth = 0;
    std::vector<std::size_t> order(states.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto left = [&](std::size_t i) { return states[i].position.x - scene.bodies[i].radius; };
    std::sort(order.begin(), order.end(), [&](auto i, auto j) { return left(i) < left(j); });
    for (std::size_t a = 0; a < order.size(); ++a) {
        const std::size_t i = order[a];
        if (states[i].place != Place::Play)
            continue;
        if (scene.frame)
            depth = std::max(depth, wallDepth(*scene.frame, scene.bodies[i], states[i].position));
        const double right = states[i].position.x + scene.bodies[i].radius;
        for (std::size_t b = a + 1; b < order.size() && left(order[b]) < right; ++b) {
            const std::size_t j = order[b];
            const double reach = scene.bodies[i].radius + scene.bodies[j].radius;
            if (states[j].place == Place::Play)
                depth = std::max(depth, 1 - norm(states[i].position - states[j].position) / reach);
        }
    }
    return depth;
}

double momentumSum(const Scene& scene, std::span<const BodyState> states) {
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum += scene.bodies[i].mass * norm(states[i].velocity);
    return sum;
}

} // namespace

std::vector<BodyState> startOf(const Scene& scene) {
    std::vector<BodyState> states;
    for (const Body& b : scene.bodies)
        states.push_back({b.position, b.velocity});
    return states;
}

Judge::Judge(const Scene& scene, Reference reference)
    : m_scene(scene)
    , m_reference(std::move(reference))
    , m_start(totals(scene, startOf(scene))) {}

void Judge::see(double t, std::span<const BodyState> states) {
    m_verdict.overlap = std::max(m_verdict.overlap, deepestOverlap(m_scene, states));
    const Totals now = totals(m_scene, states);
    m_verdict.energyDrift = (now.energy - m_reference.energy) / m_start.energy;
    if (!m_scene.frame && !m_scene.lane && !m_scene.friction)
        m_verdict.momentumDrift = norm(now.momentum - m_start.momentum) / momentumSum(m_scene, states);
    if (m_compared || !(t >= m_reference.moment - 1e-9))
        return;
    m_compared = true;
    double squares = 0;
    for (std::size_t i = 1; i < states.size(); ++i) {
        const Vec2d off = states[i].velocity - m_reference.states[i].velocity;
        squares += dot(off, off) / double(states.size() - 1);
    }
    m_verdict.speedError = std::sqrt(squares);
}

void Judge::touched(const Collision& c) {
    const double reach = c.steps.first.radius + c.steps.second.radius;
    m_verdict.overlap = std::max(m_verdict.overlap, 1 - c.steps.contact.Z / reach);
}

Reference elasticReference(const Scene& scene) {
    return {totals(scene, startOf(scene)).energy, unknown, {}};
}

Reference quadReference(const Scene& scene, double until, double after) {
    EngineSettings settings;
    settings.until = until;
    settings.precision = Precision::Quad;
    const auto result = simulate(scene, settings);
    const Run* run = std::get_if<Run>(&result);
    if (!run || run->timeline.collisions().empty())
        return elasticReference(scene);
    const double moment = run->timeline.collisions().front().time + after;
    return {totals(scene, run->timeline.stateAt(until)).energy, moment, run->timeline.stateAt(moment)};
}

} // namespace thetalane::benchmarks
