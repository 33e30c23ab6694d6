// The collisions of a chapter as a table: nothing is copied, and nothing is computed but the text of the rows
// seen.
#pragma once

#include "core/engine/engine.h"
#include "ui/words/instant.h"

#include <QAbstractTableModel>

#include <memory>

namespace thetalane {

class CollisionModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Number, Time, Bodies, Impulse, EnergyLoss, columnCountOfAll };

    // Beside what is displayed: how a row stands among those of its instant, and among those resolved
    // together with it; in a chain each is Alone.
    enum Role { InstantRole = Qt::UserRole, PassRole };
    enum Instant { Alone = 0, First = 1, Last = 2, Between = 3 };

    explicit CollisionModel(QObject* parent = nullptr);

    // before: how many collisions the whole run had before the first of these.
    void setRun(std::shared_ptr<const Run> run, std::int64_t before);
    std::int64_t numberOf(int row) const { return m_before + row + 1; }
    void retranslate();

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    // One line, every digit, columns parted by tabs: number, time, first, second, impulse, energy loss,
    // the number of the first collision of the same instant, pass.
    QString exactRow(int row) const;
    QString exactHeader() const;

private:
    const Collision& at(int row) const;
    QString shown(const Collision& collision, int row, int column) const;
    QString hint(const Collision& collision, int row, int column) const;
    Instant standing(int row, std::size_t begin, std::size_t size) const;
    thetalane::Instant instantOf(int row) const;

    std::shared_ptr<const Run> m_run;
    std::int64_t m_before = 0;
};

} // namespace thetalane
