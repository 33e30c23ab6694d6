#include "ui/main_window.h"

#include "core/format/scene_file.h"
#include "ui/divide.h"
#include "ui/lab/lab_panel.h"
#include "ui/lane/lane_panel.h"
#include "ui/message_bar.h"
#include "ui/panels/bodies_panel.h"
#include "ui/panels/collision_list.h"
#include "ui/panels/engine_chooser.h"
#include "ui/panels/icon_button.h"
#include "ui/panels/scene_chooser.h"
#include "ui/panels/throw_panel.h"
#include "ui/panels/timeline_bar.h"
#include "ui/steps/step_panel.h"
#include "ui/words/scene_text.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QSettings>
#include <QShortcut>
#include <QStackedWidget>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <functional>

namespace thetalane {
namespace {

enum Tab { StepsTab, CollisionsTab, AttributesTab, LabTab };

// Whether a widget with the focus uses the arrow keys itself.
bool usesArrows(const QWidget* w) {
    return qobject_cast<const QLineEdit*>(w) || qobject_cast<const QAbstractItemView*>(w) ||
           qobject_cast<const QComboBox*>(w) || qobject_cast<const QAbstractSlider*>(w) ||
           qobject_cast<const QTabBar*>(w);
}

// Whether the space bar presses the widget with the focus; only the Tab key brings the focus there.
bool usesSpace(const QWidget* w) {
    return qobject_cast<const QAbstractButton*>(w) || qobject_cast<const QComboBox*>(w);
}

QToolButton* barButton(const char* name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed); // the choosers give way
    return button;
}

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
    buildTopBar();
    buildCentre();
    buildShortcuts();
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

void MainWindow::buildTopBar() {
    m_topBar = new QWidget(this);
    m_scenes = new SceneChooser(m_context, m_topBar);
    m_reset = new IconButton(m_context.appearance, Icon::Reset, "reset", m_topBar);
    auto* engine = new EngineChooser(m_context, m_topBar);
    m_projector = barButton("projector", m_topBar);
    m_projector->setCheckable(true);
    m_projector->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_korean = barButton("korean", m_topBar);
    m_english = barButton("english", m_topBar);
    for (QToolButton* b : {m_korean, m_english})
        b->setCheckable(true);

    auto* layout = new QHBoxLayout(m_topBar);
    layout->addWidget(m_scenes);
    layout->addWidget(m_reset);
    layout->addStretch(1);
    layout->addWidget(engine);
    layout->addStretch(1);
    layout->addWidget(m_projector);
    layout->addWidget(m_korean);
    layout->addWidget(m_english);

    connect(m_scenes, &SceneChooser::openFileRequested, this, &MainWindow::chooseFile);
    connect(m_reset, &IconButton::clicked, &m_context.session, &Session::reset);
    connect(m_projector, &QToolButton::clicked, this, &MainWindow::setProjector);
    connect(m_korean, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::Korean); });
    connect(m_english, &QToolButton::clicked, this, [this] { m_language.use(Language::Code::English); });
}

void MainWindow::buildCentre() {
    m_lane = new LanePanel(m_context);
    m_steps = new StepPanel(m_context);
    auto* list = new CollisionList(m_context);
    m_bodies = new BodiesPanel(m_context);
    m_throw = new ThrowPanel(m_context);
    m_attributes = new QStackedWidget;
    m_attributes->addWidget(m_bodies);
    m_attributes->addWidget(m_throw);

    m_tabs = new QTabWidget;
    m_tabs->setObjectName("tabs");
    m_tabs->setDocumentMode(true);
    m_tabs->tabBar()->setDrawBase(false);
    m_tabs->addTab(m_steps, QString());
    m_tabs->addTab(list, QString());
    m_tabs->addTab(m_attributes, QString());
    m_lab = new LabPanel(m_context);
    m_tabs->addTab(m_lab, QString());

    m_divide = new Divide;
    m_divide->setObjectName("divide");
    m_divide->setChildrenCollapsible(false);
    m_divide->addWidget(m_lane);
    m_divide->addWidget(m_tabs);
    // Diagrams and ghosts like room.
    connect(m_tabs, &QTabWidget::currentChanged, m_divide,
            [this](int tab) { m_divide->setShare(tab == LabTab ? 0.5 : 0.3); });

    m_message = new MessageBar(m_context);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_topBar);
    layout->addWidget(m_message);
    layout->addWidget(m_divide, 1);
    layout->addWidget(new TimelineBar(m_context));
    setCentralWidget(centre);
}

void MainWindow::addShortcut(const QKeySequence& keys, std::function<void()> action,
                             bool (*givesWayTo)(const QWidget*)) {
    auto* shortcut = new QShortcut(keys, this);
    connect(shortcut, &QShortcut::activated, this, std::move(action));
    if (givesWayTo)
        connect(qApp, &QApplication::focusChanged, shortcut,
                [=](QWidget*, QWidget* now) { shortcut->setEnabled(!givesWayTo(now)); });
}

void MainWindow::buildShortcuts() {
    Playhead& playhead = m_context.playhead;
    addShortcut(
        Qt::Key_Space, [&playhead] { playhead.togglePlaying(); }, usesSpace);
    addShortcut(
        Qt::Key_Left, [&playhead] { playhead.stepFrames(-1); }, usesArrows);
    addShortcut(
        Qt::Key_Right, [&playhead] { playhead.stepFrames(+1); }, usesArrows);
    addShortcut(Qt::CTRL | Qt::Key_Left, [&playhead] { playhead.stepCollisions(-1); });
    addShortcut(Qt::CTRL | Qt::Key_Right, [&playhead] { playhead.stepCollisions(+1); });
    addShortcut(
        Qt::Key_Up, [&playhead] { playhead.stepStage(-1); }, usesArrows);
    addShortcut(
        Qt::Key_Down, [&playhead] { playhead.stepStage(+1); }, usesArrows);
    addShortcut(Qt::Key_Escape, [&playhead] { playhead.clearSelection(); });
    addShortcut(Qt::Key_R, [this] { m_context.session.reset(); });
    addShortcut(Qt::Key_F11, [this] { setProjector(!m_context.appearance.projector()); });
    addShortcut(Qt::Key_L, [this] { toggleLanguage(); });
    addShortcut(QKeySequence::Open, [this] { chooseFile(); });
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
    m_tabs->setCurrentIndex(LabTab);
    m_lab->choose(preset);
}

bool MainWindow::isMeasuring() const {
    return m_lab->running();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->urls().size() == 1 && event->mimeData()->urls().first().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    openFile(event->mimeData()->urls().first().toLocalFile());
}

void MainWindow::setProjector(bool on) {
    m_context.appearance.setProjector(on);
    m_projector->setChecked(on);
}

void MainWindow::setReducedMotion(bool on) {
    m_context.appearance.setReducedMotion(on);
    m_lane->setReducedMotion(on);
}

// A throw has its attributes, other scenes have their bodies'; each opens on what there is to do first.
void MainWindow::showPanelsFor(const Run& run) {
    const bool isThrow = run.scene.lane && m_context.session.currentThrow();
    QWidget* wanted = isThrow ? static_cast<QWidget*>(m_throw) : m_bodies;
    if (m_attributes->currentWidget() == wanted)
        return;
    m_attributes->setCurrentWidget(wanted);
    if (m_tabs->currentIndex() != LabTab) // which has its own ways with a scene
        m_tabs->setCurrentIndex(isThrow ? AttributesTab : StepsTab);
    retranslate();
}

// A collision that was picked on the lane or the bar opens; the list stays where its reader is.
void MainWindow::openSelection() {
    if (m_context.playhead.selected() && m_tabs->currentIndex() == AttributesTab)
        m_tabs->setCurrentIndex(StepsTab);
}

void MainWindow::retranslate() {
    setWindowTitle("ThetaLane");
    m_tabs->setTabText(StepsTab, tr("Steps"));
    m_tabs->setTabText(CollisionsTab, tr("Collisions"));
    const bool isThrow = m_attributes->currentWidget() == m_throw;
    m_tabs->setTabText(AttributesTab, isThrow ? tr("Throw") : tr("Bodies"));
    m_tabs->setTabText(LabTab, tr("Accuracy"));
    m_reset->setWords(tr("Reset the scene"), tr("Reset the scene (R)"));
    m_projector->setText(tr("Projector"));
    m_projector->setToolTip(tr("Large type and lines for a projector (F11)"));
    m_korean->setText("한국어");
    m_english->setText("English");
    for (QToolButton* b : {m_korean, m_english})
        b->setToolTip(tr("Language of everything (L)"));
    m_korean->setChecked(m_language.code() == Language::Code::Korean);
    m_english->setChecked(m_language.code() == Language::Code::English);
}

void MainWindow::styleApplication() {
    const Appearance& look = m_context.appearance;
    qApp->setFont(look.font(Appearance::Size::Normal));
    qApp->setPalette(look.palette());
    qApp->setStyleSheet(look.styleSheet());
}

void MainWindow::applyAppearance() {
    const Appearance& look = m_context.appearance;
    const int u = look.unit();
    m_topBar->layout()->setContentsMargins(u, u / 2, u, u / 2);
    m_topBar->layout()->setSpacing(u);
    m_projector->setIcon(makeIcon(Icon::Projector, look.text(), look.quietText()));
    m_projector->setIconSize(QSize(2 * u, 2 * u));
    m_tabs->setMinimumWidth(look.projector() ? 480 : 344);
    m_tabs->setMaximumWidth(look.projector() ? 800 : 560);
}

void MainWindow::restoreState() {
    const QSettings settings;
    restoreGeometry(settings.value("window/geometry").toByteArray());
    m_divide->recall(settings.value("window/divide").toByteArray());
    setProjector(settings.value("window/projector", false).toBool());
}

void MainWindow::saveState() const {
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/divide", m_divide->remembered());
    settings.setValue("window/projector", m_context.appearance.projector());
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
