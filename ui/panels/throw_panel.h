// The attributes of the paper's ball (fig. 12), live, and the button that throws it.
#pragma once

#include "ui/panels/panel.h"

#include <array>

class QPushButton;
class QVBoxLayout;

namespace thetalane {

class ValueRow;

class ThrowPanel : public Panel {
    Q_OBJECT
public:
    explicit ThrowPanel(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

protected:
    void restyle() override;

private:
    enum Row { Mass, Speed, Direction, Position, Spin, Axis, Restitution, rowCount };

    void makeRows();
    void makeButtons(QVBoxLayout& layout);
    void showThrow();
    void take(int row, double value);
    void apply();
    std::vector<SceneError> wrongRows() const; // what only a throw minds; path = the row's number
    void showErrors();
    void showNotes();
    void showRoll();
    void throwBall();

    std::array<ValueRow*, rowCount> m_rows{};
    QLabel* m_rollNote;
    QPushButton* m_throwButton;
    QPushButton* m_default;
    QVBoxLayout* m_column;
    QVBoxLayout* m_foot;
    Throw m_throw; // as edited, to the last bit of what was not touched
    double m_restitution = defaultPinRestitution;
    std::vector<SceneError> m_errors;
    bool m_applying = false;
};

} // namespace thetalane
