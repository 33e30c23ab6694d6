#include "ui/panels/bodies_panel.h"

#include "ui/bench/rules/edit_options.h"
#include "ui/bench/rules/placing.h"
#include "ui/panels/body_group.h"
#include "ui/panels/edit_options_row.h"
#include "ui/panels/value_row.h"
#include "ui/panels/wall_group.h"
#include "ui/words/scene_text.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {

BodiesPanel::BodiesPanel(const Context& context, QWidget* parent)
    : BodiesPanel(context, *new EditOptions, parent) {
    m_options.setParent(this);
}

BodiesPanel::BodiesPanel(const Context& context, EditOptions& options, QWidget* parent)
    : Panel(context, parent)
    , m_options(options)
    , m_column(new QVBoxLayout)
    , m_restitution(
          new ValueRow(context.appearance, QStringLiteral("restitution"), {0, 1, 0.01, 0}, {}, this))
    , m_editing(new EditOptionsRow(context.appearance, options, this))
    , m_add(new QPushButton(this))
    , m_walls(new WallGroup(context.appearance, this))
    , m_more(new QLabel(this))
    , m_message(new QLabel(this))
    , m_addMessage(new QLabel(this)) {
    setObjectName(QStringLiteral("bodiesPanel"));
    m_more->setObjectName(QStringLiteral("moreBodies"));
    m_message->setObjectName(QStringLiteral("sceneMessage"));
    m_addMessage->setObjectName(QStringLiteral("addMessage"));
    m_add->setObjectName(QStringLiteral("addBody"));
    m_add->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    m_more->setWordWrap(true);
    build();
    m_restitution->setTerm("restitution");
    connect(m_restitution, &ValueRow::edited, this, &BodiesPanel::apply);
    connect(m_restitution, &ValueRow::becameUnreadable, this, &BodiesPanel::apply);
    connect(m_add, &QPushButton::clicked, this, &BodiesPanel::addBody);
    connect(m_walls, &WallGroup::edited, this, &BodiesPanel::apply);
    connect(m_walls, &WallGroup::wanted, this, [this](Side side) {
        m_walls->put(side, placeForWall(session().scene(), side));
        apply();
    });
    connect(m_editing, &EditOptionsRow::oneLineWanted, this, &BodiesPanel::putOnOneLine);
    connect(&options, &EditOptions::changed, this, &BodiesPanel::showScene);
    connect(&session(), &Session::runChanged, this, &BodiesPanel::takeRun);
    connect(&playhead(), &Playhead::selectionChanged, this, &BodiesPanel::showColours);
    restyle();
    showScene();
    retranslate();
}

void BodiesPanel::build() {
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    auto* inside = new QWidget(scroll);
    inside->setLayout(m_column);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_restitution, m_editing, m_message, m_more, m_add,
                                                           m_addMessage, m_walls})
        m_column->addWidget(widget);
    m_column->addStretch(1);
}

void BodiesPanel::retranslate() {
    m_restitution->setWords(tr("Coefficient of restitution e"),
                            tr("0: perfectly inelastic, 1: elastic. Between all bodies."));
    const std::size_t count = session().scene().bodies.size();
    m_more->setVisible(count > mostShown);
    m_more->setText(tr("Shown are the first %1 of %2 bodies.").arg(mostShown).arg(count));
    m_add->setText(tr("Add a body"));
    m_add->setAccessibleName(m_add->text());
    m_add->setEnabled(count < mostOnTheBench);
    m_add->setToolTip(count < mostOnTheBench
                          ? tr("One body more, at rest, where there is room")
                          : tr("%1 bodies are the most that are edited by hand").arg(mostOnTheBench));
    m_editing->retranslate();
    m_walls->retranslate();
    for (BodyGroup* group : m_groups)
        group->retranslate();
    showErrors();
}

void BodiesPanel::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit * 2);
    m_add->setFont(appearance().font(Appearance::Size::Normal));
    makeQuiet(*m_more, appearance());
    makeMessage(*m_message, appearance());
    makeMessage(*m_addMessage, appearance());
    showColours();
}

void BodiesPanel::makeGroups(std::size_t count) {
    while (m_groups.size() > count) {
        m_groups.back()->deleteLater();
        m_groups.back()->hide();
        m_groups.pop_back();
    }
    while (m_groups.size() < count) {
        auto* group = new BodyGroup(appearance(), m_options, int(m_groups.size()), this);
        connect(group, &BodyGroup::edited, this, &BodiesPanel::apply);
        connect(group, &BodyGroup::removeWanted, this, &BodiesPanel::removeBody);
        m_column->insertWidget(m_column->indexOf(m_more), group);
        m_groups.push_back(group);
    }
}

// Nothing is left of one line when something was moved off it, or undone.
void BodiesPanel::takeRun() {
    if (m_options.oneLine() && !lineOf(session().scene()))
        m_options.setOneLine(false); // and shows the scene
    if (m_applying)
        return; // the fields say already what they were told
    m_stale = !isVisible();
    if (!m_stale)
        showScene();
}

void BodiesPanel::showEvent(QShowEvent* event) {
    if (m_stale)
        showScene();
    Panel::showEvent(event);
}

void BodiesPanel::showScene() {
    m_stale = false;
    const Scene& scene = session().scene();
    const bool removable = scene.bodies.size() > 1 && scene.bodies.size() <= mostOnTheBench;
    makeGroups(std::min(scene.bodies.size(), mostShown));
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        m_groups[i]->show(scene.bodies[i], scene.friction && scene.bodies[i].kind == BodyKind::Ball,
                          removable);
    m_restitution->setValue(scene.restitution);
    m_walls->setVisible(!scene.lane);
    m_walls->show(scene.frame);
    m_errors.clear();
    say({});
    showColours();
    retranslate();
}

void BodiesPanel::apply() {
    m_errors.clear();
    const bool usable =
        m_restitution->unreadable().isEmpty() && m_walls->isUsable() &&
        std::all_of(m_groups.begin(), m_groups.end(), [](const BodyGroup* g) { return g->isUsable(); });
    Scene scene = session().scene();
    scene.restitution = m_restitution->value();
    scene.frame = m_walls->frame();
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

// Not of what stands in the fields, some of which may be wrong, but of the scene.
void BodiesPanel::change(const Scene& scene) {
    session().setScene(scene);
}

void BodiesPanel::addBody() {
    const Scene& scene = session().scene();
    if (const auto more = withOneMore(scene, m_options.oneLine() ? lineOf(scene) : std::nullopt))
        change(*more);
    else
        say(tr("There is no room for another body; move the walls or make the bodies smaller."));
}

void BodiesPanel::removeBody(int index) {
    if (session().scene().bodies.size() > 1)
        change(without(session().scene(), std::size_t(index)));
}

void BodiesPanel::putOnOneLine(bool on) {
    if (!on)
        return m_options.setOneLine(false);
    const auto lined = linedUp(session().scene());
    const bool there = lined && *lined == session().scene();
    const bool done = there || (lined && session().setScene(*lined).empty());
    if (done)
        m_options.setOneLine(true);
    m_editing->showOptions();
    if (!done)
        say(tr("There is no room for all bodies on one line; move the walls or make the bodies smaller."));
}

void BodiesPanel::say(const QString& trouble) {
    m_addMessage->setText(trouble);
    m_addMessage->setVisible(!trouble.isEmpty());
}

QString BodiesPanel::elsewhere() const {
    constexpr int enough = 3; // one huge body may overlap very many
    QStringList lines;
    for (const SceneError& error : m_errors) {
        if (lines.size() == enough)
            return lines.join(u'\n') + QStringLiteral("\n…");
        const QString path = QString::fromStdString(error.path);
        bool shown =
            path == "restitution" || (path.startsWith(QStringLiteral("frame.")) && !session().scene().lane);
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
    m_walls->showErrors(m_errors);
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
