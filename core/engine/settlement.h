// What happens where several bodies touch at one instant: ties, and the end of a cascade.
//
// Ties: all contacts that approach are reflected together, each with its own law of restitution
// (core/collision/contact_group.h), and this repeats until none approaches. A chain passes its impulse on one
// contact at a time; a ball on two pins strikes both at once.
// Inelastic cascades: when an instant has seen too many passes and e < 1, all that touch are brought to rest
// against each other in one perfectly inelastic pass.
// Without `ties` each pass has one contact alone: what most programs do, to be compared with.
#pragma once

#include "core/collision/contact_group.h"
#include "core/engine/contact_cluster.h"
#include "core/engine/pressing.h"

#include <tuple>

namespace thetalane {

template <class Real, class Models, class Search> class Settlement {
public:
    using Index = std::size_t;
    using Velocities = std::vector<Vec2<Real>>;

    Settlement(const Scene& scene, Search& search, const Surroundings<Real, Models>& around,
               Recorder& recorder, bool ties)
        : m_search(search)
        , m_around(around)
        , m_recorder(recorder)
        , m_cluster(search, around, Real(scene.restitution))
        , m_ties(ties) {}

    // The cluster about the event, moved to now by `move`; its velocities.
    template <class Move> void gather(const ContactName& event, const Real& now, Move&& move) {
        m_cluster.gather(event, now);
        m_velocities.clear();
        for (const Index b : m_cluster.bodies()) {
            move(b);
            m_velocities.push_back(m_search.discs().velocity(b));
        }
        m_cluster.measure();
    }
    const std::vector<Index>& bodies() const { return m_cluster.bodies(); }
    const std::vector<Touch<Real>>& touches() const { return m_cluster.touches(); }
    const Velocities& velocities() const { return m_velocities; }
    // `adjust(place, velocity)` for each body.
    template <class Adjust> void change(Adjust&& adjust) {
        for (Index k = 0; k < m_velocities.size(); ++k)
            adjust(k, m_velocities[k]);
    }

    // Passes until none approaches. `slowestRebound(velocities)`: a contact that would part no faster lasts,
    // and so does not bounce.
    template <class SlowestRebound> void reflect(double time, SlowestRebound&& slowestRebound) {
        const int most = passesPerBody * int(m_ties ? m_cluster.bodies().size() : m_cluster.touches().size());
        for (int pass = 1; planApproaching(); ++pass) {
            if ((pass > most && losesEnergy()) || endsAtOnce() || allLast(slowestRebound))
                return closeAll(time, slowestRebound);
            apply();
            if (stopBouncing(slowestRebound))
                apply();
            record(time);
            m_velocities = m_after;
        }
    }

    // Slower bodies are held by the floor; whoever still comes upon them is stopped by them, without bounce.
    // Where that leaves one between them no way out, only those whose speed is rounding.
    void stopBelow(const Real& speed) {
        if (!stopsBelow(speed))
            stopsBelow(std::min(speed, Real(4096 * std::numeric_limits<Real>::epsilon() * fastest())));
    }

    // What lasts does not part: where another contact's impulse has parted two that are pressed together, for
    // less than the contact time, or they creep upon each other, they go on with one speed along their
    // normal. `inverseMass`: of the bodies, so that kinetic energy falls, as in every pass without bounce.
    // False if all do so anyway.
    bool keepTogether(const std::vector<Index>& pressed, const std::vector<Real>& inverseMass) {
        using std::abs;
        Real most(0);
        const Real rounding = 1024 * std::numeric_limits<Real>::epsilon() * fastest();
        std::vector<GroupContact<Real>> contacts;
        const auto& touches = m_cluster.touches();
        for (Index k = 0; k < touches.size(); ++k) {
            const Touch<Real>& t = touches[k];
            const Index second = t.name.isWall() ? GroupContact<Real>::wall : t.second;
            contacts.push_back({t.first, second, t.normal(), opening(t)});
            if (std::find(pressed.begin(), pressed.end(), k) == pressed.end())
                continue;
            most = std::max(most, Real(abs(opening(t))));
            contacts.push_back({t.first, second, t.normal() * Real(-1), -opening(t)});
        }
        if (!(most > rounding))
            return false;
        const auto solution = solveForces<Real>(contacts, inverseMass);
        for (Index b = 0; b < m_velocities.size(); ++b)
            m_velocities[b] = m_velocities[b] + solution.change[b];
        for (const Index k : pressed) // along a wall exactly
            if (const Touch<Real>& t = touches[k]; t.name.isWall() && abs(opening(t)) <= rounding)
                m_velocities[t.first] = m_velocities[t.first] - t.normal() * opening(t);
        return true;
    }

    void standStill() { m_velocities.assign(m_velocities.size(), {}); }

    static constexpr int passesPerBody = 32;

private:
    struct Planned {
        Index touch = 0;
        Real restitution{};
        Real opening{};
        Real impulse{};
        Real lossShare{};   // of a closing pass alone [J]
        bool lasts = false; // it does not bounce, and
        bool meets = true;  // was not in contact before
    };

    bool stopsBelow(const Real& speed) {
        m_after = m_velocities;
        bool stopped = false;
        std::vector<Real> inverseMass;
        for (Index b = 0; b < m_velocities.size(); ++b) {
            const bool stops = norm(m_velocities[b]) < speed;
            stopped |= stops;
            inverseMass.push_back(stops ? Real(0) : Real(1 / m_search.discs().massOf(m_cluster.bodies()[b])));
            if (stops)
                m_velocities[b] = {};
        }
        if (!stopped || !planApproaching())
            return true;
        planAll();
        const auto contacts = plannedContacts();
        const auto solution = solveForces<Real>(contacts, inverseMass);
        for (Index b = 0; b < m_velocities.size(); ++b)
            m_velocities[b] = m_velocities[b] + solution.change[b];
        const Real scale = std::max(largestDemand<Real>(contacts), fastest());
        const bool unmet = std::any_of(contacts.begin(), contacts.end(),
                                       [&](const auto& c) { return isUnmet<Real>(c, solution, scale); });
        if (unmet)
            m_velocities = m_after;
        return !unmet;
    }

    Vec2<Real> relativeVelocity(const Touch<Real>& t, const Velocities& v) const {
        return t.name.isWall() ? v[t.first] : v[t.first] - v[t.second];
    }
    Real opening(const Touch<Real>& t) const { return dot(t.normal(), relativeVelocity(t, m_velocities)); }

    // Approaching by more than rounding; at a wall at all.
    bool approaches(const Touch<Real>& t) const {
        const Real u = opening(t);
        if (t.name.isWall())
            return u < Real(0);
        const Vec2<Real>&a = m_velocities[t.first], &b = m_velocities[t.second];
        const Real noise = approachNoise<Real>() / 2; // surely less than what the prediction asked for
        return u < Real(0) && u * u > noise * noise * (dot(a, a) + dot(b, b));
    }

    static auto inOrder(const ContactName& n) { return std::tuple(n.first, n.second, n.side); }

    bool planApproaching() {
        m_plan.clear();
        const auto& touches = m_cluster.touches();
        for (Index k = 0; k < touches.size(); ++k)
            if (approaches(touches[k]))
                m_plan.push_back(
                    {.touch = k, .restitution = touches[k].restitution, .opening = opening(touches[k])});
        if (!m_ties && m_plan.size() > 1) // the first in the order of the scene
            m_plan = {*std::min_element(m_plan.begin(), m_plan.end(), [&](auto& a, auto& b) {
                return inOrder(touches[a.touch].name) < inOrder(touches[b.touch].name);
            })};
        return !m_plan.empty();
    }
    bool losesEnergy() const {
        return std::any_of(m_plan.begin(), m_plan.end(), [](auto& p) { return p.restitution < Real(1); });
    }

    // Without any bounce the passes to and fro would end where one pass over all contacts ends.
    bool endsAtOnce() const {
        return m_ties && m_cluster.touches().size() > 1 &&
               std::all_of(m_plan.begin(), m_plan.end(), [](auto& p) { return p.restitution == Real(0); });
    }

    // Nor does any bounce where whatever contact takes up the fastest approach would last.
    template <class SlowestRebound> bool allLast(SlowestRebound&& slowestRebound) const {
        const auto& touches = m_cluster.touches();
        if (!Models::friction || !m_ties || touches.size() < 2)
            return false;
        Real approach(0), restitution(0);
        for (const Planned& p : m_plan)
            approach = std::max(approach, Real(-p.opening));
        for (const Touch<Real>& t : touches)
            restitution = std::max(restitution, t.restitution);
        return restitution * approach < slowestRebound(m_velocities);
    }

    std::vector<GroupContact<Real>> plannedContacts() const {
        std::vector<GroupContact<Real>> contacts;
        for (const Planned& p : m_plan) {
            const Touch<Real>& t = m_cluster.touches()[p.touch];
            const Real demand = p.opening < Real(0) ? Real((1 + p.restitution) * p.opening) : p.opening;
            contacts.push_back(
                {t.first, t.name.isWall() ? GroupContact<Real>::wall : t.second, t.normal(), demand});
        }
        return contacts;
    }

    std::vector<Real> inverseMasses() const {
        std::vector<Real> out;
        for (const Index b : m_cluster.bodies())
            out.push_back(1 / m_search.discs().massOf(b));
        return out;
    }

    // All contacts, without bounce.
    void planAll() {
        m_plan.clear();
        const auto& touches = m_cluster.touches();
        for (Index k = 0; k < touches.size(); ++k)
            m_plan.push_back({.touch = k, .opening = opening(touches[k])});
    }

    // The plan's impulses, and m_after.
    void apply() {
        if (m_plan.size() == 1)
            return applyAlone();
        // With friction there are many, and what is symmetric need not be so to the last bit.
        const auto solution = Models::friction ? solveForces<Real>(plannedContacts(), inverseMasses())
                                               : solveContacts<Real>(plannedContacts(), inverseMasses());
        for (Index k = 0; k < m_plan.size(); ++k)
            m_plan[k].impulse = solution.impulse[k];
        m_after = m_velocities;
        for (Index b = 0; b < m_after.size(); ++b)
            m_after[b] = m_after[b] + solution.change[b];
    }

    // One contact is the paper's five steps.
    void applyAlone() {
        const Touch<Real>& t = m_cluster.touches()[m_plan[0].touch];
        m_alone = t.name.isWall() ? collideWithSide<Real>(disc(t.first), t.name.side, m_plan[0].restitution)
                                  : collide<Real>(disc(t.first), disc(t.second), m_plan[0].restitution);
        m_plan[0].impulse = m_alone.impulse;
        m_after = m_velocities;
        m_after[t.first] = m_alone.after.first;
        if (!t.name.isWall())
            m_after[t.second] = m_alone.after.second;
    }

    template <class SlowestRebound> bool stopBouncing(SlowestRebound&& slowestRebound) {
        bool changed = false;
        const Real slowest = slowestRebound(m_after);
        if (!(slowest > Real(0)))
            return false;
        for (Planned& p : m_plan) {
            const Touch<Real>& t = m_cluster.touches()[p.touch];
            if (dot(t.normal(), relativeVelocity(t, m_after)) > slowest)
                continue;
            changed |= p.restitution > Real(0);
            p.restitution = Real(0);
            p.lasts = true;
            p.meets = -p.opening > slowest;
        }
        return changed;
    }

    template <class SlowestRebound> void closeAll(double time, SlowestRebound&& slowestRebound) {
        planAll();
        apply();
        const Real slowest = slowestRebound(m_after);
        for (Planned& p : m_plan) {
            p.lasts = slowest > Real(0);
            p.meets = !p.lasts || -p.opening > slowest;
        }
        shareLoss();
        record(time);
        stopTheRest();
        m_velocities = m_after;
    }

    Real fastest() const {
        using std::abs;
        Real most(0);
        for (const Vec2<Real>& v : m_velocities)
            most = std::max({most, Real(abs(v.x)), Real(abs(v.y))});
        return most;
    }

    // What came to rest but for rounding is at rest.
    void stopTheRest() {
        using std::abs;
        const Real rounding = 16 * std::numeric_limits<Real>::epsilon() * fastest();
        for (Vec2<Real>& v : m_after)
            v = {abs(v.x) > rounding ? v.x : Real(0), abs(v.y) > rounding ? v.y : Real(0)};
    }

    // One contact may do work that another takes up: the loss of the whole pass, by impulse, among those that
    // are written down.
    void shareLoss() {
        Real lost(0), impulses(0);
        for (const Planned& p : m_plan) {
            const Touch<Real>& t = m_cluster.touches()[p.touch];
            lost -= p.impulse * (p.opening + dot(t.normal(), relativeVelocity(t, m_after))) / 2;
            if (isCollision(p))
                impulses += p.impulse;
        }
        for (Planned& p : m_plan)
            p.lossShare = lost > Real(0) && isCollision(p) ? Real(lost * p.impulse / impulses) : Real(0);
    }

    Disc<Real> disc(Index place) const {
        Disc<Real> d = m_search.discs().disc(m_cluster.bodies()[place]);
        d.velocity = m_velocities[place];
        return d;
    }

    // A contact that lasts keeps its two together by impulses without end: those are no collisions.
    bool isCollision(const Planned& p) const {
        const ContactName& name = m_cluster.touches()[p.touch].name;
        const bool held = name.isWall() ? m_around.holdsWall(name.first, name.side)
                                        : m_around.holdsPair(name.first, name.second);
        return p.impulse > Real(0) && p.meets && !(held && p.lasts);
    }

    void record(double time) {
        const auto collisions =
            std::count_if(m_plan.begin(), m_plan.end(), [this](const Planned& p) { return isCollision(p); });
        m_passes += collisions > 1;
        for (const Planned& p : m_plan) {
            if (!isCollision(p))
                continue;
            const ContactName& name = m_cluster.touches()[p.touch].name;
            m_recorder.collision(time, int(name.first), name.isWall() ? -1 : int(name.second), name.side,
                                 m_plan.size() == 1 ? m_alone : inTheGroup(p), collisions > 1 ? m_passes : 0);
        }
    }

    PairCollision<Real> inTheGroup(const Planned& p) const {
        const Touch<Real>& t = m_cluster.touches()[p.touch];
        Disc<Real> second;
        VelocityPair<Real> after{m_after[t.first], {}};
        if (t.name.isWall()) {
            second.mass = std::numeric_limits<Real>::infinity();
            second.position = disc(t.first).position - t.normal() * t.contact.Z;
        } else {
            second = disc(t.second);
            after.second = m_after[t.second];
        }
        auto steps = collideTogether<Real>(disc(t.first), second, t.contact, p.restitution, p.impulse, after);
        steps.momentumResidual = momentumChange();
        if (p.lossShare > Real(0))
            steps.energyLoss = p.lossShare;
        return steps;
    }

    // Of the whole pass; at a wall none is expected to stay.
    Vec2<Real> momentumChange() const {
        Vec2<Real> sum;
        for (const Planned& p : m_plan)
            if (m_cluster.touches()[p.touch].name.isWall())
                return {};
        for (Index b = 0; b < m_after.size(); ++b)
            sum = sum + (m_after[b] - m_velocities[b]) * m_search.discs().massOf(m_cluster.bodies()[b]);
        return sum;
    }

    Search& m_search;
    const Surroundings<Real, Models>& m_around;
    Recorder& m_recorder;
    ContactCluster<Real, Models, Search> m_cluster;
    Velocities m_velocities; // of the cluster's bodies
    Velocities m_after;      // the pass
    std::vector<Planned> m_plan;
    PairCollision<Real> m_alone; // of a pass with one contact
    int m_passes = 0;
    bool m_ties;
};

} // namespace thetalane
