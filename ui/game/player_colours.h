// The eight colours of players: Okabe and Ito's, which colour-blind eyes can tell apart.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace thetalane {

QColor playerColour(int colour);
QString playerColourName(int colour);

// A round spot of it, for buttons and lists.
QIcon playerIcon(int colour, int side);

} // namespace thetalane
