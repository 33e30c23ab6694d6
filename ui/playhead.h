// Where we are in the run: the time, how fast it goes, the collision that is open, and its stage.
#pragma once

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
    std::optional<std::size_t> selected() const { return m_selected; } // index into Timeline::collisions()
    Stage stage() const { return m_stage; }

    // One frame of the screen at the present rate: slow motion steps finer [s].
    double frame() const { return m_rate / 60; }

public slots:
    void setTime(double time); // lets go of the selected collision
    void setPlaying(bool playing);
    void togglePlaying() { setPlaying(!playing()); }
    void setRate(double rate);
    void stepFrames(int frames);        // forward or back
    void stepCollisions(int forward);   // +1: the next collision, -1: the one before; selects it
    void select(std::size_t collision); // stops, goes to it, opens it
    void clearSelection();
    void setStage(thetalane::Stage stage);
    void stepStage(int forward);

    void advance(double seconds); // what the clock does while playing; for tests and for pictures

signals:
    void timeChanged(double time);
    void playingChanged(bool playing);
    void rateChanged(double rate);
    void selectionChanged(); // selected() says which, if any
    void stageChanged(thetalane::Stage stage);

private:
    void moveTo(double time);
    void startAgain();

    Session& m_session;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_time = 0;
    double m_rate = 1;
    std::optional<std::size_t> m_selected;
    Stage m_stage = Stage::Contact;
};

} // namespace thetalane
