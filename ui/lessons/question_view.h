// The question of a lesson: options to choose from, a number or a vector to type; then the truth, and why.
// Before it is revealed, nothing here knows it.
#pragma once

#include "core/format/lesson_file.h"
#include "ui/panels/panel.h"

#include <functional>

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace thetalane {

class CardButton;
class NumberField;

class QuestionView : public Panel {
    Q_OBJECT
public:
    // truth: asked for when it is revealed.
    QuestionView(const Context& context, std::function<std::optional<Vec2d>()> truth,
                 QWidget* parent = nullptr);

    // scene: gives the bodies their names.
    void setQuestion(const LessonQuestion& question, const Scene& scene);
    bool isRevealed() const { return m_revealed; }
    void reveal();        // not while what was typed is no number
    bool isWhole() const; // all of it is seen without scrolling

    void retranslate() override;

signals:
    void revealChanged();

protected:
    void restyle() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build();
    void choose(int option);
    void fit();
    void askAgain();
    void showState();
    void showVerdict();
    std::optional<Vec2d> typed() const;
    QString verdictText() const;

    std::function<std::optional<Vec2d>()> m_truthSource;
    LessonQuestion m_question;
    Scene m_scene;
    std::vector<CardButton*> m_options;
    std::vector<NumberField*> m_fields;
    std::vector<QLabel*> m_fieldNames;
    QScrollArea* m_scroll;
    QLabel* m_text;
    QLabel* m_hint;
    QWidget* m_answers = nullptr;
    QPushButton* m_again;
    QLabel* m_verdict;
    QLabel* m_why;
    QVBoxLayout* m_column;
    int m_chosen = -1;
    bool m_revealed = false;
    bool m_isRight = false;
    bool m_entered = false; // a number was typed
    std::optional<Vec2d> m_truth;
};

} // namespace thetalane
