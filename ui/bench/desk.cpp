#include "ui/bench/desk.h"

#include "ui/bench/rules/placing.h"

#include <QCoreApplication>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace thetalane {

// Whole values: the edit itself happened before it was pushed, so the first redo finds nothing to do.
class EditCommand : public QUndoCommand {
public:
    EditCommand(Desk& desk, Desk::Kept before, Desk::Kept after, Deed deed, int id)
        : m_desk(desk)
        , m_before(std::move(before))
        , m_after(std::move(after))
        , m_deed(std::move(deed))
        , m_id(id) {}

    // Of another scene: which file was behind it, and is now.
    void setFiles(const QString& before, const QString& after) { m_files = {before, after}; }
    const Deed& deed() const { return m_deed; }

    int id() const override { return m_id; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto& next = static_cast<const EditCommand&>(*other);
        if (!(next.m_deed == m_deed) || !next.m_joins)
            return false;
        m_after = next.m_after;
        setObsolete(*m_after == *m_before);
        return true;
    }
    void setJoins(bool joins) { m_joins = joins; }

    void undo() override { m_desk.bringBack(m_before, m_files ? &m_files->first : nullptr); }
    void redo() override {
        if (m_done)
            m_desk.bringBack(m_after, m_files ? &m_files->second : nullptr);
        m_done = true;
    }

private:
    Desk& m_desk;
    Desk::Kept m_before, m_after;
    Deed m_deed;
    int m_id;
    std::optional<std::pair<QString, QString>> m_files;
    bool m_joins = false; // soon after the one before
    bool m_done = false;
};

namespace {

constexpr int mergeable = 1, single = -1; // QUndoCommand::id()
const auto recentKey = QStringLiteral("files/recent");

QString textOf(const QUndoCommand* command) {
    return command ? deedText(static_cast<const EditCommand*>(command)->deed()) : QString();
}

int historyFor(const Scene& scene) {
    constexpr std::size_t most = 500, bytes = std::size_t(64) << 20;
    const std::size_t each = sizeof(Subject) + scene.bodies.size() * (sizeof(Body) + 16);
    return int(std::clamp(bytes / each, std::size_t(3), most));
}

} // namespace

Desk::Desk(Session& session, QObject* parent)
    : QObject(parent)
    , m_session(session) {
    m_autosave.setSingleShot(true);
    connect(&m_autosave, &QTimer::timeout, this, &Desk::autosave);
    connect(&session, &Session::edited, this, &Desk::takeEdit);
    connect(&session, &Session::opened, this, &Desk::takeOpened);
    QCoreApplication::instance()->installEventFilter(this);
    startAgain({});
}

Desk::~Desk() = default;

// Any press begins a gesture. Whoever has the mouse edits on release too, so it ends when that is over.
bool Desk::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick) {
        beginGesture();
    } else if (event->type() == QEvent::MouseButtonRelease && m_gesture) {
        QMetaObject::invokeMethod(
            this,
            [this, number = m_gestureNumber] {
                if (number == m_gestureNumber)
                    endGesture();
            },
            Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

// One event reaches several objects (the window, the widget, its parents): a press while nothing has changed
// is the same one.
void Desk::beginGesture() {
    if (m_gesture && !isPending())
        return void(++m_gestureNumber);
    endGesture();
    m_gesture = true;
    ++m_gestureNumber;
}

void Desk::endGesture() {
    if (!m_gesture)
        return;
    m_gesture = false;
    if (!m_recording || *m_now == m_session.subject())
        return;
    m_sinceEdit.invalidate(); // a gesture joins nothing
    record(deedOf(*m_now, m_session.subject()));
    m_sinceEdit.invalidate();
}

bool Desk::isPending() const {
    return m_gesture && !(*m_now == m_session.subject());
}

void Desk::takeEdit(const Subject& before) {
    if (!m_recording)
        return;
    scheduleAutosave();
    if (m_gesture)
        return emit changed();
    if (!(before == *m_now)) // somebody brought back an earlier one
        m_now = std::make_shared<const Subject>(before);
    record(deedOf(*m_now, m_session.subject()));
}

void Desk::record(const Deed& deed) {
    auto after = std::make_shared<const Subject>(m_session.subject());
    if (*after == *m_now)
        return;
    const bool alone = deed.kind == Deed::Kind::Add || deed.kind == Deed::Kind::Remove;
    auto* command = new EditCommand(*this, m_now, after, deed, alone ? single : mergeable);
    command->setJoins(m_sinceEdit.isValid() && m_sinceEdit.elapsed() < m_mergeWithin);
    m_now = std::move(after);
    m_stack.push(command);
    m_sinceEdit.start();
    emit changed();
}

// A reset is an edit; so is another scene that somebody opened over unsaved changes, which thus are not lost.
void Desk::takeOpened() {
    if (m_opening || !m_recording)
        return;
    m_gesture = false; // what it did so far goes with what was there before
    auto now = std::make_shared<const Subject>(m_session.subject());
    const bool reset = *now == *m_opened;
    if (!reset && (m_now->ballThrow || m_stack.isClean()))
        return startAgain({});
    if (*now == *m_now)
        return;
    const Deed deed{reset ? Deed::Kind::Reset : Deed::Kind::Open};
    auto* command = new EditCommand(*this, m_now, now, deed, single);
    if (!reset) {
        command->setFiles(m_file, {});
        m_file.clear();
        m_opened = now;
    }
    m_now = now;
    m_stack.push(command);
    scheduleAutosave();
    emit changed();
}

void Desk::bringBack(const Kept& subject, const QString* file) {
    m_now = subject;
    if (file)
        m_file = *file;
    m_session.restore(*subject);
}

QString Desk::undoText() const {
    if (!m_recording)
        return {};
    return isPending() ? deedText(deedOf(*m_now, m_session.subject()))
                       : textOf(m_stack.command(m_stack.index() - 1));
}

QString Desk::redoText() const {
    return m_recording ? textOf(m_stack.command(m_stack.index())) : QString();
}

void Desk::undo() {
    endGesture();
    if (!canUndo())
        return;
    m_sinceEdit.invalidate();
    m_stack.undo();
    scheduleAutosave();
    emit changed();
}

void Desk::redo() {
    endGesture();
    if (!canRedo())
        return;
    m_sinceEdit.invalidate();
    m_stack.redo();
    scheduleAutosave();
    emit changed();
}

void Desk::setRecording(bool on) {
    if (on == m_recording)
        return;
    endGesture();
    m_recording = on;
    if (on && !(m_session.subject() == *m_now))
        return startAgain({});
    emit changed();
}

QString Desk::documentName() const {
    return m_file.isEmpty() ? QString() : QFileInfo(m_file).completeBaseName();
}

bool Desk::isModified() const {
    return m_recording && !m_session.currentThrow() && (!m_stack.isClean() || isPending());
}

void Desk::startAgain(const QString& file) {
    m_gesture = false;
    m_stack.clear();
    m_stack.setUndoLimit(historyFor(m_session.scene()));
    m_sinceEdit.invalidate();
    m_now = std::make_shared<const Subject>(m_session.subject());
    m_opened = m_now;
    m_file = file;
    m_autosave.stop();
    if (m_store)
        m_store->drop();
    emit changed();
}

bool Desk::open(const QString& path) {
    const auto loaded = readSceneFile(path);
    if (const Words* why = std::get_if<Words>(&loaded)) {
        emit failed(*why);
        return false;
    }
    m_opening = true;
    m_session.open(std::get<Scene>(loaded));
    m_opening = false;
    startAgain(QFileInfo(path).absoluteFilePath());
    note(m_file);
    return true;
}

void Desk::openNew() {
    m_opening = true;
    m_session.open(newScene());
    m_opening = false;
    startAgain({});
}

bool Desk::save(const QString& path) {
    endGesture();
    if (const Words why = saveWhole(path, writeScene(m_session.scene()))) {
        emit failed(why);
        return false;
    }
    m_file = QFileInfo(path).absoluteFilePath();
    m_stack.setClean();
    m_sinceEdit.invalidate();
    m_autosave.stop();
    if (m_store)
        m_store->drop();
    note(m_file);
    emit changed();
    return true;
}

QStringList Desk::recentFiles() const {
    return QSettings().value(recentKey).toStringList();
}

void Desk::clearRecentFiles() {
    QSettings().remove(recentKey);
    emit changed();
}

void Desk::note(const QString& path) {
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(recentKey, files.mid(0, mostRecent));
    emit changed();
}

QString Desk::usualRecoveryPlace() {
    return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).filePath("recovery");
}

void Desk::keepRecoveriesIn(const QString& directory, int everyMilliseconds) {
    m_store = std::make_unique<RecoveryStore>(directory);
    m_autosave.setInterval(everyMilliseconds);
    m_unsaved = m_store->orphans();
    emit changed();
}

// Not put off by further edits: somebody who edits without a pause is kept safe too.
void Desk::scheduleAutosave() {
    if (m_store && !m_autosave.isActive())
        m_autosave.start();
}

void Desk::autosave() {
    if (!m_store)
        return;
    if (!isModified())
        return m_store->drop();
    const Words why = m_store->keep(m_session.scene(), m_file);
    if (why && !m_saidUnsafe)
        emit failed(why);
    m_saidUnsafe = m_saidUnsafe || why;
}

// Ours is kept before theirs is let go.
void Desk::recover(std::size_t index) {
    Unsaved unsaved = std::move(m_unsaved.at(index));
    m_unsaved.erase(m_unsaved.begin() + std::ptrdiff_t(index));
    m_opening = true;
    m_session.open(unsaved.scene);
    m_opening = false;
    startAgain(unsaved.file);
    m_stack.resetClean();
    if (!m_store->keep(m_session.scene(), m_file))
        RecoveryStore::discard(unsaved);
    emit changed();
}

void Desk::discardRecovery(std::size_t index) {
    RecoveryStore::discard(m_unsaved.at(index));
    m_unsaved.erase(m_unsaved.begin() + std::ptrdiff_t(index));
    emit changed();
}

} // namespace thetalane
