// The first thing in the lab: six questions to press, and one's own scene.
#pragma once

#include "ui/lab/lab_plan.h"
#include "ui/panels/panel.h"

class QGridLayout;
class QPushButton;

namespace thetalane {

class PresetRow : public Panel {
    Q_OBJECT
public:
    explicit PresetRow(const Context& context, QWidget* parent = nullptr);

    void setChosen(std::optional<int> index); // presetCount: one's own scene

    void retranslate() override;

signals:
    void presetChosen(thetalane::Preset preset);
    void ownChosen();

protected:
    void restyle() override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void arrange(); // in as many columns as there is room for

    QGridLayout* m_grid;
    std::vector<QPushButton*> m_buttons;
    int m_columns = 0;
};

} // namespace thetalane
