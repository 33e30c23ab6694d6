// The bowling game beside the lane: before one, who plays and how; while one is on, whose turn it is.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QStackedWidget;

namespace thetalane {

class NewGamePage;
class PlayPage;

class GamePanel : public Panel {
    Q_OBJECT
public:
    GamePanel(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void adopt();

    Alley& m_alley;
    NewGamePage* m_before;
    PlayPage* m_during;
    QStackedWidget* m_pages;
};

} // namespace thetalane
