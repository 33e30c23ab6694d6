// What is being looked at: the scene, the engine, and the run that came of them. Panels ask for changes here
// and receive an immutable Run.
#pragma once

#include "core/engine/engine.h"
#include "core/scene/bowling_scene.h"
#include "core/scene/validation.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace thetalane {

class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);

    // Never null: a session starts with the two balls of the paper.
    std::shared_ptr<const Run> run() const { return m_run; }
    const Scene& scene() const { return m_run->scene; }
    const Timeline& timeline() const { return m_run->timeline; }

    // The built-in id, or empty for a scene of the user's own or an edited one.
    QString sceneId() const { return m_sceneId; }

    // How much of the timeline is worth showing [s]: to the end in a closed frame, a little beyond the last
    // collision where the bodies then only fly apart.
    double shownUntil() const { return m_shownUntil; }

    // The throw that made a lane scene; nothing for other scenes.
    const std::optional<Throw>& currentThrow() const { return m_throw; }

    // Each returns what is wrong, and then the last good scene stays; empty when done.
    std::vector<SceneError> setScene(const Scene& scene);
    std::vector<SceneError> setThrow(const Throw& ballThrow, double restitution);
    std::optional<Refusal> setEngine(const EngineSettings& settings);

    bool openBuiltin(const QString& id);              // false: there is none of that name
    std::vector<SceneError> open(const Scene& scene); // a scene of the user's own
    void reset();                                     // as it was opened

signals:
    // The scene or the engine changed, and so did everything that happens.
    void runChanged(std::shared_ptr<const thetalane::Run> run);

private:
    void start(Scene scene, const QString& id, std::optional<Throw> ballThrow);
    void adopt(Run run);

    std::shared_ptr<const Run> m_run;
    EngineSettings m_settings;
    QString m_sceneId;
    Scene m_opened; // what reset() goes back to
    QString m_openedId;
    std::optional<Throw> m_throw;
    std::optional<Throw> m_openedThrow;
    double m_shownUntil = 0;
};

} // namespace thetalane
