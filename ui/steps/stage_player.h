// Plays the stages of the open collision one after the other, each held long enough to be spoken over.
#pragma once

#include "ui/playhead.h"

#include <QObject>
#include <QTimer>

namespace thetalane {

class StagePlayer : public QObject {
    Q_OBJECT
public:
    static constexpr int hold = 3000; // of each stage [ms]

    explicit StagePlayer(Playhead& playhead, QObject* parent = nullptr);

    bool playing() const { return m_timer.isActive(); }
    void setHold(int milliseconds) { m_timer.setInterval(milliseconds); } // for tests

public slots:
    // From the first stage once the last one has been shown. Without an open collision: nothing.
    void setPlaying(bool playing);
    void toggle() { setPlaying(!playing()); }

signals:
    void playingChanged(bool playing);

private:
    void goOn();

    Playhead& m_playhead;
    QTimer m_timer;
    bool m_stepping = false; // the stage changes by us
};

} // namespace thetalane
