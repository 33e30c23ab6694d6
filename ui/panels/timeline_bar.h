// Play, step by frames and by collisions, choose the rate, and take the run to any time.
#pragma once

#include "ui/panels/panel.h"

class QGridLayout;

namespace thetalane {

class IconButton;
class ScrubBar;
class SlowMotionButton;
class TimeReadout;
class UntilChooser;

class TimelineBar : public Panel {
    Q_OBJECT
public:
    explicit TimelineBar(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;
    void hideFuture(bool hidden); // where the next collisions are
    // As the user left them: slow motion at impact.
    void restoreChoices();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeControls();
    void makeRate(const Context& context);
    void showPins();
    void arrange();
    void showPlaying();
    void showReachable();
    int timesWidth() const; // of the present time and the end

    QWidget* m_controls;
    IconButton* m_start = nullptr;
    IconButton* m_collisionBack = nullptr;
    IconButton* m_frameBack = nullptr;
    IconButton* m_play = nullptr;
    IconButton* m_frameForward = nullptr;
    IconButton* m_collisionForward = nullptr;
    QWidget* m_rate = nullptr; // how fast, and whether slower at impact
    SlowMotionButton* m_slow = nullptr;
    ScrubBar* m_scrub = nullptr;
    TimeReadout* m_readout = nullptr;
    UntilChooser* m_until = nullptr;
    QGridLayout* m_grid;
    bool m_wide = false;
};

} // namespace thetalane
