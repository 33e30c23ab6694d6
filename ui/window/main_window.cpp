#include "ui/window/main_window.h"

#include "ui/aim/aim_tool.h"
#include "ui/bench/edit_tool.h"
#include "ui/bench/file_bar.h"
#include "ui/bench/recovery_bar.h"
#include "ui/bench/rules/edit_options.h"
#include "ui/game/game_panel.h"
#include "ui/game/score_sheet.h"
#include "ui/game/statistics_panel.h"
#include "ui/help/term_help.h"
#include "ui/help/words_panel.h"
#include "ui/lab/lab_panel.h"
#include "ui/lane/lane_panel.h"
#include "ui/lane/lane_scene.h"
#include "ui/lane/lane_view.h"
#include "ui/lessons/lesson_caption.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/map/map_panel.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/scene_chooser.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/timeline_bar.h"
#include "ui/practice/practice_panel.h"
#include "ui/predict/predict_panel.h"
#include "ui/rail/rail.h"
#include "ui/steps/step_panel.h"
#include "ui/tables/tables_panel.h"
#include "ui/who/collision_tree_panel.h"
#include "ui/window/divide.h"
#include "ui/window/message_bar.h"
#include "ui/window/shortcuts.h"
#include "ui/window/top_bar.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace thetalane {
namespace {

// A throw has its attributes, other scenes have their bodies'.
class Attributes : public QStackedWidget {
public:
    Attributes(const Context& context, EditOptions& options, AimTool& aim, QWidget* parent)
        : QStackedWidget(parent) {
        addWidget(new BodiesPanel(context, options, this));
        auto* ball = new ThrowPanel(context, this);
        ball->setUnits(rememberedThrowUnits());
        connect(ball, &ThrowPanel::unitsChanged, &aim, &AimTool::setUnits);
        addWidget(ball);
    }
    void show(bool aThrow) { setCurrentIndex(aThrow); }
};

// How the throws of a game came to the pins.
std::vector<Entry> entriesOf(const Game& game) {
    std::vector<Entry> entries;
    for (const auto& deliveries : game.deliveries)
        for (const PlayedDelivery& d : deliveries)
            if (const auto entry = d.thrown ? entryOf(*d.thrown, game.lane.friction) : std::nullopt)
                entries.push_back(*entry);
    return entries;
}

} // namespace

MainWindow::MainWindow(const Context& context, Language& language, QWidget* parent)
    : QMainWindow(parent)
    , m_context(context)
    , m_language(language)
    , m_desk(new Desk(context.session, this))
    , m_files(new FileFlow(*m_desk, *this))
    , m_editing(new EditOptions(this))
    , m_alley(new Alley(context.session, context.playhead, this)) {
    setObjectName("mainWindow");
    // Before there is a widget to inherit it, and before the panels answer a change with fonts of their own.
    styleApplication();
    connect(&context.appearance, &Appearance::changed, this, &MainWindow::styleApplication);
    setAcceptDrops(true);
    setMinimumSize(800, 560);
    resize(1280, 800);
    buildCentre();
    buildTools();
    furnishRooms();
    buildShortcuts();
    m_terms = new TermHelp(*this);
    connect(&m_context.session, &Session::runChanged, this,
            [this](const std::shared_ptr<const Run>& run) { showPanelsFor(*run); });
    connect(&m_context.playhead, &Playhead::selectionChanged, this, &MainWindow::openSelection);
    connect(&m_context.appearance, &Appearance::changed, this, &MainWindow::applyAppearance);
    // Once more, now that every widget stands in its place: under a style sheet Qt takes a font away from a
    // widget that gets another parent.
    emit m_context.appearance.changed();
    retranslate();
    showPanelsFor(*m_context.session.run());
    m_lane->setFocus();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildCentre() {
    m_topBar = new TopBar(m_context, m_language, this);
    m_topBar->addFirst(new FileBar(m_context, *m_files, m_topBar));
    m_lane = new LanePanel(m_context);
    m_panels = new QStackedWidget;
    m_panels->setObjectName("panels");
    m_divide = new Divide;
    m_divide->setObjectName("divide");
    m_divide->setChildrenCollapsible(false);
    m_divide->addWidget(m_lane);
    m_divide->addWidget(m_panels);
    m_rail = new Rail(m_context.appearance, *m_panels);
    m_message = new MessageBar(m_context);
    m_timeline = new TimelineBar(m_context);

    auto* middle = new QHBoxLayout;
    middle->setSpacing(0);
    middle->addWidget(m_divide, 1);
    middle->addWidget(m_rail);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_topBar);
    layout->addWidget(m_message);
    layout->addWidget(new RecoveryBar(m_context, *m_files));
    layout->addWidget(new ScoreSheet(m_context, *m_alley)); // hides itself without a game
    layout->addLayout(middle, 1);
    layout->addWidget(m_timeline);
    setCentralWidget(centre);
    m_topBar->scenes().setGuard([this](std::function<void()> go) { m_files->whenSafe(std::move(go)); });
    connect(m_topBar, &TopBar::openFileRequested, m_files, &FileFlow::chooseAndOpen);
    connect(m_desk, &Desk::failed, m_message, &MessageBar::showError);
    connect(m_desk, &Desk::changed, this, &MainWindow::showTitle);
    connect(m_alley, &Alley::changed, this, &MainWindow::followGame);
    // Diagrams and ghosts like room.
    connect(m_rail, &Rail::entered, m_divide, [this](Room room) {
        m_divide->setShare(room == Room::Accuracy                      ? 0.5
                           : room == Room::Map || room == Room::Tables ? 0.4
                                                                       : 0.3);
    });
}

void MainWindow::buildTools() {
    m_aim = new AimTool(m_context, this);
    m_lane->addTool(*m_aim);
    m_edit = new EditTool(m_context, *m_lane, *m_editing, this);
    m_lane->view().addTool(*m_edit);
    connect(m_edit, &EditTool::held, &m_lane->scene(), &LaneScene::holdScale);
}

void MainWindow::furnishRooms() {
    m_rail->furnish(Room::Steps, [this](QWidget* parent) { return new StepPanel(m_context, parent); });
    m_rail->furnish(Room::Collisions,
                    [this](QWidget* parent) { return new CollisionList(m_context, parent); });
    m_rail->furnish(Room::Attributes, [this](QWidget* parent) {
        auto* attributes = new Attributes(m_context, *m_editing, *m_aim, parent);
        attributes->show(m_isThrow);
        return attributes;
    });
    m_rail->furnish(Room::Accuracy, [this](QWidget* parent) { return new LabPanel(m_context, parent); });
    m_rail->furnish(Room::Glossary, [this](QWidget* parent) {
        return new WordsPanel(
            m_context,
            [this] {
                std::vector<KeyLine> lines;
                for (const Shortcut& s : m_shortcuts->all())
                    lines.push_back({s.keys, s.what()});
                return lines;
            },
            parent);
    });
    furnishClassroom();
    furnishAlley();
    enter(Room::Steps);
}

void MainWindow::furnishClassroom() {
    m_rail->furnish(Room::Lessons, [this](QWidget* parent) {
        auto* lessons = new LessonPanel(m_context, parent);
        connect(lessons, &LessonPanel::showRequested, this, &MainWindow::bringForward);
        connect(lessons, &LessonPanel::running, this, [this](bool running) {
            m_inLesson = running;
            m_topBar->scenes().setInLesson(running);
            m_edit->setEnabled(!running);
            m_desk->setRecording(!running && !m_alley->isOn());
        });
        // The answer is given in a dialog that leaves the window free; the lesson starts with the next click.
        lessons->setMayOpen([this] {
            if (!m_desk->isModified() || m_mayLoseEdits)
                return true;
            m_files->whenSafe([this] { m_mayLoseEdits = true; });
            return false;
        });
        connect(lessons, &LessonPanel::asking, m_lane, [this](bool asks) {
            if (std::exchange(m_isAsked, asks) == asks)
                return;
            hideFuture();
            if (asks)
                enter(Room::Lessons);
        });
        addCaption(*lessons);
        return lessons;
    });
    m_rail->furnish(Room::Predict, [this](QWidget* parent) {
        auto* predict = new PredictPanel(m_context, parent);
        connect(predict, &PredictPanel::predicting, m_lane, [this](bool predicting) {
            m_predicting = predicting;
            hideFuture();
        });
        return predict;
    });
    m_rail->furnish(Room::Tables, [this](QWidget* parent) { return new TablesPanel(m_context, parent); });
}

// What a lesson says stays to be read while its stop shows another panel.
void MainWindow::addCaption(LessonPanel& lessons) {
    auto* caption = new LessonCaption(m_context, lessons.player(), centralWidget());
    auto* column = static_cast<QVBoxLayout*>(centralWidget()->layout());
    column->insertWidget(column->indexOf(m_message) + 1, caption);
    const auto follow = [this, caption] {
        caption->setPanelInFront(m_rail->isOpen() && m_rail->current() == Room::Lessons);
    };
    connect(m_rail, &Rail::entered, caption, follow);
    connect(m_rail, &Rail::openChanged, caption, follow);
    connect(caption, &LessonCaption::panelWanted, this, [this] { enter(Room::Lessons); });
}

void MainWindow::hideFuture() {
    m_lane->scene().hideFuture(m_isAsked || m_predicting);
    m_timeline->hideFuture(m_isAsked); // who predicts may choose among the collisions
}

void MainWindow::furnishAlley() {
    m_rail->furnish(Room::Game,
                    [this](QWidget* parent) { return new GamePanel(m_context, *m_alley, parent); });
    m_rail->furnish(Room::Statistics,
                    [this](QWidget* parent) { return new StatisticsPanel(m_context, *m_alley, parent); });
    m_rail->furnish(Room::Chain,
                    [this](QWidget* parent) { return new CollisionTreePanel(m_context, parent); });
    m_rail->furnish(Room::Map, [this](QWidget* parent) {
        auto* map = new MapPanel(m_context, parent);
        map->setDots(entriesOf(m_alley->shown()));
        return map;
    });
    m_rail->furnish(Room::Practice, [this](QWidget* parent) { return new PracticePanel(m_context, parent); });
}

void MainWindow::enter(Room room) {
    m_rail->enter(room);
}

void MainWindow::explainTerm() {
    const QString term = m_terms->termOfNow();
    enter(Room::Glossary);
    auto* words = static_cast<WordsPanel*>(m_rail->panel(Room::Glossary));
    if (term.isEmpty())
        words->showKeys();
    else
        words->showTerm(term);
}

void MainWindow::buildShortcuts() {
    Playhead& playhead = m_context.playhead;
    Appearance& look = m_context.appearance;
    m_shortcuts = new Shortcuts(this);
    const auto add = [this](const QKeySequence& keys, std::function<QString()> what,
                            std::function<void()> action, bool (*givesWayTo)(const QWidget*) = nullptr) {
        m_shortcuts->add({keys, std::move(what), std::move(action), givesWayTo});
    };
    add(
        Qt::Key_Space, [] { return tr("Play or pause"); }, [&] { playhead.togglePlaying(); }, usesSpace);
    add(
        Qt::Key_Left, [] { return tr("One frame back"); }, [&] { playhead.stepFrames(-1); }, usesArrows);
    add(
        Qt::Key_Right, [] { return tr("One frame forward"); }, [&] { playhead.stepFrames(+1); }, usesArrows);
    add(
        Qt::CTRL | Qt::Key_Left, [] { return tr("The collision before"); },
        [&] { playhead.stepCollisions(-1); });
    add(
        Qt::CTRL | Qt::Key_Right, [] { return tr("The next collision"); },
        [&] { playhead.stepCollisions(+1); });
    add(
        Qt::Key_Up, [] { return tr("The step before"); }, [&] { playhead.stepStage(-1); }, usesArrows);
    add(
        Qt::Key_Down, [] { return tr("The next step of the collision"); }, [&] { playhead.stepStage(+1); },
        usesArrows);
    add(
        Qt::Key_S, [] { return tr("Play the steps, or hold"); },
        [this] {
            enter(Room::Steps);
            static_cast<StepPanel*>(m_rail->panel(Room::Steps))->player().toggle();
        },
        usesLetters);
    add(
        Qt::Key_Escape, [] { return tr("Close the collision"); }, [&] { playhead.clearSelection(); });
    add(
        Qt::Key_R, [] { return tr("Reset the scene"); }, [this] { m_context.session.reset(); }, usesLetters);
    m_shortcuts->mention(Qt::Key_F, [] { return tr("All of the lane in view"); });
    m_shortcuts->mention(Qt::Key_B, [] { return tr("The foul line, to aim"); });
    m_shortcuts->mention(Qt::Key_P, [] { return tr("The pins, close up"); });
    m_shortcuts->mention(Qt::Key_C, [] { return tr("The camera follows the ball, or stays"); });
    m_shortcuts->mention(Qt::Key_A, [] { return tr("On a lane: the next thing that the arrow keys aim"); });
    m_shortcuts->mention(Qt::Key_N,
                         [] { return tr("On the bench: the next body that the arrow keys move"); });
    m_shortcuts->mention(Qt::Key_Return, [] { return tr("In a game: throw, or go on"); });
    add(
        Qt::Key_F9, [] { return tr("Fold the panel away, or open it"); },
        [this] { m_rail->setOpen(!m_rail->isOpen()); });
    add(
        Qt::Key_F11, [] { return tr("Projector mode"); }, [&] { look.setProjector(!look.projector()); });
    add(
        Qt::Key_D, [] { return tr("Dark or light"); }, [&] { look.setDark(!look.dark()); }, usesLetters);
    add(
        Qt::Key_L, [] { return tr("한국어 or English"); }, [this] { toggleLanguage(); }, usesLetters);
    add(
        Qt::Key_F1, [] { return tr("What this term means; the keys"); }, [this] { explainTerm(); });
    m_shortcuts->mention(QKeySequence(Qt::ALT | Qt::Key_1),
                         [] { return tr("The first panel; with 2, 3, … the next ones"); });
    const std::pair<QKeySequence, QString (*)()> files[] = {
        {QKeySequence::New, [] { return tr("A new scene"); }},
        {QKeySequence::Open, [] { return tr("Open a scene file"); }},
        {QKeySequence::Save, [] { return tr("Save the scene"); }},
        {QKeySequence::Undo, [] { return tr("Undo"); }},
        {QKeySequence::Redo, [] { return tr("Redo"); }}};
    for (const auto& [keys, what] : files)
        m_shortcuts->mention(keys, what);
    for (int k = 0; k < 9; ++k)
        m_shortcuts->add({QKeySequence(Qt::ALT | Qt::Key(Qt::Key_1 + k)), [] { return QString(); },
                          [this, k] {
                              if (const auto room = m_rail->offered(k))
                                  enter(*room);
                          }});
}

void MainWindow::toggleLanguage() {
    m_language.use(m_language.code() == Language::Code::Korean ? Language::Code::English
                                                               : Language::Code::Korean);
}

void MainWindow::openFile(const QString& path) {
    m_message->hide();
    m_files->open(path);
}

void MainWindow::openLab(Preset preset) {
    enter(Room::Accuracy);
    static_cast<LabPanel*>(m_rail->panel(Room::Accuracy))->choose(preset);
}

bool MainWindow::isMeasuring() const {
    const auto runs = [this]<class P>(Room room, P*) {
        return m_rail->isFurnished(room) && static_cast<P*>(m_rail->panel(room))->running();
    };
    return runs(Room::Accuracy, static_cast<LabPanel*>(nullptr)) ||
           runs(Room::Map, static_cast<MapPanel*>(nullptr));
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->urls().size() == 1 && event->mimeData()->urls().first().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    openFile(event->mimeData()->urls().first().toLocalFile());
}

// Each kind of scene opens on what there is to do first; who is elsewhere stays there.
void MainWindow::showPanelsFor(const Run& run) {
    const bool hasPins =
        std::ranges::any_of(run.scene.bodies, [](const Body& body) { return body.kind == BodyKind::Pin; });
    for (const Room room : {Room::Map, Room::Practice})
        m_rail->setOffered(room, hasPins);
    const bool isThrow = run.scene.lane && m_context.session.currentThrow();
    m_rail->setOffered(Room::Statistics, m_alley->isOn() || isThrow);
    if (isThrow == m_isThrow)
        return;
    m_isThrow = isThrow;
    if (m_rail->isFurnished(Room::Attributes))
        static_cast<Attributes*>(m_rail->panel(Room::Attributes))->show(isThrow);
    const Room now = m_rail->current();
    if ((now == Room::Steps || now == Room::Attributes) && !m_inLesson)
        enter(isThrow ? Room::Attributes : Room::Steps);
    retranslate();
}

// A delivery cannot be taken back by an undo of the scene; the game has its own.
void MainWindow::followGame() {
    m_desk->setRecording(!m_alley->isOn() && !m_inLesson);
    m_rail->setOffered(Room::Statistics, m_alley->isOn() || m_isThrow);
    if (m_rail->isFurnished(Room::Map))
        static_cast<MapPanel*>(m_rail->panel(Room::Map))->setDots(entriesOf(m_alley->shown()));
}

// What a stop of a lesson wants to be seen.
void MainWindow::bringForward(LessonShow what) {
    switch (what) {
    case LessonShow::Nothing:
        return;
    case LessonShow::Steps:
        return enter(Room::Steps);
    case LessonShow::Collisions:
        return enter(Room::Collisions);
    case LessonShow::Bodies:
        return enter(Room::Attributes);
    case LessonShow::Tables:
    case LessonShow::Plots:
        enter(Room::Tables);
        return static_cast<TablesPanel*>(m_rail->panel(Room::Tables))
            ->choose(what == LessonShow::Tables ? TablesPanel::View::Collision : TablesPanel::View::Course);
    case LessonShow::Lab:
        return enter(Room::Accuracy);
    }
}

// A collision that was picked on the lane or the bar opens; the list stays where its reader is.
void MainWindow::openSelection() {
    const Room now = m_rail->current();
    if (m_context.playhead.selected() && (now == Room::Attributes || now == Room::Game))
        enter(Room::Steps);
}

void MainWindow::retranslate() {
    showTitle();
    m_rail->setWords(Room::Lessons, tr("Lessons"), tr("Lessons: a scene, a few stops, a question"));
    m_rail->setWords(Room::Predict, tr("Predict"), tr("Predict what comes, then see it"));
    m_rail->setWords(Room::Tables, tr("Tables"), tr("Tables, plots, and a worksheet to print"));
    m_rail->setWords(Room::Game, tr("Game"), tr("A game of bowling, for one to eight"));
    m_rail->setWords(Room::Statistics, tr("Statistics"), tr("Strikes, spares and averages"));
    m_rail->setWords(Room::Steps, tr("Steps"), tr("The collision, step by step"));
    m_rail->setWords(Room::Collisions, tr("Collisions"), tr("All collisions"));
    m_rail->setWords(Room::Attributes, m_isThrow ? tr("Throw") : tr("Bodies"),
                     m_isThrow ? tr("The attributes of the throw") : tr("The attributes of the bodies"));
    m_rail->setWords(Room::Chain, tr("Chain"), tr("Who hit whom, as a tree"));
    m_rail->setWords(Room::Map, tr("Map"), tr("The strike map: which throws strike"));
    m_rail->setWords(Room::Practice, tr("Practice"), tr("Spares, and what changes if"));
    m_rail->setWords(Room::Glossary, tr("Words"), tr("The terms explained, and the keys (F1)"));
    m_rail->setWords(Room::Accuracy, tr("Accuracy"), tr("Speed against accuracy, measured"));
}

void MainWindow::showTitle() {
    const QString name = m_desk->documentName();
    setWindowTitle(name.isEmpty() ? QStringLiteral("ThetaLane[*]")
                                  : name + QStringLiteral("[*] — ThetaLane"));
    setWindowModified(m_desk->isModified());
}

void MainWindow::keepRecoveries() {
    m_desk->keepRecoveriesIn(Desk::usualRecoveryPlace());
}

void MainWindow::styleApplication() {
    const Appearance& look = m_context.appearance;
    qApp->setFont(look.font(Appearance::Size::Normal));
    qApp->setPalette(look.palette());
    qApp->setStyleSheet(look.styleSheet());
}

void MainWindow::applyAppearance() {
    const bool large = m_context.appearance.projector();
    m_panels->setMinimumWidth(large ? 480 : 344);
    m_panels->setMaximumWidth(large ? 800 : 560);
}

void MainWindow::restoreState() {
    const QSettings settings;
    m_aim->setUnits(rememberedThrowUnits());
    m_lane->restoreChoices();
    m_timeline->restoreChoices();
    restoreGeometry(settings.value("window/geometry").toByteArray());
    m_divide->recall(settings.value("window/divide").toByteArray());
    m_context.appearance.setProjector(settings.value("window/projector", false).toBool());
    m_context.appearance.setReducedMotion(settings.value("window/lessMotion", false).toBool());
    m_context.appearance.setDark(settings.value("window/dark", m_context.appearance.dark()).toBool());
}

void MainWindow::saveState() const {
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/divide", m_divide->remembered());
    settings.setValue("window/projector", m_context.appearance.projector());
    settings.setValue("window/lessMotion", m_context.appearance.reducedMotion());
    settings.setValue("window/dark", m_context.appearance.dark());
    settings.setValue("language", Language::toString(m_language.code()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (m_desk->isModified() && !m_leaving) {
        event->ignore();
        return m_files->whenSafe([this] {
            m_leaving = true;
            close();
        });
    }
    saveState();
    QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

} // namespace thetalane
