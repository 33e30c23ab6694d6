#include "core/study/extremes.h"

#include "core/study/extreme_rows.h"

#include <utility>

namespace thetalane {
namespace extremes {

Body ball(int number, double mass, double radius, Vec2d position, Vec2d velocity) {
    return {std::to_string(number), BodyKind::Ball, mass, radius, position, velocity};
}

Scene sceneOf(double restitution, std::vector<Body> bodies) {
    Scene scene;
    scene.restitution = restitution;
    scene.bodies = std::move(bodies);
    return scene;
}

std::vector<BodyState> startOf(const Scene& scene) {
    std::vector<BodyState> states;
    for (const Body& b : scene.bodies)
        states.push_back({b.position, b.velocity, Place::Play, b.spin});
    return states;
}

Timeline runOf(const Scene& scene, const EngineSettings& settings) {
    auto outcome = simulate(scene, settings);
    return std::move(std::get<Run>(outcome).timeline); // the settings of this study are none to be refused
}

Timeline runOf(const Scene& scene, double until) {
    EngineSettings settings;
    settings.until = until;
    return runOf(scene, settings);
}

double energyOf(const Scene& scene, std::span<const BodyState> states) {
    double energy = totals(scene, states).energy;
    for (std::size_t i = 0; scene.friction && i < states.size(); ++i) {
        const Body& b = scene.bodies[i];
        const Spin<double>& w = states[i].spin;
        if (b.kind == BodyKind::Ball)
            energy += 0.5 * b.inertia * b.mass * b.radius * b.radius * (w.x * w.x + w.y * w.y + w.z * w.z);
    }
    return energy;
}

Meeting meetingOf(const Body& first, const Body& second, const Quad& restitution) {
    const Vec2<Quad> d = convert<Quad>(first.position) - convert<Quad>(second.position);
    const Vec2<Quad> u = convert<Quad>(first.velocity) - convert<Quad>(second.velocity);
    const Quad reach = Quad(first.radius) + Quad(second.radius), speed2 = dot(u, u);
    const Quad nearest = cross(d, u) * cross(d, u) / speed2; // squared
    Meeting m;
    m.first = convert<Quad>(first.velocity);
    m.second = convert<Quad>(second.velocity);
    const Quad ma(first.mass), mb(second.mass);
    const auto energy = [&] { return Quad((ma * dot(m.first, m.first) + mb * dot(m.second, m.second)) / 2); };
    m.energyBefore = m.energyAfter = energy();
    m.meets = dot(d, u) < 0 && nearest < reach * reach;
    if (!m.meets)
        return m;
    m.time = -dot(d, u) / speed2 - sqrt(Quad((reach * reach - nearest) / speed2));
    m.normal = (d + u * m.time) * Quad(1 / reach);
    const Quad impulse = -(1 + restitution) * dot(u, m.normal) * ma * mb / (ma + mb);
    m.first = m.first + m.normal * Quad(impulse / ma);
    m.second = m.second - m.normal * Quad(impulse / mb);
    m.energyAfter = energy();
    return m;
}

double relativeError(double got, const Quad& exact) {
    return double(abs(Quad((Quad(got) - exact) / exact)));
}

} // namespace extremes

std::vector<ExtremeResult> studyExtremes(bool quick, const std::function<void(ExtremeRow)>& begins) {
    using namespace extremes;
    std::vector<ExtremeResult> results;
    const std::pair<ExtremeRow, std::function<void(Results&)>> rows[] = {
        {ExtremeRow::MassRatio, massRatios},
        {ExtremeRow::RadiusRatio, radiusRatios},
        {ExtremeRow::Speed, speeds},
        {ExtremeRow::Coordinates, coordinates},
        {ExtremeRow::Restitution, restitutions},
        {ExtremeRow::Coincident, coincident},
        {ExtremeRow::Grazing, grazing},
        {ExtremeRow::LongRun, [quick](Results& out) { longRuns(out, quick); }},
        {ExtremeRow::CountingPi, countingPi},
        {ExtremeRow::TimeReversal, timeReversal},
        {ExtremeRow::InelasticCollapse, collapse},
        {ExtremeRow::LastingContact, lasting},
        {ExtremeRow::ContactTime, contactTimes},
        {ExtremeRow::Mirror, mirror},
    };
    for (const auto& [row, fill] : rows) {
        if (begins)
            begins(row);
        fill(results);
    }
    return results;
}

} // namespace thetalane
