// Lessons: the shelf to choose from, and the one that is given, in letters for the back row. Page Up and Page
// Down turn its pages wherever the focus is, as a presenter's clicker does.
#pragma once

#include "ui/lessons/lesson_player.h"
#include "ui/panels/panel.h"

#include <functional>

class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace thetalane {

class BigText;
class CardButton;
class ProgressDots;
class QuestionView;

class LessonPanel : public Panel {
    Q_OBJECT
public:
    explicit LessonPanel(const Context& context, QWidget* parent = nullptr);

    LessonPlayer& player() { return *m_player; }
    bool isShelf() const;

    // Asked before a lesson opens its scene over the present one; false: it does not start. Always, unless
    // set.
    void setMayOpen(std::function<bool()> mayOpen) { m_mayOpen = std::move(mayOpen); }

    // A teacher's own; what is wrong with it is said on the shelf.
    bool openFile(const QString& path);
    void giveLesson(int index); // of the built-in ones

    void retranslate() override;

signals:
    // What else a stop brings to the front; the window knows where that is.
    void showRequested(thetalane::LessonShow what);
    void running(bool isRunning);
    void asking(bool isOpen); // while true, others had better not tell the answer

protected:
    void restyle() override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* makeShelf();
    QWidget* makeLesson(const Context& context);
    void makeShortcuts();
    bool asks() const; // a question that is not revealed
    void goOn();
    void give(const Lesson& lesson);
    void showPage();
    void showShelf();
    void chooseFile();
    void showError();

    LessonPlayer* m_player;
    std::function<bool()> m_mayOpen;
    std::function<QString()> m_error; // in the language of now; empty: nothing is wrong
    QStackedWidget* m_stack;
    QScrollArea* m_shelf = nullptr;
    QVBoxLayout* m_shelfColumn = nullptr;
    QLabel* m_heading = nullptr;
    QLabel* m_message = nullptr;
    std::vector<CardButton*> m_cards;
    QPushButton* m_openFile = nullptr;
    QWidget* m_lesson = nullptr;
    QVBoxLayout* m_lessonColumn = nullptr;
    QPushButton* m_leave = nullptr;
    QLabel* m_title = nullptr;
    ProgressDots* m_dots = nullptr;
    QStackedWidget* m_body = nullptr;
    BigText* m_text = nullptr;
    QuestionView* m_question = nullptr;
    QWidget* m_changed = nullptr;
    QLabel* m_changedNote = nullptr;
    QPushButton* m_putBack = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
};

} // namespace thetalane
