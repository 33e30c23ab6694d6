// Predict, then reveal: a class sets what it expects of a collision, and sees it against what happens, with a
// score and what went wrong in words. Until then nothing in this panel shows the truth, and the playhead
// holds just before the collision.
#pragma once

#include "core/collision/prediction.h"
#include "ui/panels/panel.h"

#include <memory>
#include <optional>

class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace thetalane {

class GuessFields;
class PredictFigure;

class PredictPanel : public Panel {
    Q_OBJECT
public:
    explicit PredictPanel(const Context& context, QWidget* parent = nullptr);

    enum class State { Invitation, Predicting, Revealed };
    State state() const { return m_state; }
    // Of the whole run, from 1; the one that is predicted.
    std::int64_t number() const { return m_number; }
    const std::optional<Verdict>& verdict() const { return m_verdict; } // once revealed

    // The open collision, or the next one that can be predicted: not one of several resolved together.
    void begin();
    void reveal();

    void retranslate() override;

signals:
    void predicting(bool isHidden); // while true, others had better not tell what comes

protected:
    void restyle() override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* makeInvitation();
    QWidget* makeWork(const Context& context);
    std::optional<std::size_t> wanted() const;
    void open(std::size_t index);
    void hold();
    void tryAgain();
    void goOn();
    void drop();
    void setState(State state);
    void followPlayhead();
    void showWords();
    void showInvitation();
    void fit();
    void showVerdict();
    void tellOthers();
    QString truthText() const;

    State m_state = State::Invitation;
    std::shared_ptr<const Run> m_run;
    Collision m_collision;
    double m_holdAt = 0; // [s]
    std::int64_t m_number = 0;
    std::optional<Verdict> m_verdict;
    QStackedWidget* m_pages;
    QLabel* m_invitation = nullptr;
    QPushButton* m_begin = nullptr;
    QScrollArea* m_scroll = nullptr;
    QVBoxLayout* m_column = nullptr;
    QVBoxLayout* m_foot = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_facts = nullptr;
    QLabel* m_score = nullptr;
    QLabel* m_wrong = nullptr;
    QLabel* m_truth = nullptr;
    QLabel* m_rule = nullptr;
    PredictFigure* m_figure = nullptr;
    GuessFields* m_fields = nullptr;
    QLabel* m_message = nullptr;
    QPushButton* m_hold = nullptr;
    QPushButton* m_reveal = nullptr;
    QPushButton* m_next = nullptr;
};

} // namespace thetalane
