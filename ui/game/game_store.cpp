#include "ui/game/game_store.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>

namespace thetalane {
namespace {

constexpr qint64 mostBytes = 4 << 20; // a game of eight is 60 kB; whatever is larger is none

std::vector<Statistics> statisticsOfAll(const std::variant<Game, StoreFault>& content) {
    std::vector<Statistics> all;
    if (const auto* game = std::get_if<Game>(&content))
        for (std::size_t k = 0; k < game->players.size(); ++k)
            all.push_back(statisticsOf(*game, k));
    return all;
}

} // namespace

GameStore::GameStore(const QString& directory)
    : m_directory(directory) {}

QString GameStore::usualDirectory() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/games");
}

// Named by the time, so that the names sort as the games were played.
QString GameStore::newPath() const {
    const QString stem =
        m_directory + QDateTime::currentDateTime().toString(QStringLiteral("/yyyy-MM-dd-HHmmss-zzz"));
    QString path = stem + QStringLiteral(".json");
    for (int k = 2; QFile::exists(path); ++k)
        path = stem + QStringLiteral("-%1.json").arg(k);
    return path;
}

std::variant<Game, StoreFault> GameStore::load(const QString& path) const {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return StoreFault{file.errorString(), {}};
    auto read = readGame(file.read(mostBytes));
    if (auto* error = std::get_if<GameFileError>(&read))
        return StoreFault{{}, std::move(*error)};
    return std::get<Game>(std::move(read));
}

QString GameStore::save(const QString& path, const Game& game) const {
    QDir().mkpath(m_directory); // if it fails, opening the file says so
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString();
    file.write(writeGame(game));
    // commit() alone may rename a file whose last bytes found no room
    return file.flush() && file.commit() ? QString() : file.errorString();
}

const std::vector<SavedGame>& GameStore::list() {
    std::vector<SavedGame> found;
    const auto entries = QDir(m_directory).entryInfoList({QStringLiteral("*.json")}, QDir::Files);
    for (const QFileInfo& entry : entries) {
        const QString path = entry.filePath();
        const auto known = std::find_if(m_saved.begin(), m_saved.end(), [&](const SavedGame& s) {
            return s.path == path && s.modified == entry.lastModified() && s.size == entry.size();
        });
        if (known != m_saved.end()) {
            found.push_back(std::move(*known));
            m_saved.erase(known);
            continue;
        }
        SavedGame saved{path, entry.lastModified(), entry.size(), load(path), {}};
        saved.statistics = statisticsOfAll(saved.content);
        found.push_back(std::move(saved));
    }
    std::sort(found.begin(), found.end(), [](const SavedGame& a, const SavedGame& b) {
        return a.modified != b.modified ? a.modified > b.modified : a.path > b.path;
    });
    m_saved = std::move(found);
    return m_saved;
}

} // namespace thetalane
