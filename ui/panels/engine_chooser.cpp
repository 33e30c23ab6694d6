#include "ui/panels/engine_chooser.h"

#include "ui/panels/icon_button.h"
#include "ui/words/number_text.h"
#include "ui/words/scene_text.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QGridLayout>
#include <QToolTip>

#include <array>
#include <cmath>

namespace thetalane {
namespace {

struct Choice {
    EngineKind kind;
    double step; // [s]; of no meaning to the exact one
    bool approachingOnly;
};

constexpr std::array choices{
    Choice{EngineKind::Event, 0, false}, Choice{EngineKind::Stepped, 1.0 / 60, false},
    Choice{EngineKind::Stepped, 1.0 / 1000, false}, Choice{EngineKind::Stepped, 1.0 / 60, true}};

int indexOf(const EngineSettings& settings) {
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const Choice& c = choices[i];
        if (c.kind == settings.kind &&
            (c.kind == EngineKind::Event ||
             (c.step == settings.step && c.approachingOnly == settings.approachingOnly)))
            return int(i);
    }
    return -1;
}

QString stepText(double step) {
    const double parts = 1 / step;
    const bool whole = std::abs(parts - std::round(parts)) < 1e-9 * parts;
    return whole ? QStringLiteral("1/%1 s").arg(std::llround(parts)) : numberText(step) + " s";
}

} // namespace

EngineChooser::EngineChooser(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_combo(new QComboBox(this)) {
    m_combo->setObjectName(QStringLiteral("engineCombo"));
    m_combo->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    for (std::size_t i = 0; i < choices.size(); ++i)
        m_combo->addItem({});
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_combo, 0, 0);
    layout->addWidget(new IconMark(appearance(), Icon::Down, this), 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    connect(m_combo, &QComboBox::activated, this, &EngineChooser::choose);
    connect(&session(), &Session::runChanged, this, &EngineChooser::showCurrent);
    restyle();
    retranslate();
}

void EngineChooser::retranslate() {
    m_combo->setAccessibleName(tr("Way of computing"));
    m_combo->setToolTip(
        tr("How contacts are found: exactly, from one to the next, or by the paper's loop, which moves "
           "everything by a fixed step and then tests for overlap"));
    m_combo->setItemText(0, tr("Exact (next event)"));
    for (int i = 1; i < m_combo->count(); ++i) {
        const Choice& c = choices[std::size_t(i)];
        m_combo->setItemText(
            i, (c.approachingOnly ? tr("Paper's loop, %1, approaching only") : tr("Paper's loop, %1"))
                   .arg(stepText(c.step)));
    }
    showCurrent();
}

void EngineChooser::restyle() {
    Panel::restyle();
    m_combo->setFont(appearance().font(Appearance::Size::Normal));
    m_combo->view()->setFont(m_combo->font());
    m_combo->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_combo->setMinimumWidth(appearance().unit() * 16); // may be narrower than its longest entry
}

void EngineChooser::showCurrent() {
    const EngineSettings& settings = session().run()->settings;
    m_combo->setPlaceholderText(tr("Paper's loop, %1").arg(stepText(settings.step)));
    m_combo->setCurrentIndex(indexOf(settings));
}

void EngineChooser::choose(int index) {
    EngineSettings settings = session().run()->settings;
    const Choice& choice = choices[std::size_t(index)];
    settings.kind = choice.kind;
    if (choice.kind == EngineKind::Stepped) {
        settings.step = choice.step;
        settings.approachingOnly = choice.approachingOnly;
    }
    if (settings == session().run()->settings)
        return;
    if (const auto refusal = session().setEngine(settings)) {
        showCurrent();
        QToolTip::showText(m_combo->mapToGlobal(QPoint(0, m_combo->height())), refusalMessage(*refusal),
                           m_combo);
    }
}

} // namespace thetalane
