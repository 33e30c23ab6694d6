// Where we are in the run: the time, how fast it goes, the collision that is open, and its stage. It chooses
// the chapter that the session shows.
#pragma once

#include "ui/run_ahead.h"
#include "ui/words/worked_steps.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <array>
#include <optional>

namespace thetalane {

class Session;

class Playhead : public QObject {
    Q_OBJECT
public:
    static constexpr std::array rates{1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0, 4.0};

    explicit Playhead(Session& session, QObject* parent = nullptr);

    double time() const { return m_time; } // [s]
    double end() const;                    // [s]
    bool playing() const { return m_timer.isActive(); }
    double rate() const { return m_rate; }
    // While playing, the pins' first contact slows time down from a little before it to a little after.
    static constexpr double impactRate = 1.0 / 16;
    bool slowAtImpact() const { return m_slowAtImpact; }
    double rateNow() const; // at the present time
    Stage stage() const { return m_stage; }

    // The open collision: its index in the present chapter's Timeline::collisions(), and its number in the
    // whole run, from 1.
    std::optional<std::size_t> selected() const;
    std::optional<std::int64_t> selectedNumber() const { return m_selected; }
    bool canStepCollisions(int forward) const;

    // One frame of the screen at the present rate: slow motion steps finer [s].
    double frame() const { return m_rate / 60; }

public slots:
    // Lets go of the selected collision. What is not computed yet is gone to when it is, and meanwhile as far
    // as can be.
    void setTime(double time);
    void setPlaying(bool playing);
    void togglePlaying() { setPlaying(!playing()); }
    void setRate(double rate);
    void setSlowAtImpact(bool on);
    void stepFrames(int frames);               // forward or back
    void stepCollisions(int forward);          // +1: the next collision, -1: the one before; selects it
    void select(std::size_t collision);        // of the present chapter: stops, goes to it, opens it
    void selectNumber(std::int64_t collision); // of the whole run, from 1
    void selectBeyond(int body);               // its first one after the present chapter
    void clearSelection();
    void setStage(thetalane::Stage stage);
    void stepStage(int forward);
    void runUntil(double until); // [s] a longer run, or a shorter one; stays where it is in it

    void advance(double seconds); // what the clock does while playing; for tests and for pictures

signals:
    void timeChanged(double time);
    void playingChanged(bool playing);
    void rateChanged(double rate);
    void slowAtImpactChanged(bool on);
    void selectionChanged(); // selected() says which, if any
    void stageChanged(thetalane::Stage stage);

private:
    struct Impact {
        double from = 0; // s
        double to = 0;
    };
    double later(double seconds) const; // the time after so much of the clock
    void findImpact();
    void showWhole();
    void goTo(double time, int patience);
    void open(std::int64_t number, Stage stage, int patience);
    void put(std::shared_ptr<const Chapter> chapter, double time);
    std::optional<std::int64_t> neighbour(int forward) const;
    void startAgain();
    void followProgress();

    Session& m_session;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_time = 0;
    double m_rate = 1;
    bool m_slowAtImpact = false;
    std::optional<Impact> m_impact; // of the run
    std::optional<std::int64_t> m_selected;
    Stage m_stage = Stage::Contact;
    std::optional<RunAhead::Place> m_wish; // where to go as soon as that can be shown
    Stage m_wishedStage = Stage::Contact;  // of a collision
};

} // namespace thetalane
