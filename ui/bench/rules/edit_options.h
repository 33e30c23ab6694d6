// How a scene is edited by hand: what the panel, the lane and the keys all keep to.
#pragma once

#include <QObject>

namespace thetalane {

class EditOptions : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    // A mass that is changed leaves the radius; else the radius follows it at the same density, as that of a
    // ball of the same stuff: by the cube root of the mass.
    bool constantSize() const { return m_constantSize; }
    void setConstantSize(bool on) { set(m_constantSize, on); }

    // Bodies are put down on a grid, tips of arrows on whole tenths of a m/s.
    bool snap() const { return m_snap; }
    void setSnap(bool on) { set(m_snap, on); }
    // The grid's spacing [m]; 0: it follows the zoom.
    double grid() const { return m_grid; }
    void setGrid(double spacing) { set(m_grid, spacing); }

    // All bodies on one line along x, velocities along it only.
    bool oneLine() const { return m_oneLine; }
    void setOneLine(bool on) { set(m_oneLine, on); }

signals:
    void changed();

private:
    template <class T> void set(T& member, T value) {
        if (member == value)
            return;
        member = value;
        emit changed();
    }

    bool m_constantSize = true;
    bool m_snap = false;
    bool m_oneLine = false;
    double m_grid = 0;
};

} // namespace thetalane
