#include "ui/lab/preset_row.h"

#include "ui/lab/lab_words.h"
#include "ui/words/glossary.h"

#include <QGridLayout>
#include <QPushButton>

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

// What each of them is about; the last one the scene in the window.
constexpr std::array<const char*, presetCount + 1> terms{
    "tunnelling", "papers-loop", "time-step", "floating-point", "friction", "sensitivity", "engine"};

} // namespace

PresetRow::PresetRow(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_grid(new QGridLayout(this)) {
    setObjectName(QStringLiteral("presetRow"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    for (int k = 0; k <= presetCount; ++k) {
        auto* button = new QPushButton(this);
        button->setObjectName(k < presetCount ? QStringLiteral("preset%1").arg(k)
                                              : QStringLiteral("ownScene"));
        button->setProperty("preset", true);
        setTerm(button, terms[std::size_t(k)]);
        button->setCheckable(true);
        connect(button, &QPushButton::clicked, this, [this, k] {
            setChosen(k);
            if (k < presetCount)
                emit presetChosen(Preset(k));
            else
                emit ownChosen();
        });
        m_buttons.push_back(button);
    }
    restyle();
    retranslate();
}

void PresetRow::setChosen(std::optional<int> index) {
    for (int k = 0; k < int(m_buttons.size()); ++k)
        m_buttons[std::size_t(k)]->setChecked(index == k);
}

void PresetRow::retranslate() {
    for (int k = 0; k < presetCount; ++k) {
        m_buttons[std::size_t(k)]->setText(presetName(Preset(k)));
        m_buttons[std::size_t(k)]->setToolTip(presetQuestion(Preset(k)));
    }
    m_buttons.back()->setText(tr("The scene in the window"));
    m_buttons.back()->setToolTip(tr("Methods of your choice on the scene in the window"));
    for (QPushButton* b : m_buttons)
        b->setAccessibleName(b->text());
    m_columns = 0;
    arrange();
}

void PresetRow::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    setStyleSheet(styleSheet() +
                  QStringLiteral("QPushButton[preset=\"true\"]:checked { background: %1; color: %2; "
                                 "border-color: %1; }"
                                 "QPushButton[preset=\"true\"]:checked:focus { border: 2px solid %3; }")
                      .arg(look.accent().name(), look.card().name(), look.text().name()));
    m_grid->setSpacing(look.unit() / 2);
    for (QPushButton* b : m_buttons) {
        b->setFont(look.font(Appearance::Size::Normal));
        b->setMinimumHeight(look.projector() ? 44 : 30);
    }
    m_columns = 0;
    arrange();
}

void PresetRow::arrange() {
    int widest = 1;
    for (const QPushButton* b : m_buttons)
        widest = std::max(widest, b->sizeHint().width());
    const int columns = std::clamp((width() + m_grid->spacing()) / (widest + m_grid->spacing()), 1, 3);
    if (columns == m_columns)
        return;
    m_columns = columns;
    for (int k = 0; k < presetCount; ++k)
        m_grid->addWidget(m_buttons[std::size_t(k)], k / columns, k % columns);
    m_grid->addWidget(m_buttons.back(), (presetCount + columns - 1) / columns, 0, 1, columns);
    for (int c = 0; c < 3; ++c)
        m_grid->setColumnStretch(c, c < columns ? 1 : 0);
    updateGeometry();
}

void PresetRow::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    arrange();
}

} // namespace thetalane
