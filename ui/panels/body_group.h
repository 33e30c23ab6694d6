// One body's numbers. Keeps the body as edited, to the last bit of what was not touched.
#pragma once

#include "core/scene/validation.h"
#include "ui/appearance.h"

#include <QColor>
#include <QWidget>

#include <array>

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace thetalane {

class EditOptions;
class IconButton;
class NumberField;
class ValueSlider;

class BodyGroup : public QWidget {
    Q_OBJECT
public:
    // index: of the body in its scene; the fields are named body0Mass, body0Radius, …, the sliders
    // body0MassSlider and body0RadiusSlider, and there are body0Name, body0Kind and body0Remove.
    BodyGroup(const Appearance& appearance, const EditOptions& options, int index, QWidget* parent = nullptr);

    const Body& body() const { return m_body; } // as edited, whether right or wrong
    // Drops everything that was being edited. `turns`: it may roll, so its spin and inertia are shown too.
    void show(const Body& body, bool turns, bool removable);
    void setColour(const QColor& colour);

    // What the fields themselves hold against being used: no numbers, a negative speed.
    bool isUsable() const;

    // Shows what is wrong with this body, of these and of its own fields; nothing is wrong: nothing shown.
    void showErrors(const std::vector<SceneError>& errors);

    void retranslate();

signals:
    void edited();
    void removeWanted(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum Field { Mass, Radius, Speed, Direction, X, Y, SpinX, SpinY, SpinZ, Inertia, fieldCount };

    void restyle();
    void buildHead();
    void buildFields();
    void showFields(bool turns);
    void takeMass(double mass);
    int fieldFor(const QString& key) const;
    void take(int field, double value);
    void complain(int field, const QString& message);
    void addMessage(int row, const QString& about, const QString& message);

    const Appearance& m_appearance;
    const EditOptions& m_options;
    int m_index;
    Body m_body;
    Body m_dense; // the last one with a mass and a radius that are right: its density is kept
    QColor m_colour;
    QGridLayout* m_grid;
    QLineEdit* m_name;
    QComboBox* m_kind;
    IconButton* m_remove;
    std::array<ValueSlider*, 2> m_sliders{}; // of mass and radius
    QLabel* m_nameMessage;
    std::array<QLabel*, fieldCount> m_labels{};
    std::array<NumberField*, fieldCount> m_fields{};
    std::array<QLabel*, fieldCount / 2> m_messages{};
};

} // namespace thetalane
