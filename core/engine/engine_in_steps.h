// A next-event run that pauses between events, can be copied there, and goes on from the copy bit for bit.
#pragma once

#include "core/engine/engines.h"

#include <memory>
#include <optional>

namespace thetalane {

class EngineInSteps;

// Where a run was when it paused, without what it had written down.
class EngineSnapshot {
public:
    virtual ~EngineSnapshot() = default;
    // `scene` and `settings` are those of the run; keepDetail may differ. What is written down begins with
    // the bodies' present stretches of motion, which may have begun before.
    virtual std::unique_ptr<EngineInSteps> resume(const Scene& scene,
                                                  const EngineSettings& settings) const = 0;
};

class EngineInSteps {
public:
    virtual ~EngineInSteps() = default;

    // Until `collisions` more have happened, or a few more, as no instant is divided; then nothing is
    // returned. Or until the run ends, at the latest when `most` more have happened.
    virtual std::optional<EndReason> goOn(std::int64_t collisions, std::int64_t most) = 0;

    // Since it began or was resumed.
    virtual std::int64_t collisionCount() const = 0;
    // Of the contact before which it paused: until then all is known [s].
    virtual double nextContact() const = 0;

    virtual std::unique_ptr<const EngineSnapshot> snapshot() const = 0;
    // What was written down; nothing must be asked of the engine afterwards.
    virtual Timeline finish() = 0;
};

// `settings.kind` is EngineKind::Event.
std::unique_ptr<EngineInSteps> startNextEvent(const Scene& scene, const EngineSettings& settings,
                                              SearchKind search = SearchKind::ByCount);
std::unique_ptr<EngineInSteps> startNextEventQuad(const Scene& scene, const EngineSettings& settings);

// Engine: a NextEventEngine.
template <class Engine> class NextEventInSteps final : public EngineInSteps {
public:
    NextEventInSteps(const Scene& scene, const EngineSettings& settings)
        : m_engine(scene, settings) {
        m_engine.begin();
    }
    NextEventInSteps(const Scene& scene, const EngineSettings& settings, const typename Engine::State& state)
        : m_engine(scene, settings, state) {
        m_engine.resume();
    }

    std::optional<EndReason> goOn(std::int64_t collisions, std::int64_t most) override {
        const std::int64_t before = m_engine.collisionCount();
        bool paused = false;
        m_reason = m_engine.goOn([&](const auto& time) {
            m_nextContact = m_engine.absolute(time);
            const std::int64_t happened = m_engine.collisionCount() - before;
            paused = happened < most && happened >= collisions && m_nextContact > m_engine.now();
            return paused || happened >= most;
        });
        m_paused = paused;
        return paused ? std::nullopt : std::optional(m_reason);
    }
    std::int64_t collisionCount() const override { return m_engine.collisionCount(); }
    double nextContact() const override { return m_nextContact; }

    std::unique_ptr<const EngineSnapshot> snapshot() const override {
        return std::make_unique<Snapshot>(m_engine.state());
    }
    Timeline finish() override {
        return m_paused ? m_engine.finish(m_reason, m_nextContact) : m_engine.finish(m_reason);
    }

private:
    class Snapshot final : public EngineSnapshot {
    public:
        explicit Snapshot(const typename Engine::State& state)
            : m_state(state) {}
        std::unique_ptr<EngineInSteps> resume(const Scene& scene,
                                              const EngineSettings& settings) const override {
            return std::make_unique<NextEventInSteps>(scene, settings, m_state);
        }

    private:
        typename Engine::State m_state;
    };

    Engine m_engine;
    EndReason m_reason = EndReason::Until;
    double m_nextContact = 0;
    bool m_paused = false;
};

} // namespace thetalane
