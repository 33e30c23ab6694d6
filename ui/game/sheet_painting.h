// How a score sheet looks: what an alley hangs over its lanes.
#pragma once

#include "core/bowling/game.h"
#include "ui/game/sheet_layout.h"

#include <vector>

class QPainter;

namespace thetalane {

struct SheetContent {
    const Game& game;
    const std::vector<Scorecard>& cards; // of each player
    std::optional<GameTurn> turn;        // nothing once the game is over
    std::optional<SheetPlace> cursor;    // of the keyboard
    std::optional<SheetPlace> hovered;
    std::optional<SheetPlace> replayed;
    QString nameWord, totalWord, mostWord; // "most %1"
};

// The delivery in a place of the sheet, from 0: a strike has its frame to itself but for the last one.
std::optional<std::size_t> deliveryAt(const Scorecard& card, int frame, int roll, int rollCount);

void paintSheet(QPainter& painter, const SheetLayout& layout, const SheetContent& content,
                const Appearance& appearance);
// The numbers of the frames, at `top`: over the rows, however far these are scrolled.
void paintSheetHeader(QPainter& painter, const SheetLayout& layout, const SheetContent& content,
                      const Appearance& appearance, double top);

} // namespace thetalane
