// The words of a lesson while another panel is in front of its own: a line over the lane, with the pages to
// turn.
#pragma once

#include "ui/lessons/lesson_player.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace thetalane {

class LessonCaption : public QFrame {
    Q_OBJECT
public:
    LessonCaption(const Context& context, LessonPlayer& player, QWidget* parent = nullptr);

    // The lesson's own panel is seen, and says it all.
    void setPanelInFront(bool inFront);

    void retranslate();

signals:
    void panelWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    void turn();
    void showPage();
    void restyle();

    const Appearance& m_appearance;
    LessonPlayer& m_player;
    QLabel* m_text;
    QPushButton* m_open;
    QPushButton* m_back;
    QPushButton* m_next;
    bool m_panelInFront = true;
};

} // namespace thetalane
