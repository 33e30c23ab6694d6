// Scene files on the disk. What is written is written whole: beside the file, then put into its place; a
// kill, a full disk or a missing right in the middle leaves the file of before.
#pragma once

#include "core/format/scene_file.h"

#include <QDateTime>
#include <QLockFile>
#include <QString>

#include <functional>
#include <memory>
#include <variant>
#include <vector>

namespace thetalane {

// Said when asked, in the language of now.
using Words = std::function<QString()>;

// The reason why not; nothing when done.
Words saveWhole(const QString& path, const QByteArray& bytes);

std::variant<Scene, Words> readSceneFile(const QString& path);

// Edits that were not saved when the program ended.
struct Unsaved {
    QString place; // of the recovery file
    QString file;  // the scene's own, if it has one
    QDateTime time;
    Scene scene;
    std::shared_ptr<QLockFile> lock; // while we hold it no other program offers it
};

// One program's place in the directory of recoveries. Each keeps a lock beside its file for as long as it
// lives, so that two programs at once do not take each other's for a crashed one's.
class RecoveryStore {
public:
    explicit RecoveryStore(const QString& directory);
    ~RecoveryStore(); // an orderly end leaves nothing
    RecoveryStore(const RecoveryStore&) = delete;
    RecoveryStore& operator=(const RecoveryStore&) = delete;

    Words keep(const Scene& scene, const QString& file); // the reason why not
    void drop();
    QString place() const { return m_place; }

    // Of programs that are no more; the newest first.
    std::vector<Unsaved> orphans() const;
    static void discard(Unsaved& unsaved);

private:
    QString m_directory;
    QString m_place;
    std::unique_ptr<QLockFile> m_lock;
};

} // namespace thetalane
