// The walls around a scene: which there are, where they stand, and their own coefficient of restitution.
#pragma once

#include "core/scene/validation.h"
#include "ui/appearance.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QGridLayout;
class QLabel;

namespace thetalane {

class NumberField;

class WallGroup : public QWidget {
    Q_OBJECT
public:
    // The boxes are named wallLeft, …, the fields wallLeftPlace, …, wallRestitution.
    explicit WallGroup(const Appearance& appearance, QWidget* parent = nullptr);

    const std::optional<Frame>& frame() const { return m_frame; } // as edited, whether right or wrong
    void show(const std::optional<Frame>& frame);
    void put(Side side, std::optional<double> place); // [m]; nothing: open
    bool isUsable() const;
    void showErrors(const std::vector<SceneError>& errors);
    void retranslate();

signals:
    void edited();
    void wanted(thetalane::Side side); // where it would stand is not known here

private:
    void restyle();
    void take(std::size_t side, double place);
    void addMessage(const QString& about, const QString& message);

    const Appearance& m_appearance;
    std::optional<Frame> m_frame;
    double m_restitution = 1; // also while there is no wall
    QGridLayout* m_grid;
    QLabel* m_title;
    std::array<QCheckBox*, 4> m_boxes{};
    std::array<NumberField*, 4> m_places{};
    QLabel* m_eLabel;
    NumberField* m_e;
    QLabel* m_message;
};

} // namespace thetalane
