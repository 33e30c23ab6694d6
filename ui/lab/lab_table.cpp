#include "ui/lab/lab_table.h"

#include "ui/lab/lab_plot.h"
#include "ui/lab/lab_words.h"
#include "ui/lab/line_sample.h"
#include "ui/words/glossary.h"
#include "ui/words/method_text.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QHeaderView>
#include <QResizeEvent>

#include <cmath>

namespace thetalane {

LabTable::LabTable(const Appearance& appearance, QWidget* parent)
    : QTableWidget(0, ColumnCount, parent)
    , m_appearance(appearance) {
    setObjectName(QStringLiteral("labTable"));
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setWordWrap(true);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    verticalHeader()->hide();
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionsClickable(false);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row >= 0)
            emit rowChosen(std::size_t(row));
    });
    connect(&appearance, &Appearance::changed, this, &LabTable::restyle);
    restyle();
    retranslate();
}

void LabTable::restyle() {
    const bool large = m_appearance.projector();
    setFont(m_appearance.font(Appearance::Size::Small));
    horizontalHeader()->setFont(m_appearance.font(Appearance::Size::Small));
    horizontalHeader()->setMinimumSectionSize(24);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    verticalHeader()->setMinimumSectionSize(large ? 36 : 26);
    setIconSize(lineSampleSize(m_appearance));
    fill();
}

void LabTable::retranslate() {
    setAccessibleName(tr("What each method costs, and how far off it is"));
    setToolTip(tr("Choose a row to bring its ghost to the front"));
    setHorizontalHeaderLabels({tr("Method"), tr("Cost"), tr("Off by"), tr("Same pins"), tr("Differs")});
    const QString tips[] = {
        tr("The way of computing"), tr("Processor time of one throw; beside it, to the first row"),
        tr("Position error at the end, median over the throws; on hover the rms and the worst"),
        tr("The same pins touched; where no pin is, the same bodies"),
        tr("The first contact that differs, and its time in the reference: median of the throws in which one "
           "does")};
    for (int c = 0; c < ColumnCount; ++c)
        horizontalHeaderItem(c)->setToolTip(tips[c]);
    horizontalHeaderItem(Name)->setData(termRole, QStringLiteral("engine"));
    horizontalHeaderItem(Error)->setData(termRole, QStringLiteral("error"));
    horizontalHeaderItem(Same)->setData(termRole, QStringLiteral("pinfall"));
    horizontalHeaderItem(Difference)->setData(termRole, QStringLiteral("sensitivity"));
    fill();
}

void LabTable::show(std::shared_ptr<const LabResult> result) {
    m_result = std::move(result);
    fill();
}

void LabTable::put(int row, int column, const QString& text, const QString& toolTip) {
    QTableWidgetItem* cell = item(row, column);
    if (!cell) {
        cell = new QTableWidgetItem;
        cell->setTextAlignment(Qt::AlignVCenter | (column == Name ? Qt::AlignLeft : Qt::AlignRight));
        setItem(row, column, cell);
    }
    cell->setText(text);
    cell->setToolTip(toolTip);
}

void LabTable::fillRow(std::size_t index) {
    const LabPlan& plan = *m_result->plan;
    const MethodResult& r = m_result->study.methods[index];
    const int row = int(index);
    const QString none = QStringLiteral("—");
    const QString name = keptTogether(rowName(plan, index));
    put(row, Name, name, name);
    item(row, Name)->setIcon(lineSample(rowStyle(plan, index), m_appearance));

    const bool costKnown = r.costRounds > 0 || r.state == MethodState::TooSlow;
    QString cost = costKnown && std::isfinite(r.cost.median) ? costText(r.cost.median) : none;
    if (r.state == MethodState::TooSlow)
        cost = tr("too slow");
    put(row, Cost, cost,
        r.costRounds > 0 ? tr("%1 to %2 (quartiles of %3 rounds); %4 times the first row")
                               .arg(costText(r.cost.lower), costText(r.cost.upper))
                               .arg(r.costRounds)
                               .arg(numberText(r.costRatio, 3))
                         : QString());
    if (r.state == MethodState::Refused) {
        put(row, Error, tr("refused"), refusalMessage(r.refusal));
        return;
    }
    const bool known = r.cases > 0;
    put(row, Error, known ? numberText(r.error().median, 2) + " m" : none,
        known ? tr("rms %1 m, worst %2 m").arg(numberText(r.error().rms, 3), numberText(r.error().worst, 3))
              : QString());
    put(row, Same, known ? percentText(r.sameTouched) : none,
        known
            ? tr("same pins down %1, same contacts %2").arg(percentText(r.sameDown), percentText(r.sameOrder))
            : QString());
    const bool differs = known && r.sameOrder < 1;
    put(row, Difference,
        differs ? tr("no. %1, %2 s")
                      .arg(int(r.firstDifference.median) + 1)
                      .arg(numberText(r.differenceTime.median, 3))
                : none,
        known ? tr("missed %1, repeated %2 a throw").arg(numberText(r.missed, 3), numberText(r.repeated, 3))
              : QString());
}

void LabTable::fill() {
    const QSignalBlocker silent(this);
    setRowCount(m_result ? int(m_result->study.methods.size()) : 0);
    for (int row = 0; row < rowCount(); ++row)
        fillRow(std::size_t(row));
    fit();
}

// The numbers as wide as they are. Where no room would be left for the names, the last column gives way.
void LabTable::fit() {
    const QFontMetrics metrics(font());
    int numbers = 0;
    for (int c = Cost; c < ColumnCount; ++c) {
        const QTableWidgetItem* head = horizontalHeaderItem(c);
        int wide = metrics.horizontalAdvance(head ? head->text() : QString());
        for (int row = 0; row < rowCount(); ++row)
            if (const QTableWidgetItem* cell = item(row, c))
                wide = std::max(wide, metrics.horizontalAdvance(cell->text()));
        setColumnWidth(c, wide + 22);
        numbers += wide + 22;
    }
    const int nameWidth = iconSize().width() + 7 * metrics.height();
    setColumnHidden(Difference, viewport()->width() - numbers < nameWidth);
    resizeRowsToContents();
    updateGeometry();
}

void LabTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fit();
}

QSize LabTable::sizeHint() const {
    return {300, horizontalHeader()->sizeHint().height() + verticalHeader()->length() + 2};
}

} // namespace thetalane
