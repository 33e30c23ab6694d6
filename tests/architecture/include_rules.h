// Which file may include which: rooms are built one on another, and a file includes its own room or earlier
// ones.
#pragma once

#include <QString>
#include <QStringList>

namespace thetalane::architecture {

// Where a file lives ("core/math", "ui/panels", "app"); empty if in no known room.
QString roomOf(const QString& path);

// Every #include "…" and #include <…> of a source text, comments apart, with the line it stands on.
struct Include {
    QString target;
    bool quoted = false;
    int line = 0;
};
QList<Include> includesOf(const QString& source);

// What a file breaks by its includes: one message each, "path:line: why". Empty when it keeps the rules.
QStringList violations(const QString& path, const QString& source);

} // namespace thetalane::architecture
