// The program's mark, drawn: two discs in contact, the line of centres, θ. The same as app/thetalane.svg.
#pragma once

#include <QIcon>

namespace thetalane {

QIcon applicationIcon();

} // namespace thetalane
