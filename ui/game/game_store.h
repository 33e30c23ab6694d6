// The games on the disk: one file a game, written beside the old one and then renamed, so that a reader finds
// the one or the other, whole.
#pragma once

#include "core/format/game_file.h"

#include <QDateTime>
#include <QHash>
#include <QString>

#include <optional>
#include <variant>
#include <vector>

namespace thetalane {

// Why a file could not be read: what the system says, or what is wrong in it.
struct StoreFault {
    QString system;
    std::optional<GameFileError> file;
};

struct SavedGame {
    QString path;
    QDateTime modified;
    qint64 size = 0;
    std::variant<Game, StoreFault> content;
    std::vector<Statistics> statistics; // of each player

    const Game* game() const { return std::get_if<Game>(&content); }
    const StoreFault* fault() const { return std::get_if<StoreFault>(&content); }
};

class GameStore {
public:
    explicit GameStore(const QString& directory);

    // AppDataLocation/games.
    static QString usualDirectory();

    QString directory() const { return m_directory; }
    QString newPath() const; // of no file yet

    std::variant<Game, StoreFault> load(const QString& path) const;
    // What the system says if it fails, and then the old file stays; empty when done.
    QString save(const QString& path, const Game& game) const;

    // All of them, the latest first. Files that are as they were are not read again.
    const std::vector<SavedGame>& list();

private:
    QString m_directory;
    std::vector<SavedGame> m_saved;
};

} // namespace thetalane
