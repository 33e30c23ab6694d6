#include "ui/panels/collision_list.h"

#include "ui/count_text.h"
#include "ui/panels/collision_delegate.h"
#include "ui/panels/collision_model.h"
#include "ui/panels/icon_button.h"
#include "ui/words/glossary.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QStackedLayout>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {

CollisionList::CollisionList(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_model(new CollisionModel(this))
    , m_table(new QTableView(this))
    , m_foot(new QWidget(this))
    , m_which(new QLabel(m_foot))
    , m_earlier(new IconButton(appearance(), Icon::CollisionBack, "earlierCollisions", m_foot))
    , m_later(new IconButton(appearance(), Icon::CollisionForward, "laterCollisions", m_foot))
    , m_page(makePage())
    , m_empty(new QLabel(this))
    , m_stack(new QStackedLayout(this)) {
    m_table->setObjectName(QStringLiteral("collisionTable"));
    setTerm(this, "collision");
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
    m_stack->addWidget(m_page);
    m_stack->addWidget(m_empty);

    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { open(current.row()); });
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& index) { open(index.row()); });
    connect(&session(), &Session::runChanged, this, &CollisionList::showRun);
    connect(&session(), &Session::chapterChanged, this, &CollisionList::showChapter);
    connect(&session(), &Session::progressed, this, &CollisionList::showPart);
    connect(&playhead(), &Playhead::selectionChanged, this, &CollisionList::followPlayhead);
    restyle();
    retranslate();
    showRun();
}

QWidget* CollisionList::makePage() {
    m_which->setObjectName(QStringLiteral("whichCollisions"));
    m_which->setAlignment(Qt::AlignCenter);
    auto* row = new QHBoxLayout(m_foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_earlier);
    row->addWidget(m_which, 1);
    row->addWidget(m_later);
    connect(m_earlier, &QAbstractButton::clicked, this,
            [this] { playhead().selectNumber(m_model->numberOf(0) - 1); });
    connect(m_later, &QAbstractButton::clicked, this,
            [this] { playhead().selectNumber(m_model->numberOf(m_model->rowCount())); });
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_table, 1);
    column->addWidget(m_foot);
    return page;
}

void CollisionList::retranslate() {
    m_table->setAccessibleName(tr("Collisions"));
    m_table->setToolTip(tr("Click a row to open that collision; Ctrl+C copies the rows with every digit"));
    m_empty->setText(tr("Nothing collides in this scene."));
    m_earlier->setWords(tr("The collisions before these"), tr("The collisions before these"));
    m_later->setWords(tr("The collisions after these"), tr("The collisions after these"));
    m_model->retranslate();
    fitColumns();
    showPart();
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
    // A style sheet takes a header's font away, and its height with it.
    header->setStyleSheet(QStringLiteral("QHeaderView::section { font-size: %1px; }")
                              .arg(appearance().pixels(Appearance::Size::Small)));
    header->setMinimumSectionSize(24);
    m_table->verticalHeader()->setMinimumSectionSize(24);
    m_table->verticalHeader()->setDefaultSectionSize(large ? 36 : 26);
    header->setSectionResizeMode(QHeaderView::Fixed);
    header->setSectionResizeMode(CollisionModel::Bodies, QHeaderView::Stretch);
    fitColumns();
    makeQuiet(*m_which, appearance());
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
        m_table->setColumnWidth(column, wide + 10);
    };
    const QString digits = countText(std::max<std::int64_t>(10, m_model->numberOf(m_model->rowCount() - 1)));
    fit(CollisionModel::Number, QString(digits.size(), u'0') + u'0'); // and the bracket
    const QModelIndex last = m_model->index(m_model->rowCount() - 1, CollisionModel::Time);
    fit(CollisionModel::Time, last.isValid() ? last.data().toString() : QStringLiteral("0.0000"));
    for (const int column : {CollisionModel::Impulse, CollisionModel::EnergyLoss})
        fit(column, widestText(column));
}

void CollisionList::showRun() {
    m_stale = false;
    m_following = true; // emptying the model moves its current row: that is nobody's choice
    m_model->setRun(session().run(), session().part().collisionsBefore);
    fitColumns();
    m_stack->setCurrentWidget(m_model->rowCount() ? m_page : m_empty);
    m_following = false;
    showPart();
    followPlayhead();
}

// While a run is played, chapters come and go: for nobody to see, none is kept here.
void CollisionList::showChapter() {
    if (isVisible())
        return showRun();
    m_stale = true;
    m_following = true;
    m_model->setRun(nullptr, 0);
    m_following = false;
}

void CollisionList::showEvent(QShowEvent* event) {
    if (m_stale)
        showRun();
    Panel::showEvent(event);
}

void CollisionList::showPart() {
    const RunPart part = session().part();
    const auto count = std::int64_t(session().timeline().collisions().size());
    const QString first = countText(part.collisionsBefore + 1),
                  last = countText(part.collisionsBefore + count);
    m_which->setText(part.ended
                         ? tr("Collisions %1 to %2 of %3").arg(first, last, countText(part.collisionCount))
                         : tr("Collisions %1 to %2").arg(first, last));
    m_earlier->setEnabled(part.collisionsBefore > 0);
    m_later->setEnabled(part.collisionsBefore + count < part.collisionCount);
    m_foot->setVisible(!part.isWhole());
}

void CollisionList::open(int row) {
    if (m_following || row < 0 || playhead().selected() == std::size_t(row))
        return;
    playhead().select(std::size_t(row));
}

void CollisionList::followPlayhead() {
    if (m_stale)
        return;
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
        if (stepBeyond(key->key()))
            return true;
        if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
            open(m_table->currentIndex().row());
            return true;
        }
    }
    return Panel::eventFilter(watched, event);
}

bool CollisionList::stepBeyond(int key) {
    const int edge = key == Qt::Key_Down ? m_model->rowCount() - 1 : 0;
    if ((key != Qt::Key_Down && key != Qt::Key_Up) || m_table->currentIndex().row() != edge ||
        playhead().selected() != std::size_t(edge))
        return false;
    playhead().stepCollisions(key == Qt::Key_Down ? 1 : -1);
    return true;
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
