#include "ui/tables/sheet_table.h"

#include <QAbstractTableModel>
#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QResizeEvent>
#include <QStyledItemDelegate>

#include <algorithm>

namespace thetalane {

class SheetModel : public QAbstractTableModel {
public:
    SheetModel(const Appearance& appearance, QObject* parent)
        : QAbstractTableModel(parent)
        , m_appearance(appearance) {}

    void set(Sheet sheet) {
        beginResetModel();
        m_sheet = std::move(sheet);
        endResetModel();
    }
    const Sheet& sheet() const { return m_sheet; }

    int rowCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : int(m_sheet.rows.size());
    }
    int columnCount(const QModelIndex& parent = {}) const override {
        return parent.isValid() ? 0 : int(m_sheet.columns.size());
    }

    QVariant data(const QModelIndex& index, int role) const override {
        const auto& row = m_sheet.rows[std::size_t(index.row())];
        if (std::size_t(index.column()) >= row.size())
            return {};
        const SheetCell& cell = row[std::size_t(index.column())];
        switch (role) {
        case Qt::DisplayRole:
            return cell.shown;
        case Qt::ToolTipRole:
            return cell.hover;
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == 0 ? Qt::AlignLeft : Qt::AlignRight));
        case Qt::ForegroundRole:
            return m_appearance.textInk(cell.ink);
        case Qt::FontRole: {
            QFont font = m_appearance.font(Appearance::Size::Small);
            font.setBold(cell.strong || cell.ink != Ink::Plain);
            return font;
        }
        default:
            return {};
        }
    }

    QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
        if (orientation != Qt::Horizontal)
            return {};
        const SheetColumn& column = m_sheet.columns[std::size_t(section)];
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

private:
    const Appearance& m_appearance;
    Sheet m_sheet;
};

void styleTable(QTableView& table, const Appearance& appearance) {
    const bool large = appearance.projector();
    table.setFont(appearance.font(Appearance::Size::Small));
    table.horizontalHeader()->setFont(appearance.font(Appearance::Size::Small));
    table.horizontalHeader()->setMinimumSectionSize(24);
    table.verticalHeader()->setMinimumSectionSize(20);
    table.verticalHeader()->setDefaultSectionSize(large ? 30 : 24);
}

SheetTable::SheetTable(const Appearance& appearance, const char* name, QWidget* parent)
    : QTableView(parent)
    , m_appearance(appearance)
    , m_model(new SheetModel(appearance, this)) {
    setObjectName(QLatin1String(name));
    setModel(m_model);
    setSelectionBehavior(SelectRows);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setWordWrap(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsClickable(false);
    connect(&appearance, &Appearance::changed, this, &SheetTable::restyle);
    restyle();
}

const Sheet& SheetTable::sheet() const {
    return m_model->sheet();
}

void SheetTable::setSheet(Sheet sheet) {
    m_model->set(std::move(sheet));
    fit();
}

void SheetTable::restyle() {
    styleTable(*this, m_appearance);
    fit();
}

int SheetTable::columnNeeds(int column) const {
    const QFontMetrics plain(m_appearance.font(Appearance::Size::Small));
    const QFontMetrics bold(m_appearance.font(Appearance::Size::Small, true));
    const Sheet& sheet = m_model->sheet();
    const SheetColumn& head = sheet.columns[std::size_t(column)];
    int wide = std::max(plain.horizontalAdvance(head.name), plain.horizontalAdvance(head.unit));
    for (const auto& row : sheet.rows)
        if (std::size_t(column) < row.size())
            wide = std::max(wide, bold.horizontalAdvance(row[std::size_t(column)].shown));
    return wide + 20;
}

int SheetTable::naturalWidth() const {
    int wide = 2 * frameWidth();
    for (int c = 0; c < m_model->columnCount(); ++c)
        wide += columnNeeds(c);
    return wide;
}

// What is left over is shared out among the columns, so that the table spans its room.
void SheetTable::fit() {
    const int columns = m_model->columnCount();
    const int over = std::max(0, viewport()->width() - naturalWidth());
    for (int c = 0; c < columns; ++c)
        setColumnWidth(c, columnNeeds(c) + over / columns);
    updateGeometry();
}

QSize SheetTable::sizeHint() const {
    const int bar = naturalWidth() > width() ? 12 : 0; // of the scroll bar
    return {240, horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 4 + bar};
}

void SheetTable::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fit();
}

void SheetTable::keyPressEvent(QKeyEvent* event) {
    if (!event->matches(QKeySequence::Copy))
        return QTableView::keyPressEvent(event);
    QList<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        rows << index.row();
    std::sort(rows.begin(), rows.end());
    Sheet chosen{sheet().columns, {}};
    for (const int row : rows)
        chosen.rows.push_back(sheet().rows[std::size_t(row)]);
    QApplication::clipboard()->setText(tabbed(rows.isEmpty() ? sheet() : chosen));
}

} // namespace thetalane
