#include "ui/lane/lane_scene.h"

#include "ui/lane/body_item.h"
#include "ui/lane/extent.h"
#include "ui/lane/lasting_item.h"
#include "ui/lane/paths_item.h"
#include "ui/lane/scale.h"
#include "ui/lane/velocity_item.h"
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"
#include "ui/words/worked_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

// The colour code needs a collision. Where it is clear who will be first and second, they wear it already.
std::vector<Ink> usualInks(const Scene& scene) {
    std::vector<Ink> inks(scene.bodies.size(), Ink::Plain);
    const auto balls = std::count_if(scene.bodies.begin(), scene.bodies.end(),
                                     [](const Body& b) { return b.kind == BodyKind::Ball; });
    if (scene.bodies.front().kind == BodyKind::Ball && (balls == 1 || scene.bodies.size() == 2))
        inks[0] = Ink::First;
    if (scene.bodies.size() == 2 && balls == 2)
        inks[1] = Ink::Second;
    return inks;
}

double fastest(const Timeline& timeline) {
    double speed = 0;
    for (std::size_t i = 0; i < timeline.bodyCount(); ++i)
        for (const Segment& s : timeline.segments(i))
            speed = std::max(speed, norm(s.velocity));
    return speed;
}

double largestRadius(const Scene& scene) {
    double radius = 0;
    for (const Body& body : scene.bodies)
        radius = std::max(radius, body.radius);
    return radius;
}

} // namespace

LaneScene::LaneScene(const Context& context, QObject* parent)
    : QGraphicsScene(parent)
    , m_context(context)
    , m_paths(new PathsItem(context.appearance))
    , m_velocities(new VelocityItem(context.appearance, m_states))
    , m_lasting(new LastingItem(context.appearance)) {
    setItemIndexMethod(NoIndex); // everything moves in every frame
    addItem(m_paths);
    addItem(m_velocities);
    addItem(m_lasting);
    connect(&context.session, &Session::runChanged, this, &LaneScene::rebuild);
    connect(&context.session, &Session::chapterChanged, this, &LaneScene::showChapter);
    connect(&context.playhead, &Playhead::timeChanged, this, &LaneScene::showTime);
    connect(&context.playhead, &Playhead::selectionChanged, this, &LaneScene::showSelection);
    rebuild();
}

void LaneScene::rebuild() {
    emit touched();
    m_run = m_context.session.run();
    const Scene& scene = m_run->scene;
    const double until = m_context.session.shownUntil();
    m_fit = thetalane::fitRect(*m_run, until);
    m_whole = thetalane::wholeRect(*m_run, until);
    m_hovered.reset();
    qDeleteAll(m_bodies);
    m_bodies.clear();

    m_inks = usualInks(scene);
    const bool pins = std::any_of(scene.bodies.begin(), scene.bodies.end(),
                                  [](const Body& b) { return b.kind == BodyKind::Pin; });
    const bool namesBeside = !pins && scene.bodies.size() <= 30;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        m_bodies.push_back(new BodyItem(scene.bodies[i], m_inks[i], namesBeside, m_context.appearance));
        addItem(m_bodies.back());
    }
    const double speed = fastest(m_run->timeline);
    if (!m_scaleHeld || m_metresPerSpeed == 0)
        m_metresPerSpeed = speed > 0 ? 3 * largestRadius(scene) / speed : 0;
    const double margin = 20 * std::max(m_whole.width(), m_whole.height());
    const QRectF world = m_whole.adjusted(-margin, -margin, margin, margin);
    setSceneRect(world);
    m_velocities->setUp(scene.bodies, m_inks, m_metresPerSpeed, 1e-3 * speed, world);
    showChapter();
    emit rebuilt();
}

void LaneScene::holdScale(bool held) {
    m_scaleHeld = held;
    if (!held)
        rebuild();
}

void LaneScene::hideFuture(bool hidden) {
    emit touched();
    m_paths->setFutureHidden(hidden);
}

// The same bodies on the same floor to the same scale; only what happens is of another part of the run.
void LaneScene::showChapter() {
    emit touched();
    m_run = m_context.session.run();
    m_paths->build(*m_run, std::min(m_context.session.shownUntil(), m_run->timeline.endTime()), m_inks);
    buildTurnings();
    // In a later chapter it is not known what went down before.
    const bool fromTheStart = m_context.session.part().collisionsBefore == 0;
    m_falls = fromTheStart ? fallsOf(*m_run) : std::vector<std::optional<Fall>>(m_bodies.size());
    m_lasting->setUp(*m_run, sceneRect());
    showTime(m_context.playhead.time());
    showSelection();
}

void LaneScene::buildTurnings() {
    constexpr std::size_t most = 60; // more, and each is too small to see how it turns
    const Scene& scene = m_run->scene;
    m_turnings.assign(scene.bodies.size() <= most ? scene.bodies.size() : 0, {});
    for (std::size_t i = 0; i < m_turnings.size(); ++i)
        if (scene.friction && scene.bodies[i].kind == BodyKind::Ball)
            m_turnings[i] = Turning(m_run->timeline.segments(i), m_run->timeline.rotations(i));
}

void LaneScene::showTime(double time) {
    if (m_run != m_context.session.run())
        return; // rebuild() is about to come
    emit touched();
    m_run->timeline.stateAt(time, m_states);
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        m_bodies[i]->setPos(toUnits(m_states[i].position));
        m_bodies[i]->setLost(m_states[i].place != Place::Play);
        if (i < m_turnings.size() && m_turnings[i].isKnown())
            m_bodies[i]->setTurn(m_turnings[i].at(time));
        const auto& fall = m_falls[i];
        if (fall && time >= fall->time)
            m_bodies[i]->setTipped(tipped(*fall, time), fall->along);
        else
            m_bodies[i]->setTipped(std::nullopt, {});
    }
    m_lasting->setTime(time, m_states);
    m_paths->setTime(time, m_states);
    m_velocities->update();
}

void LaneScene::showSelection() {
    if (m_run != m_context.session.run())
        return;
    emit touched();
    const Collision* collision = selected();
    std::vector<bool> beside(m_bodies.size(), false);
    if (collision)
        for (const PassBody& b :
             bodiesOf(passOf(m_run->timeline.collisions(), *m_context.playhead.selected())))
            beside[std::size_t(b.body)] = true;
    for (int i = 0; i < int(m_bodies.size()); ++i) {
        using Role = BodyItem::Role;
        const Role role = !collision               ? Role::Usual
                          : i == collision->first  ? Role::First
                          : i == collision->second ? Role::Second
                          : beside[std::size_t(i)] ? Role::Beside
                                                   : Role::Receding;
        m_bodies[std::size_t(i)]->setRole(role);
    }
    m_paths->setReceding(collision != nullptr);
    m_velocities->setVisible(!collision && m_arrows); // the overlay has its own
}

void LaneScene::setArrows(bool shown) {
    if (shown == m_arrows)
        return;
    emit touched();
    m_arrows = shown;
    m_velocities->setVisible(shown && !selected());
}

const Collision* LaneScene::selected() const {
    const auto index = m_context.playhead.selected();
    return index && m_run == m_context.session.run() ? &m_run->timeline.collisions()[*index] : nullptr;
}

std::optional<int> LaneScene::bodyNear(const QPointF& at, double slack) const {
    std::optional<int> found;
    double least = slack;
    const Vec2d point = toMetres(at);
    for (std::size_t i = 0; i < m_states.size(); ++i) {
        const double gap =
            (norm(m_states[i].position - point) - m_run->scene.bodies[i].radius) * unitsPerMetre;
        if (gap <= least) {
            least = gap;
            found = int(i);
        }
    }
    return found;
}

void LaneScene::setHovered(std::optional<int> body) {
    if (body == m_hovered)
        return;
    emit touched();
    if (m_hovered)
        m_bodies[std::size_t(*m_hovered)]->setHovered(false);
    m_hovered = body;
    if (m_hovered)
        m_bodies[std::size_t(*m_hovered)]->setHovered(true);
}

QString LaneScene::bodyTip(int body) const {
    const Body& b = m_run->scene.bodies[std::size_t(body)];
    QStringList lines{bodyName(b), tr("Mass %1 kg").arg(numberText(b.mass))};
    lines << motionOf(body);
    if (nextCollisionOf(body))
        lines << tr("Click: open its next collision");
    return lines.join('\n');
}

QStringList LaneScene::motionOf(int body) const {
    const BodyState& state = m_states[std::size_t(body)];
    const Vec2d v = state.velocity;
    const double speed = norm(v);
    QStringList lines;
    if (speed > 0) {
        lines << tr("Speed %1 m/s").arg(numberText(speed));
        lines << tr("Direction %1° from the x axis")
                     .arg(numberText(std::atan2(v.y, v.x) * 180 / std::numbers::pi));
    } else {
        lines << tr("At rest");
    }
    if (m_run->scene.friction && state.place == Place::Play && state.phase != FloorPhase::Rest)
        lines << (state.phase == FloorPhase::Rolling ? tr("It rolls") : tr("It slides"));
    const Spin<double>& w = state.spin;
    const double spin = std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
    if (spin > 0)
        lines << tr("Turns at %1 rad/s, %2 rpm")
                     .arg(numberText(spin), numberText(spin * 30 / std::numbers::pi));
    for (const LastingContact& c : lastingAt(m_run->timeline.lastingContacts(), m_context.playhead.time())) {
        if (c.first == body)
            lines << tr("Stays pressed against %1")
                         .arg(c.second < 0 ? sideName(c.side) : bodyName(m_run->scene, c.second));
        else if (c.second == body)
            lines << tr("Stays pressed against %1").arg(bodyName(m_run->scene, c.first));
    }
    return lines;
}

std::optional<std::size_t> LaneScene::nextCollisionOf(int body) const {
    const auto collisions = m_run->timeline.collisions();
    const Collision* open = selected();
    std::size_t from = 0;
    if (open && open->involves(body))
        from = *m_context.playhead.selected() + 1;
    else if (const auto before = m_run->timeline.collisionBefore(m_context.playhead.time()))
        from = *before + 1;
    for (std::size_t i = from; i < collisions.size(); ++i)
        if (collisions[i].involves(body))
            return i;
    return std::nullopt;
}

} // namespace thetalane
