// Play, step by frames and by collisions, choose the rate, and take the run to any time.
#pragma once

#include "ui/panels/panel.h"

class QGridLayout;

namespace thetalane {

class IconButton;
class RateChooser;
class ScrubBar;
class TimeReadout;
class UntilChooser;

class TimelineBar : public Panel {
    Q_OBJECT
public:
    explicit TimelineBar(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeControls();
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
    RateChooser* m_rate = nullptr;
    ScrubBar* m_scrub = nullptr;
    TimeReadout* m_readout = nullptr;
    UntilChooser* m_until = nullptr;
    QGridLayout* m_grid;
    bool m_wide = false;
};

} // namespace thetalane
