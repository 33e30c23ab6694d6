// The bent arrows of undo and redo, drawn anew at every size.
#pragma once

#include <QColor>
#include <QIcon>

namespace thetalane {

QIcon historyIcon(bool forward, const QColor& colour, const QColor& disabled);

} // namespace thetalane
