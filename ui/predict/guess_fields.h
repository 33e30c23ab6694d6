// What is expected of a collision, in numbers: each body's velocity, by components or by speed and direction,
// and where it is wished the total momentum and the energy lost.
#pragma once

#include "core/collision/prediction.h"
#include "ui/appearance.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace thetalane {

class NumberField;

class GuessFields : public QWidget {
    Q_OBJECT
public:
    explicit GuessFields(const Appearance& appearance, QWidget* parent = nullptr);

    // At a wall there is one body, and no momentum to keep.
    void setUp(const QString& first, const QString& second, bool isWall, double speed);
    void setVelocities(const VelocityPair<double>& velocities);
    const Prediction& prediction() const { return m_prediction; }
    void setEditable(bool editable);
    bool isReadable() const;    // every field holds a number
    QString unreadable() const; // why one does not

    void retranslate();
    void restyle();

signals:
    void edited(); // prediction() is another one

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Field { FirstX, FirstY, SecondX, SecondY, MomentumX, MomentumY, Energy, fieldCount };

    void makeFields();
    void showVelocities();
    void take();
    void showMarks();
    NumberField& field(int f) const { return *m_fields[std::size_t(f)]; }

    const Appearance& m_appearance;
    QGridLayout* m_grid;
    std::array<NumberField*, fieldCount> m_fields{};
    std::array<QLabel*, 2> m_names{}; // of the bodies
    std::array<QLabel*, 2> m_heads{}; // of the columns
    QPushButton* m_mode;
    QCheckBox* m_momentum;
    QCheckBox* m_energy;
    Prediction m_prediction;
    QString m_first, m_second;
    bool m_isWall = false;
    bool m_polar = false; // speed and direction
    bool m_editable = true;
};

} // namespace thetalane
