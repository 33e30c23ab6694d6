// A file written whole, or not at all: under another name first, then renamed.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace thetalane {

// The status to leave with; what went wrong is told.
int saveFile(const QString& path, const QByteArray& bytes);

// Before work of a minute: the status to leave with where nothing could be written there.
std::optional<int> cannotSave(const QString& path);

} // namespace thetalane
