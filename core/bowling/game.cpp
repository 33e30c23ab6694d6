#include "core/bowling/game.h"

#include "core/bowling/pinfall.h"
#include "core/engine/engine.h"

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double boardWidth = regulation::laneWidth / 39;
constexpr double pocket = 2.5 * boardWidth; // the 17½th board is so far from the 20th, the middle

std::optional<GameError> addAll(Scorecard& card, const std::vector<PlayedDelivery>& deliveries) {
    for (const PlayedDelivery& d : deliveries)
        if (const auto error = card.add(d.delivery))
            return GameError{GameFault::WrongDelivery, *error};
    return std::nullopt;
}

double ratio(int part, int whole) {
    return double(part) / whole;
}

// Of the deliveries, those of the frame replaced by `by`.
std::vector<PlayedDelivery> replaced(const std::vector<PlayedDelivery>& all, const FrameScore& frame,
                                     const std::vector<Delivery>& by) {
    std::vector<PlayedDelivery> out(all.begin(), all.begin() + frame.first);
    for (std::size_t k = 0; k < by.size(); ++k) {
        PlayedDelivery d{by[k]};
        d.delivery.corrected = true;
        if (int(k) < frame.count) {
            d.thrown = all[std::size_t(frame.first) + k].thrown;
            d.met = all[std::size_t(frame.first) + k].met;
        }
        out.push_back(d);
    }
    out.insert(out.end(), all.begin() + frame.first + frame.count, all.end());
    return out;
}

} // namespace

Game newGame(std::vector<Player> players, ScoringRules rules, LaneConditions lane) {
    Game game{rules, std::move(lane), std::move(players), {}};
    game.deliveries.resize(game.players.size());
    return game;
}

Scorecard cardOf(const Game& game, std::size_t player) {
    Scorecard card(game.rules);
    addAll(card, game.deliveries[player]);
    return card;
}

std::optional<GameTurn> turnOf(const Game& game) {
    std::optional<GameTurn> first;
    for (std::size_t k = 0; k < game.players.size(); ++k)
        if (const auto turn = cardOf(game, k).next(); turn && (!first || turn->frame < first->turn.frame))
            first = GameTurn{k, *turn};
    return first;
}

PinSet pinsFor(const Turn& turn) {
    if (turn.pins)
        return *turn.pins;
    PinSet pins;
    for (int k = 0; k < turn.standing; ++k)
        pins.set(std::size_t(pinsOfARack - 1 - k));
    return pins;
}

std::optional<PlayedDelivery> playThrow(const Game& game, const Throw& t) {
    const auto turn = turnOf(game);
    if (!turn)
        return std::nullopt;
    PlayedDelivery played{{}, t, pinsFor(turn->turn)};
    EngineSettings settings;
    settings.keepDetail = false;
    auto outcome = simulate(*replayScene(game, played), settings);
    const Run& run = std::get<Run>(outcome); // the settings are none to be refused
    const PinSet down = fallenPins(run.scene, run.timeline);
    played.delivery.pins = int(down.count());
    if (turn->turn.pins) // otherwise which of them stood was a guess
        played.delivery.down = down;
    return played;
}

std::optional<Scene> replayScene(const Game& game, const PlayedDelivery& played) {
    if (!played.thrown)
        return std::nullopt;
    return bowlingScene(*played.thrown, game.lane.restitution, game.lane.friction, played.met);
}

std::variant<Game, GameError> withDelivery(Game game, const PlayedDelivery& played) {
    const auto turn = turnOf(game);
    if (!turn)
        return GameError{GameFault::GameOver};
    if (const auto error = cardOf(game, turn->player).errorOf(played.delivery))
        return GameError{GameFault::WrongDelivery, *error};
    game.deliveries[turn->player].push_back(played);
    return game;
}

// The latest is the last player's among those who are furthest.
std::optional<Game> withoutLast(Game game) {
    std::size_t last = 0;
    int frame = 0;
    for (std::size_t k = 0; k < game.players.size(); ++k)
        if (const int begun = int(cardOf(game, k).frames().size()); begun > 0 && begun >= frame) {
            frame = begun;
            last = k;
        }
    if (frame == 0)
        return std::nullopt;
    game.deliveries[last].pop_back();
    return game;
}

std::variant<Game, GameError> withFrame(Game game, std::size_t player, int frame,
                                        const std::vector<Delivery>& deliveries) {
    const Scorecard before = cardOf(game, player);
    if (frame < 1 || frame > int(before.frames().size()))
        return GameError{GameFault::NoSuchFrame};
    const FrameScore& old = before.frames()[std::size_t(frame - 1)];
    if (deliveries.empty())
        return GameError{GameFault::FrameLeftOpen};
    std::vector<PlayedDelivery>& own = game.deliveries[player];
    own = replaced(own, old, deliveries);
    Scorecard after(game.rules);
    for (int k = 0; k < int(own.size()); ++k) {
        const Delivery& d = own[std::size_t(k)].delivery;
        const bool ofTheFrame = k >= old.first && k < old.first + int(deliveries.size());
        // A frame too long would lend deliveries to the next, one too short take them from it.
        if (const auto turn = after.next(); turn && k >= old.first && (turn->frame == frame) != ofTheFrame)
            return ofTheFrame ? GameError{GameFault::WrongDelivery,
                                          {DeliveryFault::GameOver, *turn, d.pins},
                                          k - old.first}
                              : GameError{GameFault::FrameLeftOpen};
        if (const auto error = after.add(d))
            return GameError{GameFault::WrongDelivery, *error, k - old.first};
    }
    if (old.complete && !after.frames()[std::size_t(frame - 1)].complete)
        return GameError{GameFault::FrameLeftOpen};
    return game;
}

bool isPocketHit(const Entry& entry) {
    const double side = entry.offset < 0 ? -1 : 1;
    return std::abs(std::abs(entry.offset) - pocket) <= boardWidth && entry.angle * side >= 0;
}

std::optional<double> Statistics::average() const {
    return games > 0 ? std::optional(ratio(gamePoints, games)) : std::nullopt;
}

std::optional<double> Statistics::firstBallAverage() const {
    return firstBalls > 0 ? std::optional(ratio(firstBallPins, firstBalls)) : std::nullopt;
}

Statistics& Statistics::operator+=(const Statistics& o) {
    games += o.games;
    gamePoints += o.gamePoints;
    best = std::max(best, o.best);
    strikes += o.strikes;
    firstBalls += o.firstBalls;
    firstBallPins += o.firstBallPins;
    spares += o.spares;
    spareChances += o.spareChances;
    opens += o.opens;
    splits += o.splits;
    pocketHits += o.pocketHits;
    pocketChances += o.pocketChances;
    return *this;
}

Statistics statisticsOf(const Game& game, std::size_t player) {
    const Scorecard card = cardOf(game, player);
    Statistics s;
    if (const auto total = card.total()) {
        s.games = 1;
        s.gamePoints = s.best = *total;
    }
    s.strikes = card.strikes();
    s.spares = card.spares();
    s.opens = card.opens();
    s.splits = card.splits();
    const auto& played = game.deliveries[player];
    for (std::size_t k = 0; k < played.size(); ++k) {
        const ScoredDelivery& d = card.deliveries()[k];
        if (!d.turn.firstOnRack) {
            ++s.spareChances;
            continue;
        }
        ++s.firstBalls;
        s.firstBallPins += countedPins(d.delivery);
        if (!played[k].thrown)
            continue;
        ++s.pocketChances;
        const auto entry = entryOf(*played[k].thrown, game.lane.friction);
        s.pocketHits += entry && isPocketHit(*entry);
    }
    return s;
}

} // namespace thetalane
