// A game of one to eight players in turn. A value and functions that return the next one, so that undoing,
// saving and showing again are the same value kept.
#pragma once

#include "core/bowling/ball_path.h"
#include "core/bowling/scorecard.h"

#include <string>
#include <variant>

namespace thetalane {

inline constexpr std::size_t mostPlayers = 8;

struct Player {
    std::string name; // UTF-8, not empty
    int colour = 0;   // 0 to mostPlayers - 1: which of the window's colours

    friend bool operator==(const Player&, const Player&) = default;
};

// A delivery that was thrown carries the ball's inputs and what it met, which is all that a replay needs; one
// that was entered by hand has neither.
struct PlayedDelivery {
    Delivery delivery;
    std::optional<Throw> thrown{};
    PinSet met{}; // the pins that stood before it

    friend bool operator==(const PlayedDelivery&, const PlayedDelivery&) = default;
};

// What is thrown on: the same for all deliveries of a game.
struct LaneConditions {
    double restitution = defaultPinRestitution;
    std::optional<Friction> friction = houseFriction();

    friend bool operator==(const LaneConditions&, const LaneConditions&) = default;
};

struct Game {
    ScoringRules rules = ScoringRules::Traditional;
    LaneConditions lane;
    std::vector<Player> players;
    std::vector<std::vector<PlayedDelivery>> deliveries; // of each player

    friend bool operator==(const Game&, const Game&) = default;
};

Game newGame(std::vector<Player> players, ScoringRules rules = ScoringRules::Traditional,
             LaneConditions lane = {});

Scorecard cardOf(const Game& game, std::size_t player);

struct GameTurn {
    std::size_t player = 0;
    Turn turn;
};
// Frame by frame in the order of the players; nothing once all have played.
std::optional<GameTurn> turnOf(const Game& game);

// Which pins to set up for a turn. Where only a count is known, so many of the hindmost.
PinSet pinsFor(const Turn& turn);

enum class GameFault { GameOver, WrongDelivery, NoSuchFrame, FrameLeftOpen };
struct GameError {
    GameFault fault{};
    DeliveryError delivery{}; // WrongDelivery
    int which = 0;            // WrongDelivery of a correction: from 0
};

// The throw of the player whose turn it is, run by the engine at what stands. Nothing once the game is over.
std::optional<PlayedDelivery> playThrow(const Game& game, const Throw& ballThrow);
// The scene of a thrown delivery, to be seen again.
std::optional<Scene> replayScene(const Game& game, const PlayedDelivery& played);

std::variant<Game, GameError> withDelivery(Game game, const PlayedDelivery& played);
std::optional<Game> withoutLast(Game game); // nothing where there is none

// A frame put right by hand, marked so; frame from 1. A finished frame must stay one, an unfinished one may
// be finished; what follows must still fit. A throw stays with the delivery in its place.
std::variant<Game, GameError> withFrame(Game game, std::size_t player, int frame,
                                        const std::vector<Delivery>& deliveries);

// The ball meets the head pin within a board of the 17½th, coming from that side or straight.
bool isPocketHit(const Entry& entry);

// Of one game or, added, of many.
struct Statistics {
    int games = 0; // complete ones
    int gamePoints = 0;
    int best = 0;
    int strikes = 0;
    int firstBalls = 0; // at a full rack
    int firstBallPins = 0;
    int spares = 0;
    int spareChances = 0; // balls at what a first ball left
    int opens = 0;
    int splits = 0;
    int pocketHits = 0;
    int pocketChances = 0; // first balls whose throw is known

    std::optional<double> average() const; // points a game
    std::optional<double> firstBallAverage() const;
    Statistics& operator+=(const Statistics& other);
    friend bool operator==(const Statistics&, const Statistics&) = default;
};
Statistics statisticsOf(const Game& game, std::size_t player);

} // namespace thetalane
