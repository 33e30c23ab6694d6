// What is wrong with a delivery, a correction or a game file, in words: what, where, and what would be right.
#pragma once

#include "core/format/game_file.h"

#include <QString>

namespace thetalane {

// Without a place: "only 4 pins stand, not 5".
QString deliveryErrorMessage(const DeliveryError& error);
QString gameErrorMessage(const GameError& error);

// With the place: "players[0].deliveries[3].pins: must be from 0 to 4, the pins that stand, is 5".
QString gameFileErrorText(const GameFileError& error);

} // namespace thetalane
