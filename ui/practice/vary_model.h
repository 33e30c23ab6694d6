// The outcomes side by side: a row for each value.
#pragma once

#include "core/study/vary_throw.h"

#include <QAbstractTableModel>

#include <optional>

namespace thetalane {

class VaryModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Value, Left, Down, First, Offset, Angle, columns };
    enum Role { PinsRole = Qt::UserRole + 1, ClearsRole, PresentRole, PossibleRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setOutcomes(const VarySettings& settings, std::vector<VariedThrow> outcomes);
    const std::vector<VariedThrow>& outcomes() const { return m_outcomes; }
    bool isPresent(int row) const;
    int presentRow() const; // -1: none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    void retranslate();

private:
    QString shown(const VariedThrow& outcome, int column) const;
    QString rowText(const VariedThrow& outcome) const;

    VarySettings m_settings;
    std::vector<VariedThrow> m_outcomes;
};

} // namespace thetalane
