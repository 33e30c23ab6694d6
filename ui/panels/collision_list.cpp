#include "ui/panels/collision_list.h"

#include "ui/panels/collision_delegate.h"
#include "ui/panels/collision_model.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedLayout>
#include <QTableView>

#include <algorithm>

namespace thetalane {

CollisionList::CollisionList(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_model(new CollisionModel(this))
    , m_table(new QTableView(this))
    , m_empty(new QLabel(this))
    , m_stack(new QStackedLayout(this)) {
    m_table->setObjectName(QStringLiteral("collisionTable"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new CollisionDelegate(appearance(), m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    // Rows of one height: Qt then measures none of them, however many there are.
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionsClickable(false);
    m_table->installEventFilter(this);
    m_empty->setObjectName(QStringLiteral("noCollisions"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_stack->addWidget(m_table);
    m_stack->addWidget(m_empty);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { open(current.row()); });
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) { open(index.row()); });
    connect(&session(), &Session::runChanged, this, &CollisionList::showRun);
    connect(&playhead(), &Playhead::selectionChanged, this, &CollisionList::followPlayhead);
    restyle();
    retranslate();
    showRun();
}

void CollisionList::retranslate() {
    m_table->setAccessibleName(tr("Collisions"));
    m_table->setToolTip(tr("Click a row to open that collision; Ctrl+C copies the rows with every digit"));
    m_empty->setText(tr("Nothing collides in this scene."));
    m_model->retranslate();
    fitColumns();
}

void CollisionList::restyle() {
    Panel::restyle();
    const bool large = appearance().projector();
    // Five columns have to stand side by side in a narrow panel, in projector mode too.
    const QFont text = appearance().font(large ? Appearance::Size::Small : Appearance::Size::Normal);
    m_table->setFont(text);
    const QFontMetrics metrics(text);
    QHeaderView* header = m_table->horizontalHeader();
    header->setFont(appearance().font(Appearance::Size::Small));
    header->setMinimumSectionSize(24);
    m_table->verticalHeader()->setMinimumSectionSize(24);
    m_table->verticalHeader()->setDefaultSectionSize(large ? 36 : 26);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(CollisionModel::Bodies, QHeaderView::Stretch);
    fitColumns();
    m_empty->setMargin(appearance().unit() * 3);
    m_empty->setFont(appearance().font(Appearance::Size::Normal));
    m_empty->setStyleSheet(QStringLiteral("color: %1;").arg(appearance().quietText().name()));
}

// 0.0411 is wider than 14.1. In a run of many thousands the first rows stand for all.
QString CollisionList::widestText(int column) const {
    const QFontMetrics metrics(m_table->font());
    QString widest = QStringLiteral("0.000");
    for (int row = 0; row < std::min(m_model->rowCount(), 500); ++row) {
        const QString text = m_model->index(row, column).data().toString();
        if (metrics.horizontalAdvance(text) > metrics.horizontalAdvance(widest))
            widest = text;
    }
    return widest;
}

// To the longest numbers and headings there will be; the bodies get the rest.
void CollisionList::fitColumns() {
    const QFontMetrics text(m_table->font());
    const QFontMetrics heading(appearance().font(Appearance::Size::Small));
    const auto fit = [&](int column, const QString& longest) {
        const QString words = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int wide = std::max(text.horizontalAdvance(longest),
                                  heading.size(Qt::TextSingleLine, words.section(u'\n', 0, 0)).width());
        m_table->setColumnWidth(column, wide + 14);
    };
    const QString digits = QString::number(std::max(10, m_model->rowCount()));
    fit(CollisionModel::Number, QString(digits.size(), u'0') + QStringLiteral("00")); // and the bracket
    fit(CollisionModel::Time, QStringLiteral("0.0000"));
    for (const int column : {CollisionModel::Impulse, CollisionModel::EnergyLoss})
        fit(column, widestText(column));
}

void CollisionList::showRun() {
    m_following = true; // emptying the model moves its current row: that is nobody's choice
    m_model->setRun(session().run());
    fitColumns();
    m_stack->setCurrentWidget(m_model->rowCount() ? static_cast<QWidget*>(m_table) : m_empty);
    m_following = false;
    followPlayhead();
}

void CollisionList::open(int row) {
    if (m_following || row < 0 || playhead().selected() == std::size_t(row))
        return;
    playhead().select(std::size_t(row));
}

void CollisionList::followPlayhead() {
    const auto selected = playhead().selected();
    m_following = true;
    if (!selected) {
        m_table->clearSelection();
    } else if (int(*selected) < m_model->rowCount()) {
        const QModelIndex index = m_model->index(int(*selected), 0);
        const bool chosen = m_table->selectionModel()->isRowSelected(index.row());
        // A row that is part of what the user is just selecting stays part of it.
        if (!chosen || m_table->currentIndex().row() != index.row())
            m_table->selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect |
                                                                  QItemSelectionModel::Rows);
        m_table->scrollTo(index);
    }
    m_following = false;
}

bool CollisionList::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Copy)) {
            copySelected();
            return true;
        }
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            open(m_table->currentIndex().row());
            return true;
        }
    }
    return Panel::eventFilter(watched, event);
}

void CollisionList::copySelected() const {
    QList<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    if (rows.isEmpty())
        return;
    std::sort(rows.begin(), rows.end());
    QStringList lines{m_model->exactHeader()};
    for (const int row : rows)
        lines.append(m_model->exactRow(row));
    QApplication::clipboard()->setText(lines.join(u'\n') + u'\n');
}

} // namespace thetalane
