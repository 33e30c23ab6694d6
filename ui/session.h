// What is being looked at: the scene, the engine, and the run that came of them. Panels ask for changes here
// and receive an immutable Run: of a run too long to be kept whole, the present chapter.
#pragma once

#include "core/bowling/game.h"
#include "core/engine/engine.h"
#include "core/scene/validation.h"
#include "ui/run_ahead.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace thetalane {

// Which part of the whole run the present chapter is; of a run kept whole, all of it.
struct RunPart {
    double from = 0;                   // s
    double to = 0;                     // s
    std::int64_t collisionsBefore = 0; // index k of the chapter's collisions has the number before + k + 1
    bool last = true;                  // nothing comes after it
    std::int64_t collisionCount = 0;   // of the whole run, so far
    double computedTo = 0;             // s
    bool ended = true;                 // all of it is computed

    bool isWhole() const { return collisionsBefore == 0 && last; }
};

// What the run is of, as a value: what an edit changes, and what undoing it brings back.
struct Subject {
    Scene scene;
    QString sceneId; // the built-in id, or empty for a scene of the user's own or an edited one
    std::optional<Throw> ballThrow{}; // that made a lane scene
    PinSet standing = allPins;        // which it was thrown at

    friend bool operator==(const Subject&, const Subject&) = default;
};

// How far a throw is shown before it is thrown: to the first thing it touches, or to the end.
enum class Foresight { Whole, FirstContact };

class Session : public QObject {
    Q_OBJECT
public:
    struct Limits {
        // Small chapters and many snapshots: it takes tens of milliseconds to any of them.
        LongRun::Limits chapters{.chapter = 12'500, .snapshotBytes = std::size_t(128) << 20};
        std::int64_t mostInChapters = 1'000'000'000; // collisions, of the exact engine
        std::int64_t mostWhole = 125'000;            // collisions, of other engines: all kept, about 60 MB
        int patience = 300;                          // for a chapter that is computed again [ms]
    };

    explicit Session(QObject* parent = nullptr);
    explicit Session(const Limits& limits, QObject* parent = nullptr);

    // Never null: a session starts with the two balls of the paper. The present chapter's.
    std::shared_ptr<const Run> run() const { return m_chapter; }
    const Scene& scene() const { return m_chapter->scene; }
    const Timeline& timeline() const { return m_chapter->timeline; }
    RunPart part() const;

    // The built-in id, or empty for a scene of the user's own or an edited one.
    QString sceneId() const { return m_subject.sceneId; }
    const Subject& subject() const { return m_subject; }

    // How much of the run is worth showing [s]: to the end in a closed frame, a little beyond the last
    // collision where the bodies then only fly apart. While it is not known: as long as the run may be.
    double shownUntil() const { return m_shownUntil; }
    // How far it can be shown now [s].
    double reach() const;

    // The throw that made a lane scene; nothing for other scenes.
    const std::optional<Throw>& currentThrow() const { return m_subject.ballThrow; }
    const PinSet& standing() const { return m_subject.standing; } // what it is thrown at
    LaneConditions laneConditions() const;                        // the scene's

    // Each returns what is wrong, and then the last good scene stays; empty when done.
    std::vector<SceneError> setScene(const Scene& scene);
    // At the pins and on the floor of now, if a throw made the scene; else at ten pins on the house lane.
    std::vector<SceneError> setThrow(const Throw& ballThrow, double restitution);
    std::vector<SceneError> setDelivery(const Throw& ballThrow, const PinSet& standing,
                                        const LaneConditions& lane);
    void restore(const Subject& subject); // one that was here before
    // Of throws alone; other scenes are always shown whole.
    void setForesight(Foresight foresight);
    // While it is held, a game has the say, and what others wish waits.
    void holdForesight(std::optional<Foresight> foresight);
    Foresight foresight() const { return m_foresight; }
    std::optional<Refusal> setEngine(const EngineSettings& settings); // but for how much is kept
    std::optional<Refusal> setUntil(double until);                    // [s]
    double until() const { return m_settings.until; }
    bool isLimitedByUntil() const; // the run would go on

    bool openBuiltin(const QString& id);              // false: there is none of that name
    std::vector<SceneError> open(const Scene& scene); // a scene of the user's own
    std::vector<SceneError> openDelivery(const Throw& ballThrow, const PinSet& standing,
                                         const LaneConditions& lane); // one turn of a game
    void reset();                                     // as it was opened

    // The chapter of a place of the run; null if it is not computed, or takes longer than `patience` [ms]:
    // then progressed() says when to ask again. The playhead chooses which one is shown.
    std::shared_ptr<const Chapter> chapter(const RunAhead::Place& place, int patience);
    std::shared_ptr<const Chapter> chapter(const RunAhead::Place& place) {
        return chapter(place, patience());
    }
    int patience() const { return m_limits.patience; }
    void showChapter(std::shared_ptr<const Chapter> chapter);
    void expectTime(double time); // it will be asked for soon
    void waitFor(const RunAhead::Place& place);

signals:
    // The scene or the engine changed, and so did everything that happens.
    void runChanged(std::shared_ptr<const thetalane::Run> run);
    // The same run, another chapter of it.
    void chapterChanged(std::shared_ptr<const thetalane::Run> run);
    // After runChanged(): the scene was edited, and was this before; or another one was opened (or reset).
    void edited(const thetalane::Subject& before);
    void opened();
    // More of it is computed, or a chapter that was asked for may have been found.
    void progressed();

private:
    void start(Subject subject);
    void edit(Subject subject);
    void begin();
    void foresee();
    void adopt(Run whole);
    void adoptFirst(std::shared_ptr<const Chapter> chapter, std::unique_ptr<LongRun> rest);
    void takeProgress();
    double worthShowing() const;

    Limits m_limits;
    std::shared_ptr<const Chapter> m_chapter;
    std::unique_ptr<RunAhead> m_ahead; // of a run in chapters
    RunAhead::Progress m_progress;
    QTimer m_look;          // while there may be news of it
    bool m_awaited = false; // a chapter that is not there yet
    EngineSettings m_settings;
    Subject m_subject;
    Subject m_opened; // what reset() goes back to
    Foresight m_foresight = Foresight::Whole; // what is shown: what is held, else what is wished
    Foresight m_wishedForesight = Foresight::Whole;
    std::optional<Foresight> m_heldForesight;
    double m_shownUntil = 0;
};

} // namespace thetalane
