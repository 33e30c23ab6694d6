#include "ui/words/instant.h"

#include "ui/words/worked_steps.h"

#include <QCoreApplication>

#include <algorithm>

namespace thetalane {
namespace {

// How far the neighbours of `index` agree with it, as [begin, end).
template <class Same>
std::pair<std::size_t, std::size_t> rangeOf(std::span<const Collision> all, std::size_t index, Same&& same) {
    std::size_t begin = index, end = index + 1;
    while (begin > 0 && same(all[begin - 1]))
        --begin;
    while (end < all.size() && same(all[end]))
        ++end;
    return {begin, end};
}

} // namespace

Instant instantOf(std::span<const Collision> all, std::size_t index) {
    const Collision& c = all[index];
    if (c.group == 0)
        return {index, 1, index, 1, 1, 1};
    const auto [begin, end] = rangeOf(all, index, [&](const Collision& o) { return o.group == c.group; });
    const auto [passBegin, passEnd] =
        rangeOf(all, index, [&](const Collision& o) { return o.group == c.group && o.pass == c.pass; });
    return {begin, end - begin, passBegin, passEnd - passBegin, c.pass, all[end - 1].pass};
}

std::span<const Collision> passOf(std::span<const Collision> all, std::size_t index) {
    const Instant instant = instantOf(all, index);
    return all.subspan(instant.passBegin, instant.passSize);
}

std::vector<PassBody> bodiesOf(std::span<const Collision> pass) {
    std::vector<PassBody> bodies;
    const auto take = [&](int body, const Disc<double>& disc, const Vec2d& before, const Vec2d& after) {
        if (std::none_of(bodies.begin(), bodies.end(), [&](const PassBody& b) { return b.body == body; }))
            bodies.push_back({body, disc.mass, before, after});
    };
    for (const Collision& c : pass) {
        take(c.first, c.steps.first, c.steps.before.first, c.steps.after.first);
        if (!c.isWall())
            take(c.second, c.steps.second, c.steps.before.second, c.steps.after.second);
    }
    return bodies;
}

QString instantText(const Instant& i, std::size_t index) {
    if (i.size < 2)
        return {};
    const QString which = QCoreApplication::translate("Instant", "Contact %1 of %2 at this instant")
                              .arg(index - i.begin + 1)
                              .arg(i.size);
    const QString pass =
        i.passSize > 1
            ? QCoreApplication::translate("Instant", "pass %1 of %2: %n contacts resolved together", nullptr,
                                          int(i.passSize))
            : QCoreApplication::translate("Instant", "pass %1 of %2, one pass after another");
    return which + QStringLiteral(" · ") + pass.arg(i.pass).arg(i.passes);
}

QString instantQuestion(const Instant& i) {
    return i.passSize > 1 ? QCoreApplication::translate("Instant", "Why together?")
                          : QCoreApplication::translate("Instant", "Why one after another?");
}

QString instantRule(const Instant& i, const EngineSettings& engine) {
    if (engine.kind == EngineKind::Swept || (engine.kind == EngineKind::Event && !engine.ties))
        return QCoreApplication::translate(
            "Instant", "Here contacts of one instant are exchanged one at a time, in the order of the list. "
                       "The outcome depends on that order, and what is symmetric does not stay so; the exact "
                       "way resolves such contacts together.");
    if (engine.kind == EngineKind::Stepped)
        return QCoreApplication::translate(
            "Instant", "The paper's loop goes through the pairs at every step and exchanges each that "
                       "overlaps by itself, in the order of the list. The outcome depends on that order, and "
                       "what is symmetric does not stay so; the exact way resolves such contacts "
                       "together.");
    if (i.passSize > 1)
        return QCoreApplication::translate(
            "Instant",
            "All contacts at one instant whose bodies approach are resolved together, in one pass: each gets "
            "an impulse that can only push, and parts its two bodies with e times the speed at which they "
            "met, unless the other impulses part them faster still. Taken one by one, the outcome would "
            "depend on the order, and what is symmetric would not stay so. Passes repeat until no two bodies "
            "approach; the energy never rises.");
    return QCoreApplication::translate(
        "Instant",
        "Only contacts whose bodies approach are resolved, and here that was one at a time: it set the next "
        "two bodies approaching, and so the impulse is passed on along the chain. Passes repeat until no two "
        "bodies approach; the energy never rises.");
}

QString contactName(const Scene& scene, const Collision& c) {
    return bodyName(scene, c.first) + QStringLiteral(" → ") + partnerName(scene, c);
}

} // namespace thetalane
