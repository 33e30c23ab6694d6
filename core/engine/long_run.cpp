#include "core/engine/long_run.h"

#include <algorithm>

namespace thetalane {
namespace {

EngineSettings withDetail(EngineSettings settings, bool detail) {
    settings.keepDetail = detail;
    return settings;
}

// A disc with its next events, its share of the cells, and where its stretch began.
constexpr std::size_t bytesOfBody = 256;

} // namespace

LongRun::LongRun(Scene scene, const EngineSettings& settings, const Limits& limits)
    : m_scene(std::move(scene))
    , m_settings(settings)
    , m_limits(limits)
    , m_mostSnapshots(
          std::max<std::size_t>(8, limits.snapshotBytes / (bytesOfBody * (m_scene.bodies.size() + 16))))
    , m_front(startNextEvent(m_scene, withDetail(settings, false)))
    , m_starts(1) {
    keepSnapshot();
}

bool LongRun::goOn() {
    if (m_end)
        return false;
    m_end = m_front->goOn(m_limits.chapter, m_settings.maxCollisions - collisionCount());
    const std::int64_t collisions = m_front->collisionCount();
    if (m_end) {
        m_starts.push_back({m_front->finish().endTime(), collisions});
        m_front.reset();
    } else {
        m_starts.push_back({m_front->nextContact(), collisions});
        keepSnapshot();
    }
    return true;
}

void LongRun::computeTo(double t) {
    while (computedTo() <= t && goOn()) {
    }
}

// When there are too many, every second one goes: then it takes longer to a chapter, up to twice as long.
void LongRun::keepSnapshot() {
    const std::size_t at = m_starts.size() - 1;
    if (at % m_every != 0)
        return;
    if (m_snapshots.size() >= m_mostSnapshots) {
        for (std::size_t k = 1; 2 * k < m_snapshots.size(); ++k)
            m_snapshots[k] = std::move(m_snapshots[2 * k]);
        m_snapshots.resize((m_snapshots.size() + 1) / 2);
        m_every *= 2;
        if (at % m_every != 0)
            return;
    }
    m_snapshots.push_back(m_front->snapshot());
}

std::shared_ptr<const Chapter> LongRun::chapterAt(double t) {
    computeTo(t);
    const auto after = std::upper_bound(m_starts.begin() + 1, m_starts.end() - 1, t,
                                        [](double time, const Start& s) { return time < s.time; });
    return chapter(std::size_t(after - m_starts.begin()) - 1);
}

std::shared_ptr<const Chapter> LongRun::chapterOfCollision(std::int64_t number) {
    while (collisionCount() < number && goOn()) {
    }
    if (chapterCount() == 0)
        goOn();
    const auto after = std::lower_bound(m_starts.begin() + 1, m_starts.end() - 1, number,
                                        [](const Start& s, std::int64_t n) { return s.collisions < n; });
    return chapter(std::size_t(after - m_starts.begin()) - 1);
}

std::shared_ptr<const Chapter> LongRun::chapter(std::size_t index) {
    const auto kept =
        std::find_if(m_kept.begin(), m_kept.end(), [&](const auto& c) { return c->index == index; });
    if (kept != m_kept.end()) {
        std::rotate(kept, kept + 1, m_kept.end());
        return m_kept.back();
    }
    // First out, then in: there is never one too many.
    if (m_kept.size() >= std::max<std::size_t>(1, m_limits.chaptersKept))
        m_kept.erase(m_kept.begin());
    m_kept.push_back(computeAgain(index));
    return m_kept.back();
}

std::shared_ptr<const Chapter> LongRun::computeAgain(std::size_t index) const {
    const std::size_t near = index / m_every;
    const EngineSettings summary = withDetail(m_settings, false), detailed = withDetail(m_settings, true);
    const Start &start = m_starts[index], &end = m_starts[index + 1];
    const std::int64_t most = m_settings.maxCollisions;
    std::unique_ptr<EngineInSteps> engine;
    if (near * m_every == index) {
        engine = m_snapshots[near]->resume(m_scene, detailed);
    } else {
        const std::int64_t before = m_starts[near * m_every].collisions;
        const auto there = m_snapshots[near]->resume(m_scene, summary);
        there->goOn(start.collisions - before, most - before);
        engine = there->snapshot()->resume(m_scene, detailed);
    }
    engine->goOn(end.collisions - start.collisions, most - start.collisions);
    auto chapter = std::make_shared<Chapter>();
    chapter->scene = m_scene;
    chapter->settings = m_settings;
    chapter->index = index;
    chapter->from = start.time;
    chapter->collisionsBefore = start.collisions;
    chapter->last = m_end && index + 1 == chapterCount();
    chapter->timeline = engine->finish();
    chapter->to = chapter->timeline.endTime();
    return chapter;
}

} // namespace thetalane
