#include "ui/steps/stage_player.h"

#include <QScopedValueRollback>

namespace thetalane {

StagePlayer::StagePlayer(Playhead& playhead, QObject* parent)
    : QObject(parent)
    , m_playhead(playhead) {
    m_timer.setInterval(hold);
    connect(&m_timer, &QTimer::timeout, this, &StagePlayer::goOn);
    // Whoever takes over by hand has taken over.
    connect(&playhead, &Playhead::stageChanged, this, [this] {
        if (!m_stepping)
            setPlaying(false);
    });
    connect(&playhead, &Playhead::selectionChanged, this, [this] { setPlaying(false); });
}

void StagePlayer::setPlaying(bool playing) {
    if (playing == this->playing() || (playing && !m_playhead.selected()))
        return;
    if (!playing) {
        m_timer.stop();
    } else {
        const QScopedValueRollback ours(m_stepping, true);
        if (int(m_playhead.stage()) == stageCount - 1)
            m_playhead.setStage(Stage::Contact);
        m_timer.start();
    }
    emit playingChanged(playing);
}

void StagePlayer::goOn() {
    {
        const QScopedValueRollback ours(m_stepping, true);
        m_playhead.stepStage(1);
    }
    if (int(m_playhead.stage()) == stageCount - 1)
        setPlaying(false);
}

} // namespace thetalane
