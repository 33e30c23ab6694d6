// How the entries of the rooms look.
#pragma once

#include "ui/rail/rooms.h"

#include <QPainterPath>

namespace thetalane {

// To be filled, on a grid of 24 by 24.
QPainterPath roomIcon(Room room);

} // namespace thetalane
