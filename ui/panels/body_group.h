// One body's numbers. Keeps the body as edited, to the last bit of what was not touched.
#pragma once

#include "core/scene/validation.h"
#include "ui/appearance.h"

#include <QColor>
#include <QWidget>

#include <array>

class QGridLayout;
class QLabel;

namespace thetalane {

class NumberField;

class BodyGroup : public QWidget {
    Q_OBJECT
public:
    // index: of the body in its scene; the fields are named body0Mass, body0Radius, …
    BodyGroup(const Appearance& appearance, int index, QWidget* parent = nullptr);

    const Body& body() const { return m_body; } // as edited, whether right or wrong
    // Drops everything that was being edited. `turns`: it may roll, so its spin and inertia are shown too.
    void show(const Body& body, bool turns);
    void setColour(const QColor& colour);

    // What the fields themselves hold against being used: no numbers, a negative speed.
    bool isUsable() const;

    // Shows what is wrong with this body, of these and of its own fields; nothing is wrong: nothing shown.
    void showErrors(const std::vector<SceneError>& errors);

    void retranslate();

signals:
    void edited();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    enum Field { Mass, Radius, Speed, Direction, X, Y, SpinX, SpinY, SpinZ, Inertia, fieldCount };

    void restyle();
    void showFields(bool turns);
    int fieldFor(const QString& key) const;
    void take(int field, double value);
    void complain(int field, const QString& message);
    void addMessage(int row, const QString& about, const QString& message);

    const Appearance& m_appearance;
    int m_index;
    Body m_body;
    QColor m_colour;
    QGridLayout* m_grid;
    QLabel* m_id;
    std::array<QLabel*, fieldCount> m_labels{};
    std::array<NumberField*, fieldCount> m_fields{};
    std::array<QLabel*, fieldCount / 2> m_messages{};
};

} // namespace thetalane
