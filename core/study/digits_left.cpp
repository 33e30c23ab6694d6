// Tangent vectors, each one sample of all rounding errors so far, go along the run. Between contacts a body's
// part grows as δp += δv τ. At a contact with unit normal n (from second to first), relative position d and
// velocity w before, |d| = Z, change of velocity per body λ n/m:
//     δt = -(n·δd + γ)/(n·w)                  the shift of the instant; γ: rounding of the gap
//     δn = (δd + w δt)/Z                      (along n nothing is left)
//     δλ = -(1 + e) μ (δw·n + w·δn)           μ: reduced mass
//     δv += (δλ n + λ δn)/m,  δp -= (λ n/m) δt
#include "core/study/digits_left.h"

#include "core/study/contact_names.h"
#include "core/study/tangent_flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <random>
#include <unordered_map>

namespace thetalane {
namespace {

constexpr int samples = tangentSamples;
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

// Uniform, of unit spread; two numbers from each draw.
class Noise {
public:
    double operator()() {
        m_second = !m_second;
        if (m_second)
            m_drawn = m_bits();
        const auto half = std::uint32_t(m_second ? m_drawn : m_drawn >> 32);
        return (half * 0x1p-31 - 1) * 1.7320508075688772;
    }

private:
    std::mt19937_64 m_bits{2026};
    std::uint64_t m_drawn = 0;
    bool m_second = false;
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
        : m_unit(usual * unitRoundoff(run.settings.precision)) {
        for (std::size_t i = 0; i < run.scene.bodies.size(); ++i) {
            m_bodies.emplace_back(run.scene, run.timeline, i);
            // A scene's numbers are doubles, and exact in more.
            if (run.settings.precision == Precision::Float)
                roundStart(m_bodies.back(), run.scene.bodies[i]);
        }
    }

    // The estimated error of what the collision shows.
    double pass(const Collision& c) {
        const Met met = metAt(c);
        TangentFlight& first = m_bodies[std::size_t(c.first)];
        TangentFlight* second = c.isWall() ? nullptr : &m_bodies[std::size_t(c.second)];
        first.flyTo(c.time);
        if (second)
            second->flyTo(c.time);
        double sum = 0;
        const auto shifts = shiftsOf(met, c, first, second);
        moveBy(first, shifts, 1);
        if (second)
            moveBy(*second, shifts, 1);
        for (int k = 0; k < samples; ++k)
            sum += meet(met, c, shifts[std::size_t(k)], first.errors[std::size_t(k)],
                        second ? &second->errors[std::size_t(k)] : nullptr);
        first.goOn();
        moveBy(first, shifts, -1);
        roundTo(first, c.steps.first.position, c.steps.after.first);
        if (second) {
            second->goOn();
            moveBy(*second, shifts, -1);
            roundTo(*second, c.steps.second.position, c.steps.after.second);
        }
        return std::sqrt(sum / samples);
    }

private:
    using Shifts = std::array<double, samples>;

    void roundStart(TangentFlight& body, const Body& b) {
        for (Tangent& e : body.errors) {
            e.position = e.position + roundingOf(b.position);
            e.velocity = e.velocity + roundingOf(b.velocity);
            e.spin = e.spin + roundingOf({b.spin.x, b.spin.y});
        }
    }
    Vec2d roundingOf(const Vec2d& v) {
        const double x = m_unit * std::abs(v.x) * m_noise();
        return {x, m_unit * std::abs(v.y) * m_noise()};
    }

    // After a contact: what was turned to and fro has the rounding of its length in both directions.
    void roundTo(TangentFlight& body, Vec2d p, Vec2d v) {
        for (Tangent& e : body.errors) {
            e.position = e.position + roundingOf(p);
            e.velocity.x += m_unit * norm(v) * m_noise();
            e.velocity.y += m_unit * norm(v) * m_noise();
        }
    }

    // Of the instant, in each sample [s].
    Shifts shiftsOf(const Met& m, const Collision& c, const TangentFlight& first,
                    const TangentFlight* second) {
        Shifts shifts{};
        const double approach = dot(m.n, m.w); // negative
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            const double gap = m_unit * (m.Z + norm(c.steps.first.position)) * m_noise();
            const double late = m_unit * m.time * m_noise();
            const Vec2d d = first.errors[k].position - (second ? second->errors[k].position : Vec2d{});
            shifts[k] = (approach < 0 ? -(dot(m.n, d) + gap) / approach : 0) + late;
        }
        return shifts;
    }

    // To the contact's own instant, or back from it; how the positions shift is the contact's business.
    static void moveBy(TangentFlight& body, const Shifts& shifts, double sign) {
        const Vec2d a = body.acceleration(), rate = body.spinRate();
        for (std::size_t k = 0; k < shifts.size(); ++k) {
            body.errors[k].velocity = body.errors[k].velocity + a * (sign * shifts[k]);
            body.errors[k].spin = body.errors[k].spin + rate * (sign * shifts[k]);
        }
    }

    // One sample through the contact; how far off, in units of Z and the speeds, what it shows is, squared.
    static double meet(const Met& m, const Collision& c, double shift, Tangent& a, Tangent* b) {
        const double speed = norm(c.steps.before.first) + norm(c.steps.before.second);
        const Vec2d dd = a.position - (b ? b->position : Vec2d{});
        const Vec2d dw = a.velocity - (b ? b->velocity : Vec2d{});
        const Vec2d off = dd + m.w * shift;
        const Vec2d turn = b ? (off - m.n * dot(m.n, off)) * (1 / m.Z) : Vec2d{}; // walls stay
        const double push = -(1 + m.restitution) * m.reduced * (dot(dw, m.n) + dot(m.w, turn));
        const Vec2d change = m.n * push + turn * m.impulse;
        a.velocity = a.velocity + change * m.inverseFirst;
        a.position = a.position - m.n * (m.impulse * m.inverseFirst * shift);
        double sum = dot(turn, turn) + dot(a.velocity, a.velocity) / (speed * speed);
        if (b) {
            b->velocity = b->velocity - change * m.inverseSecond;
            b->position = b->position + m.n * (m.impulse * m.inverseSecond * shift);
            sum += dot(b->velocity, b->velocity) / (speed * speed);
        }
        return sum;
    }

    double m_unit;
    Noise m_noise;
    std::vector<TangentFlight> m_bodies;
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
    if (run.settings.kind != EngineKind::Event)
        return digits;
    const auto collisions = run.timeline.collisions();
    digits.reserve(collisions.size());
    const double most = mostDigits(run.settings.precision);
    Growth growth(run);
    // In a long run chaos leaves none some day, and then none come back.
    const std::size_t enough = 1000 + 4 * run.scene.bodies.size();
    std::size_t none = 0; // in a row
    for (const Collision& c : collisions) {
        digits.push_back(none < enough ? digitsOf(growth.pass(c), most) : 0);
        none = digits.back() == 0 ? none + 1 : 0;
    }
    return digits;
}

std::vector<double> digitsInCommon(const Run& truth, const Run& run) {
    const auto there = truth.timeline.collisions(), here = run.timeline.collisions();
    // In a crowd far apart things happen in another order: the n-th time that the same two meet is the same.
    std::unordered_map<MetName, std::deque<std::size_t>> meetings;
    for (std::size_t k = 0; k < there.size(); ++k)
        meetings[nameOf(there[k])].push_back(k);
    const double most = mostDigits(run.settings.precision);
    std::vector<double> digits;
    for (const Collision& c : here) {
        if (c.time > truth.timeline.endTime())
            break;
        auto& same = meetings[nameOf(c)];
        digits.push_back(same.empty() ? 0 : digitsOf(disagreement(there[same.front()], c), most));
        if (!same.empty())
            same.pop_front();
    }
    return digits;
}

} // namespace thetalane
