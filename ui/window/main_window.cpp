#include "ui/window/main_window.h"

#include "core/format/scene_file.h"
#include "ui/help/term_help.h"
#include "ui/help/words_panel.h"
#include "ui/lab/lab_panel.h"
#include "ui/lane/lane_panel.h"
#include "ui/map/map_panel.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/timeline_bar.h"
#include "ui/practice/practice_panel.h"
#include "ui/rail/rail.h"
#include "ui/steps/step_panel.h"
#include "ui/who/collision_tree_panel.h"
#include "ui/window/divide.h"
#include "ui/window/message_bar.h"
#include "ui/window/shortcuts.h"
#include "ui/window/top_bar.h"
#include "ui/words/scene_text.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStyleHints>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

// A throw has its attributes, other scenes have their bodies'.
class Attributes : public QStackedWidget {
public:
    Attributes(const Context& context, QWidget* parent)
        : QStackedWidget(parent) {
        addWidget(new BodiesPanel(context, this));
        addWidget(new ThrowPanel(context, this));
    }
    void show(bool aThrow) { setCurrentIndex(aThrow); }
};

} // namespace

MainWindow::MainWindow(const Context& context, Language& language, QWidget* parent)
    : QMainWindow(parent)
    , m_context(context)
    , m_language(language) {
    setObjectName("mainWindow");
    // Before there is a widget to inherit it, and before the panels answer a change with fonts of their own.
    styleApplication();
    connect(&context.appearance, &Appearance::changed, this, &MainWindow::styleApplication);
    setAcceptDrops(true);
    setMinimumSize(800, 560);
    resize(1280, 800);
    buildCentre();
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
    layout->addLayout(middle, 1);
    layout->addWidget(new TimelineBar(m_context));
    setCentralWidget(centre);
    connect(m_topBar, &TopBar::openFileRequested, this, &MainWindow::chooseFile);
    // Diagrams and ghosts like room.
    connect(m_rail, &Rail::entered, m_divide,
            [this](Room room) { m_divide->setShare(room == Room::Accuracy ? 0.5 : 0.3); });
}

void MainWindow::furnishRooms() {
    m_rail->furnish(Room::Steps, [this](QWidget* parent) { return new StepPanel(m_context, parent); });
    m_rail->furnish(Room::Collisions,
                    [this](QWidget* parent) { return new CollisionList(m_context, parent); });
    m_rail->furnish(Room::Attributes, [this](QWidget* parent) {
        auto* attributes = new Attributes(m_context, parent);
        attributes->show(m_isThrow);
        return attributes;
    });
    m_rail->furnish(Room::Chain,
                    [this](QWidget* parent) { return new CollisionTreePanel(m_context, parent); });
    m_rail->furnish(Room::Map, [this](QWidget* parent) { return new MapPanel(m_context, parent); });
    m_rail->furnish(Room::Practice, [this](QWidget* parent) { return new PracticePanel(m_context, parent); });
    m_rail->furnish(Room::Accuracy, [this](QWidget* parent) { return new LabPanel(m_context, parent); });
    m_rail->furnish(Room::Words, [this](QWidget* parent) {
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
    enter(Room::Steps);
}

void MainWindow::enter(Room room) {
    m_rail->enter(room);
}

void MainWindow::explainTerm() {
    const QString term = m_terms->termOfNow();
    enter(Room::Words);
    auto* words = static_cast<WordsPanel*>(m_rail->panel(Room::Words));
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
        Qt::Key_P, [] { return tr("Play the steps, or hold"); },
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
        QKeySequence::Open, [] { return tr("Open a scene file"); }, [this] { chooseFile(); });
    add(
        Qt::Key_F1, [] { return tr("What this term means; the keys"); }, [this] { explainTerm(); });
    m_shortcuts->mention(QKeySequence(Qt::ALT | Qt::Key_1),
                         [] { return tr("The first panel; with 2, 3, … the next ones"); });
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

// Not modal: the lane goes on behind it.
void MainWindow::chooseFile() {
    auto* dialog = new QFileDialog(this, tr("Open a scene file"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilters({tr("Scene files (*.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openFile);
    dialog->open();
}

void MainWindow::openFile(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return m_message->showError([text = name + ": " + file.errorString()] { return text; });
    const auto result = readScene(file.readAll());
    if (const auto* errors = std::get_if<std::vector<SceneError>>(&result))
        return m_message->showError([name, e = errors->front()] { return name + ": " + sceneErrorText(e); });
    m_message->hide();
    m_context.session.open(std::get<Scene>(result));
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

// Each kind of scene opens on what there is to do first.
void MainWindow::showPanelsFor(const Run& run) {
    const bool hasPins =
        std::ranges::any_of(run.scene.bodies, [](const Body& body) { return body.kind == BodyKind::Pin; });
    for (const Room room : {Room::Map, Room::Practice})
        m_rail->setOffered(room, hasPins);
    const bool isThrow = run.scene.lane && m_context.session.currentThrow();
    if (isThrow == m_isThrow)
        return;
    m_isThrow = isThrow;
    if (m_rail->isFurnished(Room::Attributes))
        static_cast<Attributes*>(m_rail->panel(Room::Attributes))->show(isThrow);
    const Room now = m_rail->current();
    if (now == Room::Steps || now == Room::Attributes)
        enter(isThrow ? Room::Attributes : Room::Steps);
    retranslate();
}

// A collision that was picked on the lane or the bar opens; the list stays where its reader is.
void MainWindow::openSelection() {
    if (m_context.playhead.selected() && m_rail->current() == Room::Attributes)
        enter(Room::Steps);
}

void MainWindow::retranslate() {
    setWindowTitle("ThetaLane");
    m_rail->setWords(Room::Steps, tr("Steps"), tr("The collision, step by step"));
    m_rail->setWords(Room::Collisions, tr("Collisions"), tr("All collisions"));
    m_rail->setWords(Room::Attributes, m_isThrow ? tr("Throw") : tr("Bodies"),
                     m_isThrow ? tr("The attributes of the throw") : tr("The attributes of the bodies"));
    m_rail->setWords(Room::Chain, tr("Chain"), tr("Who hit whom, as a tree"));
    m_rail->setWords(Room::Map, tr("Map"), tr("The strike map: which throws strike"));
    m_rail->setWords(Room::Practice, tr("Practice"), tr("Spares, and what changes if"));
    m_rail->setWords(Room::Words, tr("Words"), tr("The terms explained, and the keys (F1)"));
    m_rail->setWords(Room::Accuracy, tr("Accuracy"), tr("Speed against accuracy, measured"));
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
    saveState();
    QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QMainWindow::changeEvent(event);
}

} // namespace thetalane
