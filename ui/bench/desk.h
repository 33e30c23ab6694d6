// The scene as a document: every edit, whoever made it, can be undone; the file it belongs to; what is not
// saved yet is kept safe. No dialogs: those are FileFlow's.
//
// An undo brings back the whole value of before, to the last bit. One command is one gesture: all that
// happens between a press of the mouse and its release, wherever that is (or beginGesture() and
// endGesture()), and edits of the same kind to the same body within `mergeWithin` of each other (keys that
// are held, a wheel). A gesture that ends where it began, as one abandoned by Escape does, leaves no command.
// The history holds at most 500 commands and about 64 MB.
#pragma once

#include "ui/bench/deed.h"
#include "ui/bench/scene_store.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QUndoStack>

#include <optional>

namespace thetalane {

class Desk : public QObject {
    Q_OBJECT
public:
    static constexpr int mostRecent = 10;

    explicit Desk(Session& session, QObject* parent = nullptr);
    ~Desk() override;

    bool canUndo() const { return m_recording && (m_stack.canUndo() || isPending()); }
    bool canRedo() const { return m_recording && m_stack.canRedo(); }
    QString undoText() const; // "move A", or empty
    QString redoText() const;
    int undoCount() const { return m_stack.index(); }

    void beginGesture();
    void endGesture();
    void setMergeWithin(int milliseconds) { m_mergeWithin = milliseconds; }

    // Off while a game or a lesson has the scene: nothing is recorded or asked about, and there is no undo.
    void setRecording(bool on);

    // The file; empty for a scene without one. Its name, without directory and ending; may be empty.
    QString file() const { return m_file; }
    QString documentName() const;
    // Throws are played, not kept: they alone are no unsaved changes.
    bool isModified() const;

    // False: failed() has said why, and everything is as it was.
    bool open(const QString& path);
    bool save(const QString& path);
    void openNew();

    QStringList recentFiles() const; // the newest first; they may be missing by now
    void clearRecentFiles();

    // Where unsaved edits are kept; before it is called, nowhere.
    static QString usualRecoveryPlace();
    void keepRecoveriesIn(const QString& directory, int everyMilliseconds = 3000);
    const std::vector<Unsaved>& recoverable() const { return m_unsaved; }
    void recover(std::size_t index);
    void discardRecovery(std::size_t index);

public slots:
    void undo();
    void redo();

signals:
    void changed(); // what can be undone, the file, whether it is modified, what can be recovered
    void failed(const thetalane::Words& why);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    friend class EditCommand;
    using Kept = std::shared_ptr<const Subject>; // a command's after is the next one's before

    bool isPending() const;
    void takeEdit(const Subject& before);
    void takeOpened();
    void record(const Deed& deed);
    void startAgain(const QString& file);
    void bringBack(const Kept& subject, const QString* file);
    void note(const QString& path);
    void autosave();
    void scheduleAutosave();

    Session& m_session;
    QUndoStack m_stack;
    Kept m_now;    // as the stack has it
    Kept m_opened; // what a reset goes back to
    QString m_file;
    bool m_recording = true;
    bool m_opening = false; // by ourselves
    bool m_gesture = false;
    int m_gestureNumber = 0;
    int m_mergeWithin = 1000;  // [ms]
    QElapsedTimer m_sinceEdit; // the last one recorded
    QTimer m_autosave;
    std::unique_ptr<RecoveryStore> m_store;
    std::vector<Unsaved> m_unsaved;
    bool m_saidUnsafe = false;
};

} // namespace thetalane
