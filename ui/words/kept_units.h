// Units that stay in one piece where a line ends.
#pragma once

#include <QString>

namespace thetalane {

// With joiners and spaces that hold: no line ends in "m/" or begins with "J".
QString keptUnits(QString text);

} // namespace thetalane
