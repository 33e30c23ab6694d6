#include "ui/lab/method_choice.h"

#include "ui/lab/flow_layout.h"
#include "ui/lab/lab_plan.h"
#include "ui/words/glossary.h"
#include "ui/words/method_text.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

// Every method that some scene offers: all models can be left out of a whole lane.
std::vector<Method> allMethods() {
    return ownMethods(laneThrows(1).scenes.front());
}

bool isOffered(const Method& method, const Scene& scene) {
    return std::all_of(method.without.begin(), method.without.end(),
                       [&](Model model) { return hasModel(scene, model); });
}

bool areOfOneFamily(const Method& a, const Method& b) {
    return a.settings.kind == b.settings.kind && a.settings.approachingOnly == b.settings.approachingOnly &&
           a.without.empty() == b.without.empty();
}

QString shortName(const Method& method) {
    if (!method.without.empty())
        return modelText(method.without.front());
    if (method.settings.kind == EngineKind::Event)
        return precisionText(method.settings.precision);
    const QString step = stepText(method.settings.step);
    return method.settings.passes > 1 ? QStringLiteral("%1 × %2").arg(step).arg(method.settings.passes)
                                      : step;
}

const char* termOf(const Method& method) {
    switch (method.settings.kind) {
    case EngineKind::Event:
        return "next-event";
    case EngineKind::Stepped:
        return "papers-loop";
    case EngineKind::Swept:
        break;
    }
    return "swept-steps";
}

} // namespace

MethodChoice::MethodChoice(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_run(new QPushButton(this)) {
    setObjectName(QStringLiteral("methodChoice"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    addFamilies();
    m_run->setObjectName(QStringLiteral("runOwn"));
    m_run->setProperty("prominent", true);
    column->addWidget(m_run);
    connect(m_run, &QPushButton::clicked, this, &MethodChoice::runAsked);
    connect(&session(), &Session::runChanged, this, &MethodChoice::showScene);
    restyle();
    showScene();
    retranslate();
}

void MethodChoice::addFamilies() {
    const std::vector<Method> methods = allMethods();
    for (std::size_t k = 0; k < methods.size(); ++k) {
        const Method& method = methods[k];
        auto family = std::find_if(m_families.begin(), m_families.end(),
                                   [&](const Family& f) { return areOfOneFamily(f.first, method); });
        if (family == m_families.end()) {
            auto* flow = new FlowLayout;
            family = m_families.insert(family, {new QLabel(this), flow, method});
            setTerm(family->name, termOf(method));
            auto* column = static_cast<QVBoxLayout*>(layout());
            column->addWidget(family->name);
            column->addLayout(flow);
        }
        auto* button = new QPushButton(this);
        button->setObjectName(QStringLiteral("method%1").arg(k));
        setTerm(button, !method.without.empty()                     ? termOf(method)
                        : method.settings.kind == EngineKind::Event ? "floating-point"
                                                                    : "time-step");
        button->setProperty("chip", true);
        button->setCheckable(true);
        button->setChecked(k < chosenAtFirst);
        connect(button, &QPushButton::toggled, this, &MethodChoice::showChoice);
        family->flow->addWidget(button);
        m_entries.push_back({method, button});
    }
}

std::vector<Method> MethodChoice::chosen() const {
    std::vector<Method> methods;
    for (const Entry& e : m_entries)
        if (e.button->isChecked() && e.button->isEnabled())
            methods.push_back(e.method);
    return methods;
}

void MethodChoice::retranslate() {
    for (Family& f : m_families)
        f.name->setText(f.first.without.empty() ? methodFamily(f.first)
                                                : tr("next event, with a model left out"));
    for (Entry& e : m_entries) {
        e.button->setText(shortName(e.method));
        e.button->setAccessibleName(methodText(e.method));
        e.button->setToolTip(methodText(e.method));
    }
    m_run->setText(tr("Run on the scene in the window"));
    m_run->setToolTip(
        tr("Runs what is chosen on the scene in the window, against the reference of 113 bits"));
}

void MethodChoice::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    setStyleSheet(
        styleSheet() +
        QStringLiteral("QPushButton[chip=\"true\"] { padding: 0 8px; }"
                       "QPushButton[chip=\"true\"]:focus { padding: 0 7px; }"
                       "QPushButton[chip=\"true\"]:checked { background: %1; color: %2; border-color: "
                       "%1; }"
                       "QPushButton[chip=\"true\"]:checked:focus { border: 2px solid %4; padding: 0 7px; }"
                       "QPushButton[chip=\"true\"]:disabled { color: %3; }")
            .arg(look.accent().name(), look.card().name(), look.line().name(), look.text().name()));
    layout()->setSpacing(look.unit() / 2);
    for (Family& f : m_families) {
        makeQuiet(*f.name, look);
        f.flow->setSpacing(look.unit() / 2);
    }
    for (Entry& e : m_entries)
        e.button->setFont(look.font(Appearance::Size::Small));
}

void MethodChoice::showScene() {
    for (Entry& e : m_entries)
        e.button->setEnabled(isOffered(e.method, session().scene()));
    for (Family& f : m_families) {
        const bool any = std::any_of(m_entries.begin(), m_entries.end(), [&](const Entry& e) {
            return areOfOneFamily(e.method, f.first) && e.button->isEnabled();
        });
        f.name->setVisible(any);
    }
    for (Entry& e : m_entries)
        e.button->setVisible(e.button->isEnabled());
    showChoice();
}

void MethodChoice::showChoice() {
    m_run->setEnabled(!chosen().empty());
}

} // namespace thetalane
