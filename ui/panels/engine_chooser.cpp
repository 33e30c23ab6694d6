#include "ui/panels/engine_chooser.h"

#include "ui/panels/icon_button.h"
#include "ui/words/glossary.h"
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
    double step;          // [s]; of no meaning to the exact one
    bool approachingOnly; // of the paper's loop
};

constexpr std::array choices{
    Choice{EngineKind::Event, 0, false}, Choice{EngineKind::Stepped, 1.0 / 60, false},
    Choice{EngineKind::Stepped, 1.0 / 1000, false}, Choice{EngineKind::Stepped, 1.0 / 60, true},
    Choice{EngineKind::Swept, 1.0 / 60, false}};

bool isOf(const EngineSettings& s, const Choice& c) {
    if (s.kind != c.kind)
        return false;
    switch (c.kind) {
    case EngineKind::Event:
        return s.ties;
    case EngineKind::Stepped:
        return s.step == c.step && s.approachingOnly == c.approachingOnly;
    case EngineKind::Swept:
        break;
    }
    return s.step == c.step && s.passes == 1;
}

int indexOf(const EngineSettings& settings) {
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (isOf(settings, choices[i]))
            return int(i);
    return -1;
}

EngineSettings with(EngineSettings s, const Choice& c) {
    s.kind = c.kind;
    s.ties = s.ties || c.kind == EngineKind::Event;
    if (c.kind != EngineKind::Event)
        s.step = c.step;
    if (c.kind == EngineKind::Stepped)
        s.approachingOnly = c.approachingOnly;
    if (c.kind == EngineKind::Swept)
        s.passes = 1;
    return s;
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
        tr("How contacts are found: exactly, from one to the next; by the paper's loop, which moves "
           "everything by a fixed step and then tests for overlap; or by swept steps, which look for the "
           "instant of contact within a step, but see what a body hits next only in the step after"));
    for (int i = 0; i < m_combo->count(); ++i)
        m_combo->setItemText(i, engineText(with({}, choices[std::size_t(i)])));
    showCurrent();
}

QString EngineChooser::engineText(const EngineSettings& s) {
    const QString step = stepText(s.step);
    switch (s.kind) {
    case EngineKind::Event:
        return s.ties ? tr("Exact (next event)") : tr("Next event, one contact at a time");
    case EngineKind::Stepped:
        return (s.approachingOnly ? tr("Paper's loop, %1, approaching only") : tr("Paper's loop, %1"))
            .arg(step);
    case EngineKind::Swept:
        break;
    }
    return s.passes == 1 ? tr("Swept steps, %1").arg(step)
                         : tr("Swept steps, %1, passes: %2").arg(step).arg(s.passes);
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
    m_combo->setPlaceholderText(engineText(settings));
    m_combo->setCurrentIndex(indexOf(settings));
    setTerm(m_combo, settings.kind == EngineKind::Event     ? "next-event"
                     : settings.kind == EngineKind::Stepped ? "papers-loop"
                                                            : "swept-steps");
}

void EngineChooser::choose(int index) {
    const EngineSettings settings = with(session().run()->settings, choices[std::size_t(index)]);
    if (settings == session().run()->settings)
        return;
    if (const auto refusal = session().setEngine(settings)) {
        showCurrent();
        QToolTip::showText(m_combo->mapToGlobal(QPoint(0, m_combo->height())), refusalMessage(*refusal),
                           m_combo);
    }
}

} // namespace thetalane
