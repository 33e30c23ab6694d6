#include "ui/lab/lab_panel.h"

#include "ui/lab/ghost_box.h"
#include "ui/lab/lab_table.h"
#include "ui/lab/lab_words.h"
#include "ui/lab/line_sample.h"
#include "ui/lab/method_choice.h"
#include "ui/lab/preset_row.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/value_row.h"
#include "ui/plot/plot_view.h"
#include "ui/words/number_text.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

constexpr double longestOwn = 30; // of a scene in the window [s]

} // namespace

LabPanel::LabPanel(const Context& context, QWidget* parent, double share)
    : Panel(context, parent)
    , m_share(share)
    , m_worker(new LabWorker(this)) {
    setObjectName(QStringLiteral("labPanel"));
    build(context);
    connect(m_worker, &LabWorker::news, this, &LabPanel::take);
    connect(m_presets, &PresetRow::presetChosen, this, &LabPanel::choose);
    connect(m_presets, &PresetRow::ownChosen, this, &LabPanel::chooseOwn);
    connect(m_methods, &MethodChoice::runAsked, this, &LabPanel::runOwn);
    connect(m_settled, &QTimer::timeout, this, &LabPanel::runDials);
    connect(&session(), &Session::runChanged, this, [this] {
        if (m_plan && !m_plan->preset) // it was about another scene
            drop();
    });
    connect(m_stop, &QPushButton::clicked, this, &LabPanel::stopOrAgain);
    connect(m_diagrams, &QComboBox::activated, this, &LabPanel::showPlot);
    connect(m_plot, &PlotView::picked, this, &LabPanel::pointPicked);
    connect(m_table, &LabTable::rowChosen, this, [this](std::size_t row) { m_ghosts->light(row); });
    connect(m_ghosts, &GhostBox::rowChosen, this, [this](std::size_t row) {
        const QSignalBlocker silent(m_table); // the ghost is lit already
        m_table->selectRow(int(row));
    });
    restyle();
    retranslate();
}

void LabPanel::build(const Context& context) {
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    auto* inside = new QWidget(scroll);
    m_column = new QVBoxLayout(inside);
    m_presets = new PresetRow(context, inside);
    m_hint = new QLabel(inside);
    m_hint->setObjectName(QStringLiteral("labHint"));
    m_hint->setWordWrap(true);
    m_methods = new MethodChoice(context, inside);
    m_methods->hide();
    m_sentence = new QLabel(inside);
    m_sentence->setObjectName(QStringLiteral("labSentence"));
    m_sentence->setWordWrap(true);
    m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_ghosts = new GhostBox(appearance(), inside);
    m_table = new LabTable(appearance(), inside);
    m_settled = new QTimer(this);
    m_settled->setSingleShot(true);
    m_settled->setInterval(150);
    m_column->addWidget(m_presets);
    m_column->addWidget(m_hint);
    m_column->addWidget(makeDials());
    m_column->addWidget(m_methods);
    m_column->addWidget(makeProgress());
    m_column->addWidget(m_sentence);
    m_column->addWidget(m_ghosts);
    m_column->addWidget(makeDiagram());
    m_column->addWidget(m_table);
    m_column->addStretch(1);
    for (QWidget* w : {static_cast<QWidget*>(m_sentence), static_cast<QWidget*>(m_ghosts), m_diagram,
                       static_cast<QWidget*>(m_table), m_progress, m_dials})
        w->hide();
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
}

QWidget* LabPanel::makeDials() {
    m_dials = new QWidget(this);
    const LabDials first;
    m_speed = new ValueRow(appearance(), QStringLiteral("labSpeed"), {1, 60, 0.5, 1}, "m/s", m_dials);
    m_perSecond = new ValueRow(appearance(), QStringLiteral("labSteps"), {10, 240, 1, 10}, "1/s", m_dials);
    m_speed->setValue(first.speed);
    m_perSecond->setValue(first.perSecond);
    m_speed->setTerm("speed");
    m_perSecond->setTerm("time-step");
    auto* layout = new QVBoxLayout(m_dials);
    layout->setContentsMargins(0, 0, 0, 0);
    for (ValueRow* row : {m_speed, m_perSecond}) {
        layout->addWidget(row);
        connect(row, &ValueRow::edited, m_settled, qOverload<>(&QTimer::start));
    }
    return m_dials;
}

QWidget* LabPanel::makeProgress() {
    m_progress = new QWidget(this);
    m_bar = new QProgressBar(m_progress);
    m_bar->setObjectName(QStringLiteral("labProgress"));
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_state = new QLabel(m_progress);
    m_state->setObjectName(QStringLiteral("labState"));
    m_state->setWordWrap(true);
    m_stop = new QPushButton(m_progress);
    m_stop->setObjectName(QStringLiteral("labStop"));
    auto* words = new QVBoxLayout;
    words->addWidget(m_state);
    words->addWidget(m_bar);
    auto* layout = new QHBoxLayout(m_progress);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(words, 1);
    layout->addWidget(m_stop);
    return m_progress;
}

QWidget* LabPanel::makeDiagram() {
    m_diagram = new QWidget(this);
    m_diagrams = new QComboBox(m_diagram);
    m_diagrams->setObjectName(QStringLiteral("labDiagram"));
    m_plot = new PlotView(m_diagram);
    m_plot->setObjectName(QStringLiteral("labPlot"));
    auto* layout = new QGridLayout(m_diagram);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_diagrams, 0, 0);
    auto* mark = new QHBoxLayout(m_diagrams); // which is hidden where there is one diagram
    mark->setContentsMargins(0, 0, 0, 0);
    mark->addWidget(new IconMark(appearance(), Icon::Down, m_diagrams), 0, Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(m_plot, 1, 0);
    return m_diagram;
}

void LabPanel::retranslate() {
    QString hint = QStringLiteral("<p>") +
                   tr("Press a question: it is measured on this machine, and answered with what was found.") +
                   QStringLiteral("</p>");
    for (int k = 0; k < presetCount; ++k)
        hint += QStringLiteral("<p><b>%1</b><br>%2</p>")
                    .arg(presetName(Preset(k)).toHtmlEscaped(), presetQuestion(Preset(k)).toHtmlEscaped());
    m_hint->setText(hint);
    m_speed->setWords(tr("Speed of the ball"), tr("How fast the ball comes at the pin"));
    m_perSecond->setWords(tr("Steps per second, 1/h"), tr("How often the paper's loop looks for overlap"));
    m_bar->setAccessibleName(tr("Progress of the measurement"));
    m_bar->setToolTip(m_bar->accessibleName());
    m_diagrams->setAccessibleName(tr("Diagram"));
    m_diagrams->setToolTip(tr("What the diagram shows"));
    m_plot->setAccessibleName(tr("Diagram of the measurement; the table below holds the same numbers"));
    m_ghosts->retranslate();
    m_table->retranslate();
    nameDiagrams();
    showProgress();
    showPlot();
    m_sentence->setText(m_result ? keptTogether(labSentence(*m_result)) : QString());
}

void LabPanel::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    const int unit = look.unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit * 3 / 2);
    makeQuiet(*m_hint, look);
    m_hint->setFont(look.font(Appearance::Size::Normal));
    makeQuiet(*m_state, look);
    m_sentence->setFont(look.font(Appearance::Size::Large));
    m_stop->setFont(look.font(Appearance::Size::Normal));
    m_diagrams->setFont(look.font(Appearance::Size::Normal));
    m_bar->setFixedHeight(unit);
    m_bar->setStyleSheet(QStringLiteral("QProgressBar { border: none; border-radius: 3px; background: %1; }"
                                        "QProgressBar::chunk { border-radius: 3px; background: %2; }")
                             .arg(look.line().name(), look.accent().name()));
    m_plot->setFixedHeight(look.projector() ? 420 : 300);
    PlotStyle style;
    style.font = look.font(Appearance::Size::Small);
    style.text = look.text();
    style.quiet = look.quietText();
    style.grid = look.line();
    style.paper = look.card();
    style.lineWidth = look.lineWidth();
    style.locale = QLocale::c();
    m_plot->setStyle(style);
    showPlot();
}

void LabPanel::choose(Preset preset) {
    m_presets->setChosen(int(preset));
    m_methods->hide();
    LabDials dials;
    if (preset == Preset::Through)
        dials = {m_speed->value(), m_perSecond->value()};
    start(presetPlan(preset, dials, m_share));
}

void LabPanel::runDials() {
    const bool sound = m_speed->value() > 0 && m_perSecond->value() > 0 && m_speed->value() <= 1000 &&
                       m_perSecond->value() <= 1e5 && m_perSecond->value() >= 0.1;
    m_speed->setMessage(m_speed->value() > 0 && m_speed->value() <= 1000
                            ? QString()
                            : tr("must be greater than 0 and at most 1000"));
    m_perSecond->setMessage(m_perSecond->value() >= 0.1 && m_perSecond->value() <= 1e5
                                ? QString()
                                : tr("must be from 0.1 to 100000"));
    if (sound)
        choose(Preset::Through);
}

void LabPanel::chooseOwn() {
    m_presets->setChosen(presetCount);
    m_hint->hide();
    m_dials->hide();
    m_methods->show();
    if (m_plan && m_plan->preset) // what was found about this scene stays
        drop();
}

void LabPanel::drop() {
    m_worker->cancel();
    m_plan.reset();
    clear();
    m_progress->hide();
}

void LabPanel::clear() {
    m_result.reset();
    m_sentence->hide();
    m_diagram->hide();
    m_table->hide();
    m_ghosts->show(std::shared_ptr<const LabResult>());
    m_ghosts->hide();
}

void LabPanel::runOwn() {
    const double until = std::min(longestOwn, session().shownUntil());
    start(ownPlan(session().scene(), until, m_methods->chosen()));
}

void LabPanel::start(LabPlan plan) {
    const bool other = !m_plan || m_plan->preset != plan.preset;
    m_plan = std::make_shared<const LabPlan>(std::move(plan));
    m_hint->hide();
    m_dials->setVisible(m_plan->preset == Preset::Through);
    m_progress->show();
    m_worker->start(m_plan);
    if (!other) // what was there stays until there is something new
        return showProgress();
    clear();
    m_diagrams->clear();
    for (const Diagram d : diagramsOf(*m_plan))
        m_diagrams->addItem(QString(), int(d));
    nameDiagrams();
    m_diagrams->setVisible(m_diagrams->count() > 1);
    showProgress();
}

void LabPanel::take(std::shared_ptr<const LabResult> result) {
    if (result->plan != m_plan)
        return;
    m_result = std::move(result);
    const QString sentence = keptTogether(labSentence(*m_result));
    m_sentence->setText(sentence);
    m_sentence->setVisible(!sentence.isEmpty());
    m_ghosts->show(m_result);
    m_ghosts->setVisible(m_result->ghosts != nullptr);
    m_table->show(m_result);
    m_table->setVisible(true);
    showPlot();
    const bool anyPoint = std::any_of(m_result->study.methods.begin(), m_result->study.methods.end(),
                                      [](const MethodResult& m) { return m.cases > 0; });
    m_diagram->setVisible(anyPoint);
    showProgress();
    emit resultShown();
}

void LabPanel::showProgress() {
    const bool mine = m_result && m_result->plan == m_plan;
    m_stop->setText(running() ? tr("Cancel") : tr("Again"));
    m_stop->setToolTip(running() ? tr("Stops, and keeps what is measured so far") : tr("Measures once more"));
    m_stop->setAccessibleName(m_stop->text());
    m_bar->setVisible(running());
    m_bar->setValue(mine ? int(1000 * m_result->part) : 0);
    m_state->setText(mine ? labState(*m_result) : tr("Begins …"));
}

void LabPanel::stopOrAgain() {
    if (running())
        m_worker->cancel();
    else if (m_plan)
        start(LabPlan(*m_plan));
}

void LabPanel::nameDiagrams() {
    for (int k = 0; m_plan && k < m_diagrams->count(); ++k)
        m_diagrams->setItemText(k, diagramName(*m_plan, Diagram(m_diagrams->itemData(k).toInt())));
}

Diagram LabPanel::diagram() const {
    return Diagram(m_diagrams->currentData().toInt());
}

void LabPanel::showPlot() {
    if (!m_result || m_diagrams->count() == 0)
        return;
    m_shown = labPlot(*m_result, diagram());
    for (PlotSeries& series : m_shown.plot.series)
        series.colour = seenColour(series.colour, appearance());
    m_plot->setPlot(m_shown.plot);
}

void LabPanel::pointPicked(std::size_t series, std::size_t point) {
    if (const auto row = m_shown.rows.at(series).at(point))
        m_table->selectRow(int(*row));
}

} // namespace thetalane
