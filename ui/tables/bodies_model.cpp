#include "ui/tables/bodies_model.h"

#include "ui/tables/collision_sheet.h"
#include "ui/words/worked_steps.h"

namespace thetalane {

BodiesModel::BodiesModel(const Appearance& appearance, QObject* parent)
    : QAbstractTableModel(parent)
    , m_appearance(appearance)
    , m_columns(bodyColumns()) {}

void BodiesModel::setRun(std::shared_ptr<const Run> run, int first, int second) {
    beginResetModel();
    m_run = std::move(run);
    m_first = first;
    m_second = second;
    m_keptRow = -1;
    endResetModel();
}

void BodiesModel::setTime(double time, int fromRow, int toRow) {
    m_time = time;
    m_keptRow = -1;
    if (fromRow >= 0 && toRow >= fromRow && toRow < rowCount())
        emit dataChanged(index(fromRow, 0), index(toRow, columnCount() - 1), {Qt::DisplayRole});
}

void BodiesModel::retranslate() {
    m_columns = bodyColumns();
    m_keptRow = -1;
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int BodiesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_run ? 0 : int(m_run->scene.bodies.size()) + 1;
}

int BodiesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_columns.size());
}

std::vector<SheetCell> BodiesModel::row(int row) const {
    if (row == m_keptRow)
        return m_kept;
    const Scene& scene = m_run->scene;
    if (row < int(scene.bodies.size())) {
        const auto body = std::size_t(row);
        const Ink ink = row == m_first ? Ink::First : row == m_second ? Ink::Second : Ink::Plain;
        m_kept = bodyRow(bodyName(scene, row), scene.bodies[body].mass,
                         m_run->timeline.bodyAt(body, m_time).velocity, ink);
    } else {
        const std::vector<BodyState> states = m_run->timeline.stateAt(m_time);
        const Totals sums = totals(scene, states);
        double mass = 0, scale = 0;
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            mass += scene.bodies[b].mass;
            scale += scene.bodies[b].mass * norm(states[b].velocity);
        }
        m_kept = totalRow(mass, sums.momentum, sums.energy, scale);
    }
    m_keptRow = row;
    return m_kept;
}

QVariant BodiesModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight));
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::ForegroundRole &&
        role != Qt::FontRole)
        return {};
    const std::vector<SheetCell> cells = row(index.row());
    if (std::size_t(index.column()) >= cells.size())
        return {};
    const SheetCell& cell = cells[std::size_t(index.column())];
    if (role == Qt::DisplayRole)
        return cell.shown;
    if (role == Qt::ToolTipRole)
        return cell.hover;
    if (role == Qt::ForegroundRole)
        return m_appearance.textInk(cell.ink);
    return m_appearance.font(Appearance::Size::Small, cell.strong || cell.ink != Ink::Plain);
}

QVariant BodiesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    const SheetColumn& column = m_columns[std::size_t(section)];
    // A style sheet draws what is aligned to the right up to the very edge, and a little over it.
    constexpr QChar space(0xA0);
    if (role == Qt::DisplayRole)
        return column.unit.isEmpty() ? column.name + space
                                     : column.name + space + u'\n' + column.unit + space;
    if (role == Qt::ToolTipRole)
        return columnTitle(column);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignBottom | (section == 0 ? Qt::AlignLeft : Qt::AlignRight));
    return {};
}

} // namespace thetalane
