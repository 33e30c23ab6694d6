// The ghosts with what belongs to them: a slider for the time, and a line for each that says when it leaves.
#pragma once

#include "ui/appearance.h"
#include "ui/lab/run_lab.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace thetalane {

class GhostView;
class ValueSlider;

class GhostBox : public QWidget {
    Q_OBJECT
public:
    explicit GhostBox(const Appearance& appearance, QWidget* parent = nullptr);

    void show(std::shared_ptr<const LabResult> result); // null: nothing yet
    using QWidget::show;
    void light(std::optional<std::size_t> row); // of the table; nothing if none of the ghosts is of it
    void retranslate();

    GhostView* view() const { return m_view; }

signals:
    void rowChosen(std::size_t row);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void makeLegend();
    void nameLegend();
    void open(std::size_t ghost); // goes to where it leaves the truth, and says what happens there
    void setTime(double time);
    void describe();
    const Ghosts* ghosts() const { return m_result ? m_result->ghosts.get() : nullptr; }

    const Appearance& m_appearance;
    GhostView* m_view;
    ValueSlider* m_slider;
    QLabel* m_time;
    QLabel* m_story;
    QVBoxLayout* m_column;
    std::vector<QPushButton*> m_legend;
    std::shared_ptr<const LabResult> m_result;
    std::optional<std::size_t> m_open;
};

} // namespace thetalane
