#include "ui/lab/ghost_box.h"

#include "ui/lab/ghost_view.h"
#include "ui/lab/lab_plot.h"
#include "ui/lab/lab_words.h"
#include "ui/lab/line_sample.h"
#include "ui/panels/panel.h"
#include "ui/panels/value_slider.h"
#include "ui/words/number_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace thetalane {

GhostBox::GhostBox(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance)
    , m_view(new GhostView(appearance, this))
    , m_slider(new ValueSlider(appearance, QStringLiteral("ghostTime"), this))
    , m_time(new QLabel(this))
    , m_story(new QLabel(this))
    , m_column(new QVBoxLayout(this)) {
    m_story->setObjectName(QStringLiteral("ghostStory"));
    m_story->setWordWrap(true);
    m_story->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_time->setObjectName(QStringLiteral("ghostTimeText"));
    auto* bar = new QHBoxLayout;
    bar->addWidget(m_slider, 1);
    bar->addWidget(m_time);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_view);
    m_column->addLayout(bar);
    m_column->addWidget(m_story);
    connect(m_slider, &ValueSlider::numberEdited, this, &GhostBox::setTime);
    connect(m_view, &GhostView::picked, this, &GhostBox::open);
    connect(&appearance, &Appearance::changed, this, &GhostBox::restyle);
    restyle();
    retranslate();
}

void GhostBox::restyle() {
    m_column->setSpacing(m_appearance.unit() / 2);
    m_time->setFont(m_appearance.font(Appearance::Size::Normal));
    m_time->setMinimumWidth(m_appearance.unit() * 9);
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_story->setFont(m_appearance.font(Appearance::Size::Normal));
    for (QPushButton* entry : m_legend)
        entry->setIconSize(lineSampleSize(m_appearance));
    nameLegend();
}

void GhostBox::retranslate() {
    m_view->setWords(tr("The same throw under each method; a mark stands where one leaves the truth"),
                     tr("The same throw under each method will be drawn here."));
    m_slider->setWords(tr("Time of the drawing"), tr("Moves all of them through the time"));
    nameLegend();
    describe();
}

void GhostBox::show(std::shared_ptr<const LabResult> result) {
    const Ghosts* before = ghosts();
    m_result = std::move(result);
    m_view->show(m_result);
    if (ghosts() == before)
        return;
    m_open.reset();
    makeLegend();
    setEnabled(ghosts() != nullptr);
    if (ghosts()) {
        const double end = ghosts()->lastShown();
        m_slider->setSpan(0, end, end / 400, 0);
        setTime(ghosts()->shownAt);
        m_slider->setNumber(ghosts()->shownAt);
    }
    describe();
}

void GhostBox::makeLegend() {
    const std::size_t count = ghosts() ? ghosts()->all.size() : 0;
    while (m_legend.size() > count) {
        m_legend.back()->hide();
        m_legend.back()->deleteLater();
        m_legend.pop_back();
    }
    while (m_legend.size() < count) {
        const std::size_t ghost = m_legend.size();
        auto* entry = new QPushButton(this);
        entry->setObjectName(QStringLiteral("ghost%1").arg(ghost));
        entry->setProperty("chooser", true);
        entry->setCheckable(true);
        entry->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // what does not fit is elided
        entry->setIconSize(lineSampleSize(m_appearance));
        connect(entry, &QPushButton::clicked, this, [this, ghost] { open(ghost); });
        m_column->insertWidget(2 + int(ghost), entry);
        m_legend.push_back(entry);
    }
    nameLegend();
}

void GhostBox::nameLegend() {
    for (std::size_t k = 0; ghosts() && k < m_legend.size(); ++k) {
        const Ghost& ghost = ghosts()->all[k];
        const QString text = ghostShortText(*m_result->plan, ghost);
        const int room = width() - lineSampleSize(m_appearance).width() - 3 * m_appearance.unit();
        m_legend[k]->setText(m_legend[k]->fontMetrics().elidedText(text, Qt::ElideMiddle, room));
        m_legend[k]->setIcon(lineSample(rowStyle(*m_result->plan, ghost.row), m_appearance));
        m_legend[k]->setToolTip(text + '\n' + tr("Press to go to that instant"));
        m_legend[k]->setAccessibleName(text);
        m_legend[k]->setChecked(m_open == k);
    }
}

void GhostBox::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    nameLegend();
}

void GhostBox::open(std::size_t ghost) {
    m_open = ghost;
    m_view->setLit(ghost);
    const auto& parting = ghosts()->all[ghost].parting;
    const double time = parting ? parting->time : ghosts()->shownAt;
    m_slider->setNumber(time);
    setTime(time);
    nameLegend();
    describe();
    emit rowChosen(ghosts()->all[ghost].row);
}

void GhostBox::light(std::optional<std::size_t> row) {
    m_open.reset();
    for (std::size_t k = 0; ghosts() && row && k < ghosts()->all.size(); ++k)
        if (ghosts()->all[k].row == *row)
            m_open = k;
    m_view->setLit(m_open);
    nameLegend();
    describe();
}

void GhostBox::setTime(double time) {
    m_view->setTime(time);
    m_time->setText(numberText(time, 3) + " s");
}

void GhostBox::describe() {
    QString text;
    if (ghosts() && m_open)
        text = ghostText(*m_result, ghosts()->all[*m_open]);
    else if (ghosts())
        text = tr("Grey: what should happen. Choose a line or a mark to see where it leaves.");
    m_story->setText(keptTogether(text));
    m_story->setVisible(!text.isEmpty());
}

} // namespace thetalane
