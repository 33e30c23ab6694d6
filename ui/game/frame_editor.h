// A frame put right by hand, in a card beside it: as it is written, or pin by pin. Not modal; Esc closes it.
#pragma once

#include "ui/game/alley.h"
#include "ui/game/frame_draft.h"
#include "ui/panels/panel.h"

#include <array>

class QLabel;
class QLineEdit;
class QPushButton;

namespace thetalane {

class PinDeck;

class FrameEditor : public Panel {
    Q_OBJECT
public:
    FrameEditor(const Context& context, Alley& alley, QWidget* window);

    // Of a frame that was played, from 1; `place`: the frame's, in the coordinates of the window.
    void edit(std::size_t player, int frame, const QRect& place);

    void retranslate() override;

protected:
    void restyle() override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    static constexpr int mostBalls = 3;

    void build();
    void follow(); // the game changed: what is edited may be gone
    void readText();
    void toggle(int ball, int pin);
    void showDraft();
    void showMessage();
    void place();
    void apply();

    Alley& m_alley;
    QLabel* m_title;
    QLineEdit* m_rolls;
    QLabel* m_hint;
    std::array<QLabel*, mostBalls> m_names{};
    std::array<PinDeck*, mostBalls> m_decks{};
    QLabel* m_message;
    QPushButton* m_apply;
    QPushButton* m_cancel;
    std::size_t m_player = 0;
    int m_frame = 1;
    QRect m_place;
    FrameDraft m_draft;
    std::vector<PlayedDelivery> m_before; // of the player, as it was when the editor opened
    std::optional<RollError> m_unreadable;
    std::optional<GameError> m_refused;
};

} // namespace thetalane
