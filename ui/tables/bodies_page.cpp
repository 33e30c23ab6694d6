#include "ui/tables/bodies_page.h"

#include "ui/tables/bodies_model.h"
#include "ui/tables/collision_sheet.h"
#include "ui/tables/sheet_table.h"
#include "ui/words/number_text.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>
#include <numeric>

namespace thetalane {

BodiesPage::BodiesPage(const Context& context, QWidget* parent)
    : TablePage(context, "bodiesPage", parent)
    , m_model(new BodiesModel(context.appearance, this))
    , m_when(new QLabel(this))
    , m_table(new QTableView(this)) {
    m_when->setObjectName(QStringLiteral("bodiesWhen"));
    m_table->setObjectName(QStringLiteral("bodiesTable"));
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionsClickable(false);
    m_table->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_when);
    column->addWidget(m_table, 1);
    restyle();
    retranslate();
}

void BodiesPage::retranslate() {
    m_table->setAccessibleName(tr("All bodies now"));
    m_table->setToolTip(tr("Follows the time; Ctrl+C copies the rows chosen, or all, with every digit"));
    m_model->retranslate();
    fit();
    showTime();
}

void BodiesPage::restyle() {
    TablePage::restyle();
    makeQuiet(*m_when, appearance());
    styleTable(*m_table, appearance());
    fit();
}

void BodiesPage::showRun() {
    int first = session().scene().bodies.size() == 2 ? 0 : -1, second = first + (first == 0 ? 1 : 0);
    if (const auto open = selected()) {
        first = session().timeline().collisions()[*open].first;
        second = session().timeline().collisions()[*open].second;
    }
    m_model->setRun(session().run(), first, second);
    fit();
}

void BodiesPage::showTime() {
    m_when->setText(tr("At %1 s").arg(numberText(playhead().time(), 5)));
    const int top = m_table->rowAt(0);
    const int bottom = m_table->rowAt(m_table->viewport()->height() - 1);
    m_model->setTime(playhead().time(), std::max(0, top), bottom < 0 ? m_model->rowCount() - 1 : bottom);
}

// As wide as numbers of this kind become, not as those of now: nothing jumps while it plays.
void BodiesPage::fit() {
    const QFontMetrics metrics(appearance().font(Appearance::Size::Small, true));
    int name = metrics.horizontalAdvance(m_model->headerData(0, Qt::Horizontal, Qt::DisplayRole).toString());
    const int seen = std::min(m_model->rowCount(), 64); // of a crowd the first ones stand for all
    int mass = metrics.horizontalAdvance(QStringLiteral("0.000"));
    for (int row = 0; row < seen; ++row) {
        const auto cells = m_model->row(row == seen - 1 ? m_model->rowCount() - 1 : row);
        name = std::max(name, metrics.horizontalAdvance(cells[0].shown));
        mass = std::max(mass, metrics.horizontalAdvance(cells[1].shown));
    }
    const int number = std::max(metrics.horizontalAdvance(QStringLiteral("−0.0000")),
                                metrics.horizontalAdvance(QStringLiteral("kg·m/s")));
    const int columns = m_model->columnCount();
    m_table->setColumnWidth(0, name + 14);
    m_table->setColumnWidth(1, mass + 14);
    for (int c = 2; c < columns; ++c)
        m_table->setColumnWidth(c, number + 12);
}

Sheet BodiesPage::rowsOf(const std::vector<int>& rows) const {
    Sheet sheet{bodyColumns(), {}};
    for (const int row : rows)
        sheet.rows.push_back(m_model->row(row));
    return sheet;
}

Sheet BodiesPage::sheet() const {
    std::vector<int> rows(std::size_t(m_model->rowCount()));
    std::iota(rows.begin(), rows.end(), 0);
    return rowsOf(rows);
}

bool BodiesPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
        return TablePage::eventFilter(watched, event);
    std::vector<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.push_back(index.row());
    std::sort(rows.begin(), rows.end());
    QApplication::clipboard()->setText(tabbed(rows.empty() ? sheet() : rowsOf(rows)));
    return true;
}

} // namespace thetalane
