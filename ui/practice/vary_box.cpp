#include "ui/practice/vary_box.h"

#include "ui/panels/icon_button.h"
#include "ui/panels/number_field.h"
#include "ui/practice/latest_job.h"
#include "ui/practice/vary_delegate.h"
#include "ui/practice/vary_model.h"
#include "ui/practice/vary_words.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

constexpr int valueCount = 13;

} // namespace

VaryBox::VaryBox(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_job(new LatestJob(this))
    , m_model(new VaryModel(this))
    , m_settled(new QTimer(this))
    , m_title(new QLabel(this))
    , m_hint(new QLabel(this))
    , m_quantities(new QComboBox(this))
    , m_fromText(new QLabel(this))
    , m_from(new NumberField(appearance(), QStringLiteral("varyFrom"), this))
    , m_toText(new QLabel(this))
    , m_to(new NumberField(appearance(), QStringLiteral("varyTo"), this))
    , m_message(new QLabel(this))
    , m_sentence(new QLabel(this))
    , m_table(new QTableView(this))
    , m_column(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("varyBox"));
    m_settled->setSingleShot(true);
    m_settled->setInterval(30);
    build();
    connect(m_quantities, &QComboBox::activated, this, [this] {
        takeRange();
        ask();
    });
    for (NumberField* field : {m_from, m_to}) {
        connect(field, &NumberField::edited, this, &VaryBox::ask);
        connect(field, &NumberField::becameUnreadable, this, &VaryBox::showMessage);
    }
    connect(&session(), &Session::runChanged, this, [this] { m_settled->start(); });
    connect(m_settled, &QTimer::timeout, this, &VaryBox::askIfSeen);
    connect(m_table, &QTableView::clicked, this, [this](const QModelIndex& at) { becomeThrow(at.row()); });
    m_quantities->setCurrentIndex(int(ThrowQuantity::Speed));
    takeRange();
    restyle();
    retranslate();
}

void VaryBox::build() {
    const std::pair<QLabel*, const char*> labels[] = {{m_title, "varyTitle"},
                                                      {m_hint, "varyHint"},
                                                      {m_message, "varyMessage"},
                                                      {m_sentence, "varySentence"}};
    for (const auto& [label, name] : labels) {
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
    }
    m_quantities->setObjectName(QStringLiteral("varyQuantity"));
    for (int q = 0; q < throwQuantities; ++q)
        m_quantities->addItem(QString(), q);
    m_table->setObjectName(QStringLiteral("varyTable"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new VaryDelegate(appearance(), m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionsClickable(false);
    m_table->installEventFilter(this);
    auto* grid = new QGridLayout;
    grid->addWidget(m_quantities, 0, 0, 1, 4);
    grid->addWidget(new IconMark(appearance(), Icon::Down, this), 0, 0, 1, 4,
                    Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(m_fromText, 1, 0);
    grid->addWidget(m_from, 1, 1);
    grid->addWidget(m_toText, 1, 2);
    grid->addWidget(m_to, 1, 3);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_title);
    m_column->addWidget(m_hint);
    m_column->addLayout(grid);
    m_column->addWidget(m_message);
    m_column->addWidget(m_sentence);
    m_column->addWidget(m_table);
}

ThrowQuantity VaryBox::quantity() const {
    return ThrowQuantity(std::max(0, m_quantities->currentIndex()));
}

void VaryBox::choose(ThrowQuantity quantity) {
    m_quantities->setCurrentIndex(int(quantity));
    takeRange();
    ask();
}

bool VaryBox::running() const {
    return m_job->running() || m_settled->isActive();
}

void VaryBox::takeRange() {
    const Throw present = session().currentThrow().value_or(Throw{});
    const ShownRange range =
        usualRange(quantity(), shownQuantity(quantity(), quantityOf(present, quantity())));
    setTerm(m_quantities, throwQuantityTerm(quantity()));
    for (NumberField* field : {m_from, m_to}) {
        field->setStep(range.step);
        field->setUnit(throwQuantityUnit(quantity()));
    }
    m_from->setValue(range.from);
    m_to->setValue(range.to);
}

VarySettings VaryBox::settings() const {
    VarySettings s;
    if (session().currentThrow()) {
        s.base = *session().currentThrow();
        s.standing = session().standing();
        s.lane = session().laneConditions();
    }
    s.quantity = quantity();
    s.values = variedValues(quantityFromShown(s.quantity, m_from->value()),
                            quantityFromShown(s.quantity, m_to->value()), valueCount,
                            quantityOf(s.base, s.quantity));
    return s;
}

bool VaryBox::isSound() const {
    return m_from->unreadable().isEmpty() && m_to->unreadable().isEmpty() && m_from->value() < m_to->value();
}

void VaryBox::showMessage() {
    QString text = m_from->unreadable();
    if (text.isEmpty())
        text = m_to->unreadable();
    if (text.isEmpty() && !(m_from->value() < m_to->value()))
        text = tr("The range must begin below its end.");
    m_from->setWrong(!text.isEmpty());
    m_to->setWrong(!text.isEmpty());
    m_message->setText(text);
    makeMessage(*m_message, appearance());
}

void VaryBox::showEvent(QShowEvent* event) {
    ask();
    Panel::showEvent(event);
}

void VaryBox::askIfSeen() {
    if (isVisible())
        ask();
}

void VaryBox::ask() {
    showMessage();
    if (!isSound())
        return;
    m_job->start([this, s = settings()](const std::stop_token& stop) -> LatestJob::Answer {
        return [this, s, outcomes = varyThrow(s, {}, stop)] { take(s, outcomes); };
    });
}

void VaryBox::take(const VarySettings& asked, std::vector<VariedThrow> outcomes) {
    m_model->setOutcomes(asked, std::move(outcomes));
    fitTable();
    showSentence();
    const int present = m_model->presentRow();
    if (present >= 0)
        m_table->setCurrentIndex(m_model->index(present, 0));
    emit outcomesShown();
}

// Its own click or key: the throw of the window becomes this one, at the same pins.
void VaryBox::becomeThrow(int row) {
    if (row < 0 || row >= m_model->rowCount() || !m_model->outcomes()[std::size_t(row)].possible)
        return;
    const VarySettings s = settings();
    const Throw chosen = m_model->outcomes()[std::size_t(row)].ballThrow;
    playhead().setPlaying(false);
    session().setDelivery(chosen, s.standing, s.lane);
}

bool VaryBox::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            becomeThrow(m_table->currentIndex().row());
            return true;
        }
    }
    return Panel::eventFilter(watched, event);
}

// All rows at once: the panel scrolls, not the table in it.
void VaryBox::fitTable() {
    const int rows = m_model->rowCount() * m_table->verticalHeader()->defaultSectionSize();
    m_table->setFixedHeight(rows + m_table->horizontalHeader()->sizeHint().height() + 2);
}

void VaryBox::showSentence() {
    const auto& all = m_model->outcomes();
    const auto possible =
        std::count_if(all.begin(), all.end(), [](const VariedThrow& v) { return v.possible; });
    const auto cleared =
        std::count_if(all.begin(), all.end(), [](const VariedThrow& v) { return v.clears(); });
    const bool rack = !session().currentThrow() || session().standing().all();
    QString text;
    if (!all.empty())
        text = rack ? tr("%1 of %2 throws strike.").arg(cleared).arg(possible)
                    : tr("%1 of %2 throws clear the pins.").arg(cleared).arg(possible);
    m_sentence->setText(text);
}

void VaryBox::retranslate() {
    m_title->setText(tr("What changes if …"));
    m_hint->setText(
        tr("The same throw with one attribute varied. The present value is marked; click a row to "
           "make it the throw."));
    for (int q = 0; q < throwQuantities; ++q)
        m_quantities->setItemText(q, throwQuantityName(ThrowQuantity(q)));
    m_quantities->setAccessibleName(tr("Attribute to vary"));
    m_quantities->setToolTip(tr("Which attribute of the throw changes from row to row"));
    m_fromText->setText(tr("from"));
    m_toText->setText(tr("to"));
    m_from->setWords(tr("From"), tr("The first value"));
    m_to->setWords(tr("To"), tr("The last value"));
    m_table->setAccessibleName(tr("Outcomes"));
    m_table->setToolTip(tr("Click a row, or press Enter on it, to make it the throw"));
    m_model->retranslate();
    showMessage();
    showSentence();
}

void VaryBox::restyle() {
    Panel::restyle();
    const Appearance& a = appearance();
    m_column->setSpacing(a.unit());
    m_title->setFont(a.font(Appearance::Size::Large, true));
    makeQuiet(*m_hint, a);
    for (QWidget* w :
         std::initializer_list<QWidget*>{m_quantities, m_fromText, m_toText, m_sentence, m_table})
        w->setFont(a.font(Appearance::Size::Normal));
    m_table->horizontalHeader()->setFont(a.font(Appearance::Size::Small));
    m_table->verticalHeader()->setDefaultSectionSize(a.projector() ? 56 : 38);
    fitTable();
    showMessage();
}

} // namespace thetalane
