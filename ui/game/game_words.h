// A game in words: for the panel, the score sheet and screen readers.
#pragma once

#include "core/bowling/score_notation.h"
#include "ui/game/alley.h"

#include <QString>

namespace thetalane {

QString playerName(const Game& game, std::size_t player);
QString rulesText(ScoringRules rules);
QString releaseText(Release release);
QString releaseToolTip(Release release); // its standard deviations
QString laneText(const LaneConditions& lane);

// "All ten pins stand", "Pins 7, 10 stand", "No pins stand".
QString standingText(const PinSet& standing);

// "7-10 split"; "split" where which pins stood is not known.
QString splitText(const PinSet& standing);

// What a delivery was, as it is called out: "Strike!", "Turkey!", "7-10 split", "Gutter ball".
QString announcement(const Game& game, const DeliveryPlace& place);
// The line below: who, in which frame, what is left; at the end, who won.
const char* announcementTerm(const Game& game, const DeliveryPlace& place); // of the glossary
QString announcementDetail(const Game& game, const DeliveryPlace& place);
// "Minsu wins with 143 points."
QString winnerText(const Game& game);

// "Frame 3, ball 2".
QString placeText(const Turn& turn);
// "Minsu, frame 3, ball 2: 7".
QString deliveryText(const Game& game, const DeliveryPlace& place);

// The same for a list, where the name may be cut short: "Frame 3, ball 2: 7 · Minsu".
QString deliveryLine(const Game& game, const DeliveryPlace& place);

// A frame of the sheet, for screen readers: "Minsu, frame 3: 7, spare. Total 45."
QString frameText(const Game& game, std::size_t player, int frame); // from 1

// When it was played and by whom: "Minsu, Jiyeon · frame 4", "Minsu 143, Jiyeon 120"
QString gameTitle(const Game& game);
QString storeFaultText(const StoreFault& fault);

// Why a frame as it was typed is none.
QString rollsFaultText(const RollError& error);

} // namespace thetalane
