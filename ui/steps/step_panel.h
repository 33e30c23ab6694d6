// A collision opened: which one it is, and its six steps, one of them unfolded.
#pragma once

#include "ui/context.h"
#include "ui/steps/instant_note.h"
#include "ui/steps/stage_player.h"
#include "ui/steps/step_card.h"
#include "ui/steps/trust.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>

#include <array>

namespace thetalane {

class StepPanel : public QWidget {
    Q_OBJECT
public:
    explicit StepPanel(const Context& context, QWidget* parent = nullptr);

    void retranslate();

    StagePlayer& player() { return m_player; }

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent*) override;

private:
    QWidget* makeHead();
    QWidget* makeCards();
    QWidget* makeInvitation();
    void showSelection();
    void invite(bool anyCollision);
    void showStage();
    void showHead(const Collision& collision);
    void showPlace();
    void showPlaying();
    void arrangeCards();
    void applyAppearance();

    Session& m_session;
    Playhead& m_playhead;
    Appearance& m_appearance;
    QStackedWidget* m_pages;
    QLabel* m_title = nullptr;
    QLabel* m_partners = nullptr;
    InstantNote* m_instant = nullptr;
    Trust m_trust;
    StagePlayer m_player;
    QToolButton* m_play = nullptr;
    QToolButton* m_previous = nullptr;
    QToolButton* m_next = nullptr;
    QScrollArea* m_scroll = nullptr;
    std::array<StepCard*, stageCount> m_cards{};
    QLabel* m_invitation = nullptr;
    QLabel* m_hint = nullptr;
    QPushButton* m_go = nullptr;
};

} // namespace thetalane
