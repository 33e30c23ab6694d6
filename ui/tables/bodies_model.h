// The rows of all bodies at one time, each made when it is asked for; the sum stands last.
#pragma once

#include "core/engine/engine.h"
#include "ui/appearance.h"
#include "ui/tables/sheet.h"

#include <QAbstractTableModel>

#include <memory>

namespace thetalane {

class BodiesModel : public QAbstractTableModel {
    Q_OBJECT
public:
    explicit BodiesModel(const Appearance& appearance, QObject* parent = nullptr);

    void setRun(std::shared_ptr<const Run> run, int first,
                int second);                           // the bodies that have a colour, or -1
    void setTime(double time, int fromRow, int toRow); // [s]; the rows that are seen
    void retranslate();

    std::vector<SheetCell> row(int row) const;
    double time() const { return m_time; }
    const Run* run() const { return m_run.get(); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    const Appearance& m_appearance;
    std::shared_ptr<const Run> m_run;
    std::vector<SheetColumn> m_columns;
    int m_first = -1, m_second = -1;
    double m_time = 0;
    mutable int m_keptRow = -1; // a row is asked for cell by cell
    mutable std::vector<SheetCell> m_kept;
};

} // namespace thetalane
