// The study in rows: what each method costs, how far off it is, and where it first differs.
#pragma once

#include "ui/appearance.h"
#include "ui/lab/run_lab.h"

#include <QTableWidget>

namespace thetalane {

class LabTable : public QTableWidget {
    Q_OBJECT
public:
    enum Column { Name, Cost, Error, Same, Difference, ColumnCount };

    explicit LabTable(const Appearance& appearance, QWidget* parent = nullptr);

    void show(std::shared_ptr<const LabResult> result); // null: nothing yet
    using QWidget::show;
    void retranslate();

    QSize sizeHint() const override; // all rows: whatever holds it scrolls
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void rowChosen(std::size_t row);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void restyle();
    void fill();
    void fit();
    void put(int row, int column, const QString& text, const QString& toolTip);
    void fillRow(std::size_t row);

    const Appearance& m_appearance;
    std::shared_ptr<const LabResult> m_result;
};

} // namespace thetalane
