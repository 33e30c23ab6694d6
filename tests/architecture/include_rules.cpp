#include "tests/architecture/include_rules.h"

#include <QRegularExpression>

namespace thetalane::architecture {
namespace {

// Rooms of the same level know nothing of each other; every room may include those of lower levels.
struct Room {
    const char* name;
    int level;
};
// The longer names first: a path belongs to the first room that it starts with.
// clang-format off
constexpr Room rooms[] = {
    {"core/math", 0}, {"core/collision", 1}, {"core/motion", 1}, {"core/scene", 2}, {"core/timeline", 3},
    {"core/engine", 4}, {"core/bowling", 5}, {"core/study", 6}, {"core/format", 7},
    {"ui/words", 8}, {"ui/plot", 9},
    {"ui/lane", 11}, {"ui/steps", 11}, {"ui/panels", 11}, {"ui/rail", 11},
    {"ui/bench/rules", 9},
    {"ui/aim", 12}, {"ui/bench", 12}, {"ui/game", 12}, {"ui/help", 12}, {"ui/lab", 12}, {"ui/lessons", 12},
    {"ui/map", 12}, {"ui/practice", 12}, {"ui/predict", 12}, {"ui/who", 12}, {"ui/worksheet", 12},
    {"ui/tables", 13}, {"ui/window", 14}, {"ui", 10}, {"app", 15},
};
// clang-format on

int levelOf(const QString& room) {
    for (const Room& r : rooms)
        if (room == QLatin1String(r.name))
            return r.level;
    return -1;
}

bool isView(const QString& room) {
    return room == "ui/lane" || room == "ui/steps" || room == "ui/panels";
}

// Panels are shown what an engine made; they never see one.
QString forbiddenToViews(const QString& path, const QString& room, const QString& target) {
    static const QStringList engines{"core/engine/engines.h", "core/engine/next_event_engine.h",
                                     "core/engine/models.h", "core/motion/impact.h"};
    // The lab and the game see engines by their results, as the command line does.
    if (room.startsWith("ui/") && engines.contains(target))
        return "a view includes an engine";
    if (!isView(room))
        return {};
    const QString targetRoom = roomOf(target);
    if (isView(targetRoom) && targetRoom != room)
        return "a view includes another view";
    const QString stem = path.left(path.lastIndexOf('.')), targetStem = target.left(target.lastIndexOf('.'));
    // Within ui/panels each panel is a room of its own; x_panel_words.cpp is of x_panel.h.
    const bool own = stem == targetStem || stem.startsWith(targetStem + '_');
    if (room == "ui/panels" && targetRoom == room && !own && target.endsWith("_panel.h"))
        return "a panel includes another panel";
    return {};
}

QString broken(const QString& path, const Include& include) {
    const QString room = roomOf(path);
    if (!include.quoted) {
        static const QRegularExpression qt("^(Qt|Q[A-Z])");
        return room.startsWith("core/") && room != "core/format" && qt.match(include.target).hasMatch()
                   ? QString("core/ has no Qt outside core/format")
                   : QString();
    }
    if (include.target.endsWith(".moc") || include.target.startsWith("ui_"))
        return {};
    const QString targetRoom = roomOf(include.target);
    if (targetRoom.isEmpty())
        return "not included from the repository's root, or no known room";
    if (const QString why = forbiddenToViews(path, room, include.target); !why.isEmpty())
        return why;
    const int own = levelOf(room), other = levelOf(targetRoom);
    if (targetRoom == room)
        return {};
    return other < own ? QString() : QString("a room includes one that is built on it, or beside it");
}

// Comments taken out, lines kept; a #include cannot stand in a string of this repository.
QString withoutComments(QString source) {
    static const QRegularExpression block("/\\*.*?\\*/", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression line("//[^\n]*");
    for (auto m = block.match(source); m.hasMatch(); m = block.match(source))
        source.replace(m.capturedStart(), m.capturedLength(), QString(m.captured().count('\n'), '\n'));
    return source.remove(line);
}

} // namespace

QString roomOf(const QString& path) {
    for (const Room& r : rooms)
        if (path.startsWith(QLatin1String(r.name) + '/'))
            return r.name;
    return {};
}

QList<Include> includesOf(const QString& source) {
    static const QRegularExpression directive("^\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"]");
    QList<Include> found;
    int number = 0;
    for (const QString& line : withoutComments(source).split('\n')) {
        ++number;
        if (const auto m = directive.match(line); m.hasMatch())
            found.append({m.captured(2), m.captured(1) == "\"", number});
    }
    return found;
}

QStringList violations(const QString& path, const QString& source) {
    QStringList out;
    if (roomOf(path).isEmpty())
        return {path + ": in no known room"};
    for (const Include& include : includesOf(source))
        if (const QString why = broken(path, include); !why.isEmpty())
            out << QString("%1:%2: %3 (%4)").arg(path).arg(include.line).arg(why, include.target);
    return out;
}

} // namespace thetalane::architecture
