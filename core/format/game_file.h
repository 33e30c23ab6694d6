// Game files, version 1: what was thrown and what fell, delivery by delivery. See README, "Game files".
#pragma once

#include "core/bowling/game.h"
#include "core/scene/validation.h"

#include <QByteArray>

namespace thetalane {

enum class GameFileFault {
    Shape,        // scene: what the JSON itself has wrong; its path and words are those of a scene file
    WrongFormat,  // text
    WrongVersion, // value
    WrongRules,   // text
    PlayerCount,  // value, high
    NoName,
    Colour, // value, high
    NotABool,
    NotWhole,       // value: a count or a pin must be a whole number
    PinNumber,      // value, high
    PinTwice,       // value
    CountDiffers,   // value: "pins"; high: how many "down" names
    TooManyPins,    // value; high: how many stand
    NegativePins,   // value
    PinNotStanding, // value: the pin
    GameOver,       // nothing is left to be played
    NotMet,         // the pins that stood are not those that the deliveries before left
    OutOfTurn,      // value: this player's frames; high: the most that the other players' allow
};

// path: as in the file, players[0].deliveries[3].pins; empty for Shape.
struct GameFileError {
    GameFileFault fault{};
    std::string path{};
    double value = 0;
    double high = 0;
    std::string text{};
    SceneError scene{};
};

// The game, or the first thing that is wrong.
std::variant<Game, GameFileError> readGame(const QByteArray& json);

// A delivery a line; reads back to the same game, to the last bit.
QByteArray writeGame(const Game& game);

} // namespace thetalane
