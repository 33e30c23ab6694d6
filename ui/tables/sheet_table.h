// A Sheet on screen: as high as its rows, as wide as there is room. Ctrl+C copies the rows chosen, or all.
#pragma once

#include "ui/appearance.h"
#include "ui/tables/sheet.h"

#include <QTableView>

namespace thetalane {

class SheetModel;

class SheetTable : public QTableView {
    Q_OBJECT
public:
    // name becomes the objectName.
    SheetTable(const Appearance& appearance, const char* name, QWidget* parent = nullptr);

    void setSheet(Sheet sheet);
    const Sheet& sheet() const;

    // The narrowest at which nothing is cut [px].
    int naturalWidth() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void fit();
    int columnNeeds(int column) const;

    const Appearance& m_appearance;
    SheetModel* m_model;
};

// The look that the tables of this room share: fonts, heights of rows, no grid.
void styleTable(QTableView& table, const Appearance& appearance);

} // namespace thetalane
