// Tangent vectors, each one sample of all rounding errors so far, go along the run. Between contacts a body's
// part grows as δp += δv τ. At a contact with unit normal n (from second to first), relative position d and
// velocity w before, |d| = Z, change of velocity per body λ n/m:
//     δt = -(n·δd + γ)/(n·w)                  the shift of the instant; γ: rounding of the gap
//     δn = (δd + w δt)/Z                      (along n nothing is left)
//     δλ = -(1 + e) μ (δw·n + w·δn)           μ: reduced mass
//     δv += (δλ n + λ δn)/m,  δp -= (λ n/m) δt
#include "core/study/digits_left.h"

#include "core/study/contact_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace thetalane {
namespace {

constexpr int samples = 24;
// Of a rounding, in unit roundoffs of the number: uniform to either side, and seldom of the largest number of
// its binade; somewhat less, as what is asked for is the middle of the errors, not their rms.
constexpr double usual = 0.32;

double unitRoundoff(Precision precision) {
    switch (precision) {
    case Precision::Float:
        return 0x1p-24;
    case Precision::Double:
        return 0x1p-53;
    case Precision::Quad:
        break;
    }
    return 0x1p-113;
}

double digitsOf(double error, double most) {
    return error > 0 ? std::clamp(-std::log10(error), 0.0, most) : error == 0 ? most : 0.0;
}

// Roughly normal, of unit spread.
class Noise {
public:
    double operator()() {
        double sum = -2;
        for (int k = 0; k < 4; ++k)
            sum += double(m_bits() >> 11) * 0x1p-53;
        return sum * std::sqrt(3.0);
    }

private:
    std::mt19937_64 m_bits{2026};
};

struct Tangent {
    Vec2d position;
    Vec2d velocity;
};

// One body's part of all samples, at `since`.
struct BodyTangent {
    double since = 0;
    std::array<Tangent, samples> errors;
};

struct Met { // one contact, as numbers of its own
    int first = 0, second = -1;
    double Z = 0, time = 0, restitution = 0, impulse = 0;
    Vec2d n, w; // w: relative velocity before
    double inverseFirst = 0, inverseSecond = 0, reduced = 0;
};

Met metAt(const Collision& c) {
    Met m;
    m.first = c.first;
    m.second = c.second;
    m.Z = c.steps.contact.Z;
    m.time = c.time;
    m.restitution = c.steps.restitution;
    m.impulse = c.steps.impulse;
    m.n = {c.steps.contact.cosTheta, c.steps.contact.sinTheta};
    m.w = c.isWall() ? c.steps.before.first : c.steps.before.first - c.steps.before.second;
    m.inverseFirst = 1 / c.steps.first.mass;
    m.inverseSecond = c.isWall() ? 0 : 1 / c.steps.second.mass;
    m.reduced = 1 / (m.inverseFirst + m.inverseSecond);
    return m;
}

class Growth {
public:
    explicit Growth(const Run& run)
        : m_run(run)
        , m_unit(usual * unitRoundoff(run.settings.precision))
        , m_bodies(run.scene.bodies.size()) {
        if (run.settings.precision != Precision::Float)
            return; // a scene's numbers are doubles, and exact in more
        for (std::size_t i = 0; i < m_bodies.size(); ++i)
            roundTo(i, run.scene.bodies[i].position, run.scene.bodies[i].velocity);
    }

    // The estimated error of what the collision shows.
    double pass(const Collision& c) {
        const Met met = metAt(c);
        flyTo(c.first, c.time);
        if (!c.isWall())
            flyTo(c.second, c.time);
        const double speed = norm(c.steps.before.first) + norm(c.steps.before.second);
        double sum = 0;
        for (int k = 0; k < samples; ++k)
            sum += std::pow(meet(met, c, k, speed), 2);
        roundTo(std::size_t(c.first), c.steps.first.position, c.steps.after.first);
        if (!c.isWall())
            roundTo(std::size_t(c.second), c.steps.second.position, c.steps.after.second);
        return std::sqrt(sum / samples);
    }

private:
    void flyTo(int body, double time) {
        BodyTangent& b = m_bodies[std::size_t(body)];
        for (Tangent& e : b.errors)
            e.position = e.position + e.velocity * (time - b.since);
        b.since = time;
    }

    void roundTo(std::size_t body, Vec2d p, Vec2d v) {
        for (Tangent& e : m_bodies[body].errors) {
            e.position.x += m_unit * std::abs(p.x) * m_noise();
            e.position.y += m_unit * std::abs(p.y) * m_noise();
            e.velocity.x += m_unit * norm(v) * m_noise();
            e.velocity.y += m_unit * norm(v) * m_noise();
        }
    }

    // Sample k through the contact; how far off, in units of Z and the speeds, what it shows is.
    double meet(const Met& m, const Collision& c, int k, double speed) {
        static const Tangent still;
        Tangent& a = m_bodies[std::size_t(m.first)].errors[std::size_t(k)];
        const Tangent b = m.second < 0 ? still : m_bodies[std::size_t(m.second)].errors[std::size_t(k)];
        const double approach = dot(m.n, m.w); // negative
        const double gap = m_unit * (m.Z + norm(c.steps.first.position)) * m_noise();
        const double late = m_unit * m.time * m_noise();
        const Vec2d dd = a.position - b.position, dw = a.velocity - b.velocity;
        const double shift = (approach < 0 ? -(dot(m.n, dd) + gap) / approach : 0) + late;
        const Vec2d across = dd + m.w * shift;
        const Vec2d turn =
            m.second < 0 ? Vec2d{} : (across - m.n * dot(m.n, across)) * (1 / m.Z); // walls stay
        const double push = -(1 + m.restitution) * m.reduced * (dot(dw, m.n) + dot(m.w, turn));
        const Vec2d change = m.n * push + turn * m.impulse;
        a.velocity = a.velocity + change * m.inverseFirst;
        a.position = a.position - m.n * (m.impulse * m.inverseFirst * shift);
        double off = dot(turn, turn) + dot(a.velocity, a.velocity) / (speed * speed);
        if (m.second >= 0) {
            Tangent& other = m_bodies[std::size_t(m.second)].errors[std::size_t(k)];
            other.velocity = other.velocity - change * m.inverseSecond;
            other.position = other.position + m.n * (m.impulse * m.inverseSecond * shift);
            off += dot(other.velocity, other.velocity) / (speed * speed);
        }
        return std::sqrt(off);
    }

    const Run& m_run;
    double m_unit;
    Noise m_noise;
    std::vector<BodyTangent> m_bodies;
};

double mostDigits(Precision precision) {
    return -std::log10(unitRoundoff(precision));
}

// Of b's collision against a's, the same two in both.
double disagreement(const Collision& a, const Collision& b) {
    const double speed = norm(a.steps.before.first) + norm(a.steps.before.second);
    const Vec2d turn{a.steps.contact.cosTheta - b.steps.contact.cosTheta,
                     a.steps.contact.sinTheta - b.steps.contact.sinTheta};
    const Vec2d first = a.steps.after.first - b.steps.after.first;
    const Vec2d second = a.steps.after.second - b.steps.after.second;
    return std::sqrt(dot(turn, turn) + (dot(first, first) + dot(second, second)) / (speed * speed));
}

} // namespace

std::vector<double> digitsLeft(const Run& run) {
    std::vector<double> digits;
    if (run.settings.kind != EngineKind::Event || run.scene.friction)
        return digits;
    const auto collisions = run.timeline.collisions();
    digits.reserve(collisions.size());
    const double most = mostDigits(run.settings.precision);
    Growth growth(run);
    for (const Collision& c : collisions)
        digits.push_back(digitsOf(growth.pass(c), most));
    return digits;
}

std::vector<double> digitsInCommon(const Run& truth, const Run& run) {
    const auto a = truth.timeline.collisions(), b = run.timeline.collisions();
    const double most = mostDigits(run.settings.precision);
    std::vector<double> digits(std::min(a.size(), b.size()));
    for (std::size_t k = 0; k < digits.size(); ++k)
        digits[k] = nameOf(a[k]) == nameOf(b[k]) ? digitsOf(disagreement(a[k], b[k]), most) : 0;
    return digits;
}

} // namespace thetalane
