#include "ui/bench/file_bar.h"

#include "ui/bench/history_icon.h"
#include "ui/panels/icons.h"
#include "ui/panels/panel.h"

#include <QAction>
#include <QApplication>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

namespace thetalane {
namespace {

QToolButton* barButton(const char* name, QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QLatin1String(name));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return button;
}

} // namespace

FileBar::FileBar(const Context& context, FileFlow& flow, QWidget* parent)
    : QWidget(parent)
    , m_appearance(context.appearance)
    , m_flow(flow)
    , m_file(barButton("fileButton", this))
    , m_undo(barButton("undoButton", this))
    , m_redo(barButton("redoButton", this))
    , m_menu(new QMenu(this))
    , m_recent(new QMenu(this)) {
    setObjectName(QStringLiteral("fileBar"));
    buildMenu();
    m_file->setMenu(m_menu);
    m_file->setPopupMode(QToolButton::InstantPopup);
    m_undo->setToolButtonStyle(Qt::ToolButtonIconOnly);
    m_redo->setToolButtonStyle(Qt::ToolButtonIconOnly);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (QToolButton* button : {m_file, m_undo, m_redo})
        layout->addWidget(button);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    connect(m_undo, &QToolButton::clicked, m_acts[Undo], &QAction::trigger);
    connect(m_redo, &QToolButton::clicked, m_acts[Redo], &QAction::trigger);
    connect(&flow.desk(), &Desk::changed, this, &FileBar::showState);
    connect(m_recent, &QMenu::aboutToShow, this, &FileBar::fillRecent);
    connect(&m_appearance, &Appearance::changed, this, &FileBar::restyle);
    qApp->installEventFilter(this);
    restyle();
    retranslate();
}

void FileBar::buildMenu() {
    Desk& desk = m_flow.desk();
    const auto act = [this](Act which, const char* name, const QList<QKeySequence>& keys,
                            std::function<void()> does) {
        auto* action = new QAction(this);
        action->setObjectName(QLatin1String(name));
        action->setShortcuts(keys);
        addAction(action); // the keys work without the menu
        connect(action, &QAction::triggered, this, std::move(does));
        m_acts[which] = action;
    };
    act(New, "newAction", {QKeySequence(Qt::CTRL | Qt::Key_N)}, [this] { m_flow.openNew(); });
    act(Open, "openAction", {QKeySequence(Qt::CTRL | Qt::Key_O)}, [this] { m_flow.chooseAndOpen(); });
    act(Save, "saveAction", {QKeySequence(Qt::CTRL | Qt::Key_S)}, [this] { m_flow.save(); });
    act(SaveAs, "saveAsAction", {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)},
        [this] { m_flow.saveAs(); });
    act(Undo, "undoAction", {QKeySequence(Qt::CTRL | Qt::Key_Z)}, [&desk] { desk.undo(); });
    act(Redo, "redoAction",
        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
        [&desk] { desk.redo(); });
    m_menu->setObjectName(QStringLiteral("fileMenu"));
    m_recent->setObjectName(QStringLiteral("recentMenu"));
    m_menu->addAction(m_acts[New]);
    m_menu->addAction(m_acts[Open]);
    m_menu->addMenu(m_recent);
    m_menu->addSeparator();
    m_menu->addAction(m_acts[Save]);
    m_menu->addAction(m_acts[SaveAs]);
}

void FileBar::retranslate() {
    m_file->setText(tr("File"));
    m_file->setToolTip(tr("New, open, save"));
    m_file->setAccessibleName(tr("File"));
    m_acts[New]->setText(tr("New"));
    m_acts[Open]->setText(tr("Open…"));
    m_acts[Save]->setText(tr("Save"));
    m_acts[SaveAs]->setText(tr("Save as…"));
    m_recent->setTitle(tr("Recent files"));
    showState();
}

void FileBar::restyle() {
    const int unit = m_appearance.unit();
    setStyleSheet(panelStyle(m_appearance) + QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    for (QMenu* menu : {m_menu, m_recent})
        menu->setFont(m_appearance.font(Appearance::Size::Normal));
    for (QToolButton* button : {m_undo, m_redo}) {
        button->setIcon(historyIcon(button == m_redo, m_appearance.text(), m_appearance.line()));
        button->setIconSize(QSize(2 * unit + 4, 2 * unit + 4));
    }
    showState();
}

void FileBar::showState() {
    const Desk& desk = m_flow.desk();
    m_acts[Undo]->setEnabled(desk.canUndo());
    m_acts[Redo]->setEnabled(desk.canRedo());
    const QString undo = desk.undoText(), redo = desk.redoText();
    m_acts[Undo]->setText(undo.isEmpty() ? tr("Undo") : tr("Undo: %1").arg(undo));
    m_acts[Redo]->setText(redo.isEmpty() ? tr("Redo") : tr("Redo: %1").arg(redo));
    for (const auto& [button, act] : {std::pair(m_undo, Undo), std::pair(m_redo, Redo)}) {
        button->setEnabled(m_acts[act]->isEnabled());
        button->setAccessibleName(m_acts[act]->text());
        button->setToolTip(QStringLiteral("%1 (%2)").arg(
            m_acts[act]->text(), m_acts[act]->shortcut().toString(QKeySequence::NativeText)));
    }
}

// Asked for when it is looked at: only then is it known which of the files are still there.
void FileBar::fillRecent() {
    m_recent->clear();
    const QStringList files = m_flow.desk().recentFiles();
    for (const QString& path : files) {
        const QFileInfo info(path);
        const QString name = info.fileName().replace(u'&', QStringLiteral("&&"));
        QAction* action = m_recent->addAction(info.exists() ? name : tr("%1 (not found)").arg(name));
        action->setData(path);
        action->setToolTip(path);
        action->setEnabled(info.exists());
        connect(action, &QAction::triggered, this, [this, path] { m_flow.open(path); });
    }
    if (files.isEmpty())
        return m_recent->addAction(tr("None yet"))->setEnabled(false);
    m_recent->addSeparator();
    QAction* clear = m_recent->addAction(tr("Forget these files"));
    clear->setObjectName(QStringLiteral("clearRecentAction"));
    connect(clear, &QAction::triggered, &m_flow.desk(), &Desk::clearRecentFiles);
}

void FileBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

// A field with nothing typed in it to take back leaves the keys of undo and redo to the scene.
bool FileBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* edit = qobject_cast<QLineEdit*>(watched);
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool undo = edit && key->matches(QKeySequence::Undo) && !edit->isUndoAvailable();
        const bool redo = edit && !edit->isRedoAvailable() &&
                          (key->matches(QKeySequence::Redo) ||
                           (key->key() == Qt::Key_Y && key->modifiers() == Qt::ControlModifier));
        if (undo || redo) {
            event->ignore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace thetalane
