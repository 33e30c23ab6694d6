// The attributes of the paper's ball (fig. 12), live, in the units of the user's choice, and the button that
// throws it.
#pragma once

#include "ui/panels/panel.h"
#include "ui/panels/throw_terms.h"

#include <array>

class QComboBox;
class QHBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace thetalane {

class SpinDial;

class ThrowPanel : public Panel {
    Q_OBJECT
public:
    explicit ThrowPanel(const Context& context, QWidget* parent = nullptr);

    void retranslate() override;

    const ThrowUnits& units() const { return m_units; }
    void setUnits(const ThrowUnits& units); // as they were remembered

signals:
    void unitsChanged(const thetalane::ThrowUnits& units);

protected:
    void restyle() override;

private:
    enum Row { Mass, Speed, Direction, Position, Spin, Axis, Restitution, rowCount };

    void makeRows();
    void makeButtons(QVBoxLayout& layout);
    void makeDial();
    void makePathAhead();
    void chooseUnits(const ThrowUnits& units);
    void foresee();
    void showThrow();
    void showNumbers();
    void takeSpin(double rpm, double axis);
    double factorOf(int row) const; // what the row's unit is in the throw's own
    void take(int row, double value);
    void apply();
    std::vector<SceneError> wrongRows() const; // what only a throw minds; path = the row's number
    void showErrors();
    void showNotes();
    void showRoll();
    void throwBall();

    std::array<ValueRow*, rowCount> m_rows{};
    SpinDial* m_dial;
    QLabel* m_rollNote;
    QLabel* m_pathLabel;
    QComboBox* m_path; // how far the path is shown ahead: by Foresight
    QPushButton* m_throwButton;
    QPushButton* m_default;
    QVBoxLayout* m_column;
    QVBoxLayout* m_foot;
    QHBoxLayout* m_spinRow;
    ThrowUnits m_units;
    Foresight m_foresight = Foresight::Whole; // wished for; a throw under way is shown whole
    Throw m_throw;                            // as edited, to the last bit of what was not touched
    double m_restitution = defaultPinRestitution;
    std::vector<SceneError> m_errors;
    bool m_applying = false;
};

} // namespace thetalane
