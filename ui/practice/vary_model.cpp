#include "ui/practice/vary_model.h"

#include "ui/panels/pin_deck.h"
#include "ui/practice/vary_words.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"

#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;

} // namespace

void VaryModel::setOutcomes(const VarySettings& settings, std::vector<VariedThrow> outcomes) {
    const bool sameShape = outcomes.size() == m_outcomes.size();
    if (!sameShape)
        beginResetModel();
    m_settings = settings;
    m_outcomes = std::move(outcomes);
    if (!sameShape)
        return endResetModel();
    if (!m_outcomes.empty())
        emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
}

bool VaryModel::isPresent(int row) const {
    return m_outcomes[std::size_t(row)].value == quantityOf(m_settings.base, m_settings.quantity);
}

int VaryModel::presentRow() const {
    for (int row = 0; row < rowCount(); ++row)
        if (isPresent(row))
            return row;
    return -1;
}

int VaryModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(m_outcomes.size());
}

int VaryModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QString VaryModel::shown(const VariedThrow& v, int column) const {
    const QString none = QStringLiteral("—");
    switch (column) {
    case Value:
        return numberText(shownQuantity(m_settings.quantity, v.value), 4);
    case Left:
        return v.possible ? pinsText(v.left) : none;
    case Down:
        return v.possible ? QString::number(v.pinsDown) : none;
    case First:
        return v.firstPin ? QString::number(*v.firstPin) : none;
    case Offset:
        return v.entry ? QString::number(v.entry->offset * 100, 'f', 1).replace(u'-', QChar(0x2212)) : none;
    default:
        return v.entry ? QString::number(v.entry->angle / degree, 'f', 1).replace(u'-', QChar(0x2212)) : none;
    }
}

QString VaryModel::rowText(const VariedThrow& v) const {
    const QString value = QStringLiteral("%1 %2 %3")
                              .arg(throwQuantityName(m_settings.quantity), shown(v, Value),
                                   throwQuantityUnit(m_settings.quantity));
    if (!v.possible)
        return value + QStringLiteral(": ") + tr("cannot be thrown");
    if (v.clears())
        return value + QStringLiteral(": ") +
               (m_settings.standing.all() ? tr("a strike") : tr("all of them down"));
    return value + QStringLiteral(": ") + tr("%1 down, left standing %2").arg(shown(v, Down), shown(v, Left));
}

QVariant VaryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const VariedThrow& v = m_outcomes[std::size_t(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return shown(v, index.column());
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return rowText(v);
    case Qt::TextAlignmentRole:
        return int(Qt::AlignCenter);
    case PinsRole:
        return int(v.left.to_ulong());
    case ClearsRole:
        return v.clears();
    case PresentRole:
        return isPresent(index.row());
    case PossibleRole:
        return v.possible;
    default:
        return {};
    }
}

QVariant VaryModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignCenter);
    if (role == termRole)
        return section == Value    ? QString::fromLatin1(throwQuantityTerm(m_settings.quantity))
               : section == Left   ? QStringLiteral("leave")
               : section == Down   ? QStringLiteral("pinfall")
               : section == First  ? QStringLiteral("pocket")
               : section == Offset ? QStringLiteral("offset")
                                   : QStringLiteral("entry-angle");
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole)
        return {};
    const bool brief = role == Qt::DisplayRole;
    switch (section) {
    case Value:
        return throwQuantityName(m_settings.quantity).section(u' ', 0, 0) + (brief ? u'\n' : u' ') + u'[' +
               throwQuantityUnit(m_settings.quantity) + u']';
    case Left:
        return brief ? tr("Left") : tr("Pins left standing");
    case Down:
        return brief ? tr("Down") : tr("Pins that went down");
    case First:
        return brief ? tr("First\npin") : tr("The pin that the ball touches first");
    case Offset:
        return brief ? tr("Offset\n[cm]")
                     : tr("Where the ball's path passes the head pin [cm], positive to the right");
    default:
        return brief ? tr("Angle\n[°]") : tr("The entry angle [°], positive to the left");
    }
}

void VaryModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columns - 1);
    if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, columns - 1));
}

} // namespace thetalane
