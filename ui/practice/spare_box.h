// Spare practice: which pins stand, a throw at them, and how many of the tries made it.
#pragma once

#include "core/study/spare_line.h"
#include "ui/panels/panel.h"

#include <map>
#include <optional>
#include <vector>

class QPushButton;
class QVBoxLayout;

namespace thetalane {

class LatestJob;
class LeafButton;
class PinDeck;

class SpareBox : public Panel {
    Q_OBJECT
public:
    struct Count {
        int tries = 0;
        int made = 0;
    };

    explicit SpareBox(const Context& context, QWidget* parent = nullptr);

    const PinSet& standing() const; // as picked
    Count countOf(const PinSet& pins) const;
    bool searching() const;

    void retranslate() override;

signals:
    void thrown();

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void arrange();
    void pick(const PinSet& pins);
    void throwBall();
    void settle(); // a try that was thrown counts
    void advise();
    void followSession();
    void followPlayhead();
    void showCounts();
    void showResult();
    void showAdvice();

    struct Try {
        PinSet pins, left;
    };
    std::map<unsigned long, Count> m_counts; // by the pins' bits
    std::optional<Try> m_flying;             // thrown, and not at its end yet
    std::optional<Try> m_last;
    enum class Advice { None, Searching, Found, NotFound } m_advice = Advice::None;
    double m_spread = 0; // of the advised line [rad]
    bool m_applying = false;

    LatestJob* m_search;
    PinDeck* m_deck;
    std::vector<LeafButton*> m_leaves;
    QLabel* m_title;
    QLabel* m_hint;
    QLabel* m_count;
    QLabel* m_result;
    QLabel* m_line;
    QPushButton* m_throw;
    QPushButton* m_show;
    QWidget* m_leafArea;
    QVBoxLayout* m_column;
};

} // namespace thetalane
