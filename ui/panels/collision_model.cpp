#include "ui/panels/collision_model.h"

#include "ui/count_text.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"

namespace thetalane {

CollisionModel::CollisionModel(QObject* parent)
    : QAbstractTableModel(parent) {}

void CollisionModel::setRun(std::shared_ptr<const Run> run, std::int64_t before) {
    beginResetModel();
    m_before = before;
    m_run = std::move(run);
    endResetModel();
}

void CollisionModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columnCountOfAll - 1);
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columnCountOfAll - 1));
}

const Collision& CollisionModel::at(int row) const {
    return m_run->timeline.collisions()[std::size_t(row)];
}

int CollisionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_run ? 0 : int(m_run->timeline.collisions().size());
}

int CollisionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columnCountOfAll;
}

thetalane::Instant CollisionModel::instantOf(int row) const {
    return thetalane::instantOf(m_run->timeline.collisions(), std::size_t(row));
}

CollisionModel::Instant CollisionModel::standing(int row, std::size_t begin, std::size_t size) const {
    if (size < 2)
        return Alone;
    const std::size_t at = std::size_t(row) - begin;
    return at == 0 ? First : at + 1 == size ? Last : Between;
}

QString CollisionModel::shown(const Collision& c, int row, int column) const {
    switch (column) {
    case Number:
        return countText(numberOf(row));
    case Time:
        return QString::number(c.time, 'f', 4);
    case Bodies:
        return bodyName(m_run->scene, c.first) + QStringLiteral(" → ") + partnerName(m_run->scene, c);
    case Impulse:
        return numberText(c.steps.impulse, 3);
    default:
        return numberText(c.steps.energyLoss, 3);
    }
}

QString CollisionModel::hint(const Collision& c, int row, int column) const {
    switch (column) {
    case Number:
        return instantText(instantOf(row), std::size_t(row));
    case Time:
        return exactText(c.time) + QStringLiteral(" s");
    case Impulse:
        return exactText(c.steps.impulse) + QStringLiteral(" N·s");
    case EnergyLoss:
        return exactText(c.steps.energyLoss) + QStringLiteral(" J");
    default:
        return shown(c, row, column);
    }
}

QVariant CollisionModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Collision& c = at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return shown(c, index.row(), index.column());
    case Qt::ToolTipRole:
        return hint(c, index.row(), index.column());
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (index.column() == Bodies ? Qt::AlignLeft : Qt::AlignRight));
    case InstantRole: {
        const auto i = instantOf(index.row());
        return standing(index.row(), i.begin, i.size);
    }
    case PassRole: {
        const auto i = instantOf(index.row());
        return standing(index.row(), i.passBegin, i.passSize);
    }
    default:
        return {};
    }
}

QVariant CollisionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignBottom | (section == Bodies ? Qt::AlignLeft : Qt::AlignRight));
    if (role == termRole)
        return section == Impulse      ? QStringLiteral("impulse")
               : section == EnergyLoss ? QStringLiteral("energy-loss")
               : section == Bodies     ? QStringLiteral("collision")
                                       : QVariant();
    const bool brief = role == Qt::DisplayRole;
    if (!brief && role != Qt::ToolTipRole)
        return {};
    switch (section) {
    case Number:
        return brief ? QStringLiteral("#")
                     : tr("Number of the collision. A bracket joins those of the same instant, a bar beside "
                          "it those "
                          "that were resolved together.");
    case Time:
        return brief ? tr("Time") + QStringLiteral("\ns") : tr("Time of the collision, in seconds");
    case Bodies:
        return brief ? tr("Bodies") : tr("First body → second body, or the wall");
    case Impulse:
        return brief ? tr("Impulse") + QStringLiteral("\nN·s")
                     : tr("Impulse on the first body along x′, in newton seconds");
    default:
        return brief ? tr("Lost") + QStringLiteral("\nJ") : tr("Kinetic energy lost, in joules");
    }
}

QString CollisionModel::exactHeader() const {
    return QStringList{QStringLiteral("#"),
                       tr("Time") + QStringLiteral(" [s]"),
                       tr("First"),
                       tr("Second"),
                       tr("Impulse") + QStringLiteral(" [N·s]"),
                       tr("Energy lost") + QStringLiteral(" [J]"),
                       tr("Same instant"),
                       tr("Pass")}
        .join(u'\t');
}

QString CollisionModel::exactRow(int row) const {
    const Collision& c = at(row);
    return QStringList{QString::number(numberOf(row)),
                       exactText(c.time),
                       bodyName(m_run->scene, c.first),
                       partnerName(m_run->scene, c),
                       exactText(c.steps.impulse),
                       exactText(c.steps.energyLoss),
                       c.group ? QString::number(numberOf(int(instantOf(row).begin))) : QString(),
                       c.group ? QString::number(c.pass) : QString()}
        .join(u'\t');
}

} // namespace thetalane
