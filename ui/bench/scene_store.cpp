#include "ui/bench/scene_store.h"

#include "ui/words/scene_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>

namespace thetalane {
namespace {

struct StoreText {
    Q_DECLARE_TR_FUNCTIONS(SceneStore)
};

const QString recoverySuffix = QStringLiteral(".recovery");

QString lockPlace(const QString& recovery) {
    return recovery + QStringLiteral(".lock");
}

std::unique_ptr<QLockFile> lockFor(const QString& recovery) {
    auto lock = std::make_unique<QLockFile>(lockPlace(recovery));
    lock->setStaleLockTime(0); // for as long as its program lives, however long that is
    return lock;
}

// The first line says whose it is, the rest is the scene file.
std::optional<Unsaved> readRecovery(const QString& place) {
    QFile file(place);
    if (!file.open(QIODevice::ReadOnly) || file.size() > maxSceneFileSize)
        return std::nullopt;
    const auto about = QJsonDocument::fromJson(file.readLine()).object();
    auto scene = readScene(file.readAll());
    if (!std::holds_alternative<Scene>(scene))
        return std::nullopt;
    return Unsaved{place, about.value("file").toString(),
                   QDateTime::fromString(about.value("time").toString(), Qt::ISODate),
                   std::get<Scene>(std::move(scene)), nullptr};
}

// Flushed and asked first: commit() does not see that the last buffer found no room, and would put half a
// file into the whole one's place.
bool putInPlace(QSaveFile& file, const QByteArray& bytes) {
    file.setDirectWriteFallback(false);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush() &&
           file.commit();
}

} // namespace

Words saveWhole(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (putInPlace(file, bytes))
        return {};
    const QString name = QFileInfo(path).fileName(), reason = file.errorString();
    return [name, reason] {
        return StoreText::tr("%1 could not be saved: %2. What was saved before is still there.")
            .arg(name, reason);
    };
}

std::variant<Scene, Words> readSceneFile(const QString& path) {
    const QString name = QFileInfo(path).fileName();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return [text = name + ": " + file.errorString()] { return text; };
    if (file.size() > maxSceneFileSize)
        return [name] { return StoreText::tr("%1: is too large for a scene file").arg(name); };
    auto result = readScene(file.readAll());
    if (const auto* errors = std::get_if<std::vector<SceneError>>(&result))
        return [name, e = errors->front()] { return name + ": " + sceneErrorText(e); };
    return std::get<Scene>(std::move(result));
}

RecoveryStore::RecoveryStore(const QString& directory)
    : m_directory(directory)
    , m_place(QDir(directory).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + recoverySuffix)) {
}

RecoveryStore::~RecoveryStore() {
    drop();
}

Words RecoveryStore::keep(const Scene& scene, const QString& file) {
    const auto cannot = [](const QString& reason) {
        return [reason] { return StoreText::tr("Unsaved edits cannot be kept safe: %1").arg(reason); };
    };
    if (!QDir().mkpath(m_directory))
        return cannot(QDir::toNativeSeparators(m_directory));
    if (!m_lock) { // before there is anything to find
        m_lock = lockFor(m_place);
        m_lock->tryLock();
    }
    const QJsonObject about{{"file", file}, {"time", QDateTime::currentDateTime().toString(Qt::ISODate)}};
    QSaveFile out(m_place);
    const QByteArray bytes = QJsonDocument(about).toJson(QJsonDocument::Compact) + '\n' + writeScene(scene);
    if (!putInPlace(out, bytes))
        return cannot(out.errorString());
    return {};
}

void RecoveryStore::drop() {
    if (!m_lock)
        return;
    QFile::remove(m_place);
    m_lock.reset();
}

std::vector<Unsaved> RecoveryStore::orphans() const {
    std::vector<Unsaved> found;
    const QDir directory(m_directory);
    for (const QString& name : directory.entryList({'*' + recoverySuffix}, QDir::Files)) {
        const QString place = directory.filePath(name);
        if (place == m_place)
            continue;
        std::shared_ptr<QLockFile> lock = lockFor(place);
        if (!lock->tryLock())
            continue; // its program lives
        if (auto unsaved = readRecovery(place)) {
            unsaved->lock = std::move(lock);
            found.push_back(*std::move(unsaved));
        }
    }
    std::sort(found.begin(), found.end(), [](const Unsaved& a, const Unsaved& b) { return a.time > b.time; });
    return found;
}

void RecoveryStore::discard(Unsaved& unsaved) {
    QFile::remove(unsaved.place);
    unsaved.lock.reset();
}

} // namespace thetalane
