// What the strike map is asked for: where, of which two quantities, with which ball and which e.
#pragma once

#include "ui/context.h"
#include "ui/map/map_view.h"

#include <QWidget>

#include <array>

class QComboBox;
class QGridLayout;
class QLabel;

namespace thetalane {

class NumberField;

class MapControls : public QWidget {
    Q_OBJECT
public:
    // cells: columns and rows.
    MapControls(const Context& context, int cells, QWidget* parent = nullptr);

    MapSettings settings() const;
    bool isSound(); // else says what is wrong

    // Where the present throw lies on these axes; nothing where it does not get to the pins.
    std::optional<MapView::Values> presentValues() const;
    bool ballIsPresent() const; // the map is of the ball of the present throw

    void retranslate();

signals:
    void changed();

private:
    QComboBox* combo(const char* name, int row, int column);
    void connectAll();
    void choose(QComboBox* chosen, QComboBox* other, std::size_t axis);
    void fillQuantities();
    void nameTerms();
    void showBalls();
    void showMessage();
    void restyle();
    MapScene scene() const;
    MapAxis axisOf(MapQuantity quantity) const;

    Context m_context;
    int m_cells;
    QGridLayout* m_grid;
    QLabel* m_times;
    QComboBox* m_scene;
    QComboBox* m_across;
    QComboBox* m_up;
    QComboBox* m_ball;
    QLabel* m_e;
    NumberField* m_restitution;
    QLabel* m_message;
    std::array<MapQuantity, 2> m_shown{MapQuantity::Offset, MapQuantity::Angle}; // across, up
};

// How the present throw comes to the pins; of a scene without a throw its one ball, where nothing bends its
// way.
std::optional<Entry> entryOfSession(const Session& session);

} // namespace thetalane
