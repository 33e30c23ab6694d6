// How a scene is edited by hand, to be chosen: constant size, the grid, one line.
#pragma once

#include "ui/appearance.h"
#include "ui/bench/rules/edit_options.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;

namespace thetalane {

// Check boxes as large as the appearance wants them.
void restyleCheckBox(QCheckBox& box, const Appearance& appearance);

class EditOptionsRow : public QWidget {
    Q_OBJECT
public:
    EditOptionsRow(const Appearance& appearance, EditOptions& options, QWidget* parent = nullptr);

    void retranslate();
    void showOptions();

signals:
    void oneLineWanted(bool on); // whether it can be had is not known here

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void restyle();

    const Appearance& m_appearance;
    EditOptions& m_options;
    QGridLayout* m_grid;
    QCheckBox* m_constantSize;
    QCheckBox* m_oneLine;
    QCheckBox* m_snap;
    QComboBox* m_spacing;
};

} // namespace thetalane
