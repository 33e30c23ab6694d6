#include "ui/panels/bodies_panel.h"

#include "ui/panels/body_group.h"
#include "ui/panels/value_row.h"
#include "ui/words/scene_text.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {

BodiesPanel::BodiesPanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_column(new QVBoxLayout)
    , m_restitution(
          new ValueRow(context.appearance, QStringLiteral("restitution"), {0, 1, 0.01, 0}, {}, this))
    , m_more(new QLabel(this))
    , m_message(new QLabel(this)) {
    setObjectName(QStringLiteral("bodiesPanel"));
    m_more->setObjectName(QStringLiteral("moreBodies"));
    m_message->setObjectName(QStringLiteral("sceneMessage"));
    m_more->setWordWrap(true);
    auto* scroll = new QScrollArea(this);
    auto* inside = new QWidget(scroll);
    inside->setLayout(m_column);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    m_column->addWidget(m_restitution);
    m_column->addWidget(m_message);
    m_column->addWidget(m_more);
    m_column->addStretch(1);

    connect(m_restitution, &ValueRow::edited, this, &BodiesPanel::apply);
    connect(m_restitution, &ValueRow::becameUnreadable, this, &BodiesPanel::apply);
    connect(&session(), &Session::runChanged, this, &BodiesPanel::showScene);
    connect(&playhead(), &Playhead::selectionChanged, this, &BodiesPanel::showColours);
    restyle();
    showScene();
    retranslate();
}

void BodiesPanel::retranslate() {
    m_restitution->setWords(tr("Coefficient of restitution e"),
                            tr("0: perfectly inelastic, 1: elastic. Between all bodies."));
    const std::size_t count = session().scene().bodies.size();
    m_more->setVisible(count > mostShown);
    m_more->setText(tr("Shown are the first %1 of %2 bodies.").arg(mostShown).arg(count));
    for (BodyGroup* group : m_groups)
        group->retranslate();
    showErrors();
}

void BodiesPanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit * 2);
    makeQuiet(*m_more, appearance());
    makeMessage(*m_message, appearance());
    showColours();
}

void BodiesPanel::makeGroups(std::size_t count) {
    while (m_groups.size() > count) {
        m_groups.back()->deleteLater();
        m_groups.back()->hide();
        m_groups.pop_back();
    }
    while (m_groups.size() < count) {
        auto* group = new BodyGroup(appearance(), int(m_groups.size()), this);
        connect(group, &BodyGroup::edited, this, &BodiesPanel::apply);
        m_column->insertWidget(2 + int(m_groups.size()), group); // after e and its message
        m_groups.push_back(group);
    }
}

void BodiesPanel::showScene() {
    const Scene& scene = session().scene();
    if (m_applying)
        return; // the fields say already what they were told
    makeGroups(std::min(scene.bodies.size(), mostShown));
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        m_groups[i]->show(scene.bodies[i], scene.friction && scene.bodies[i].kind == BodyKind::Ball);
    m_restitution->setValue(scene.restitution);
    m_errors.clear();
    showColours();
    retranslate();
}

void BodiesPanel::apply() {
    m_errors.clear();
    const bool usable =
        m_restitution->unreadable().isEmpty() &&
        std::all_of(m_groups.begin(), m_groups.end(), [](const BodyGroup* g) { return g->isUsable(); });
    Scene scene = session().scene();
    scene.restitution = m_restitution->value();
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        scene.bodies[i] = m_groups[i]->body();
    if (!usable) {
        m_errors = validate(scene); // the other fields are answered all the same
    } else if (!(scene == session().scene())) {
        m_applying = true;
        m_errors = session().setScene(scene);
        m_applying = false;
    }
    showErrors();
}

QString BodiesPanel::elsewhere() const {
    constexpr int enough = 3; // one huge body may overlap very many
    QStringList lines;
    for (const SceneError& error : m_errors) {
        if (lines.size() == enough)
            return lines.join(u'\n') + QStringLiteral("\n…");
        const QString path = QString::fromStdString(error.path);
        bool shown = path == "restitution";
        for (std::size_t i = 0; i < m_groups.size(); ++i)
            shown = shown || path.startsWith(QStringLiteral("bodies[%1].").arg(i));
        if (!shown)
            lines.append(sceneErrorText(error));
    }
    return lines.join(u'\n');
}

void BodiesPanel::showErrors() {
    QString wrong = m_restitution->unreadable();
    for (const SceneError& error : m_errors)
        if (error.path == "restitution")
            wrong = sceneErrorMessage(error);
    m_restitution->setMessage(wrong);
    for (BodyGroup* group : m_groups)
        group->showErrors(m_errors);
    m_message->setText(elsewhere());
    m_message->setVisible(!m_message->text().isEmpty());
}

// The colours of the selected collision's two bodies; of two bodies, always their own.
void BodiesPanel::showColours() {
    int first = m_groups.size() == 2 ? 0 : -1;
    int second = m_groups.size() == 2 ? 1 : -1;
    const auto selected = playhead().selected();
    const auto collisions = session().timeline().collisions();
    if (selected && *selected < collisions.size() && m_groups.size() != 2) {
        first = collisions[*selected].first;
        second = collisions[*selected].second;
    }
    for (int i = 0; i < int(m_groups.size()); ++i)
        m_groups[std::size_t(i)]->setColour(i == first    ? appearance().ink(Ink::First)
                                            : i == second ? appearance().ink(Ink::Second)
                                                          : appearance().line());
}

} // namespace thetalane
