// The score sheet of the game that is on, over the lane: up to four rows at once, more by scrolling. Enter
// goes on with the game wherever no field wants the key.
#pragma once

#include "ui/game/alley.h"
#include "ui/panels/panel.h"

class QScrollArea;
class QShortcut;

namespace thetalane {

class FrameEditor;
class ScoreTable;

// No room is taken while no game is on.
class ScoreSheet : public Panel {
    Q_OBJECT
public:
    ScoreSheet(const Context& context, Alley& alley, QWidget* parent = nullptr);

    void retranslate() override;

    // Opens the correction of a frame beside it; frame from 1.
    void correct(std::size_t player, int frame);

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void addShortcuts();
    void adopt();
    void fit();
    void bringIntoView(const QRectF& frame);
    void bringTurnIntoView();

    Context m_context;
    Alley& m_alley;
    QScrollArea* m_scroll;
    ScoreTable* m_table;
    FrameEditor* m_editor = nullptr; // stands over the lane, so it is the window's
};

} // namespace thetalane
