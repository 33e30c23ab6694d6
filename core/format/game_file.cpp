#include "core/format/game_file.h"

#include "core/format/json_keys.h"
#include "core/format/json_text.h"
#include "core/format/members.h"
#include "core/format/scene_file.h"

#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>

namespace thetalane {
namespace {

constexpr const char* formatName = "thetalane-game";
constexpr std::array rulesNames{"traditional", "current-frame"};
constexpr std::string_view gameKeys[] = {"format", "version", "rules", "lane", "players"};
constexpr std::string_view laneKeys[] = {"restitution", "friction"};
constexpr std::string_view playerKeys[] = {"name", "colour", "deliveries"};
constexpr std::string_view deliveryKeys[] = {"pins", "down", "foul", "corrected", "throw", "standing"};
constexpr std::string_view throwKeys[] = {"mass_kg",    "speed_m_s",  "direction_rad",
                                          "position_m", "spin_rad_s", "axis_rad"};

std::string item(const std::string& path, qsizetype index) {
    return path + '[' + std::to_string(index) + ']';
}

// The first fault ends the reading: what comes after would be read in its light.
class GameReader {
public:
    std::variant<Game, GameFileError> read(const QByteArray& json) {
        const auto document = QJsonDocument::fromJson(json);
        // What is no JSON, or not strictly, the reader of scenes knows how to tell.
        if (auto scene = readScene(json); auto* errors = std::get_if<std::vector<SceneError>>(&scene))
            if (const auto code = errors->front().code; document.isNull() || !document.isObject() ||
                                                        code == SceneErrorCode::NotJson ||
                                                        code == SceneErrorCode::NotAnObject)
                return GameFileError{.fault = GameFileFault::Shape, .scene = errors->front()};
        if (const auto twice = duplicateKeys(json); !twice.empty())
            return GameFileError{.fault = GameFileFault::Shape,
                                 .scene = {.code = SceneErrorCode::NotJson,
                                           .path = twice.front(),
                                           .other = duplicateKeyReason}};
        if (game(document.object()))
            return std::move(m_game);
        return std::move(m_error);
    }

private:
    bool fail(GameFileError error) {
        m_error = std::move(error);
        return false;
    }
    bool fail(GameFileFault fault, std::string path, double value = 0, double high = 0) {
        return fail({.fault = fault, .path = std::move(path), .value = value, .high = high});
    }
    // What Members found in an object, told first.
    bool sound() {
        return m_shape.empty() || fail({.fault = GameFileFault::Shape, .scene = m_shape.front()});
    }

    bool game(const QJsonObject& file) {
        const QJsonValue format = file.value("format"), version = file.value("version");
        if (format.isString() && format.toString() != formatName)
            return fail({.fault = GameFileFault::WrongFormat,
                         .path = "format",
                         .text = format.toString().toStdString()});
        if (version.isDouble() && version.toDouble() != 1)
            return fail(GameFileFault::WrongVersion, "version", version.toDouble());
        std::string text, rules;
        double number = 0;
        Members m(file, {}, gameKeys, m_shape);
        m.string("format", text);
        m.number("version", number);
        m.string("rules", rules);
        const auto lane = m.object("lane");
        const auto players = m.array("players", Need::Required);
        if (!sound())
            return false;
        const auto known = std::find(rulesNames.begin(), rulesNames.end(), rules);
        if (known == rulesNames.end())
            return fail({.fault = GameFileFault::WrongRules, .path = "rules", .text = rules});
        m_game.rules = ScoringRules(known - rulesNames.begin());
        return (!lane || conditions(*lane)) && allPlayers(*players) && inTurn();
    }

    // Restitution and friction as of a scene file: the reader of those has their rules and words.
    bool conditions(const QJsonObject& lane) {
        Members m(lane, "lane", laneKeys, m_shape);
        m.number("restitution");
        m.object("friction");
        if (!sound())
            return false;
        QJsonObject scene{{"format", "thetalane-scene"}, {"version", 1}};
        scene["restitution"] = lane.value("restitution");
        scene["bodies"] = QJsonArray{QJsonObject{{"id", "x"},
                                                 {"kind", "ball"},
                                                 {"mass", 1},
                                                 {"radius", 1},
                                                 {"position", QJsonArray{0, 0}},
                                                 {"velocity", QJsonArray{0, 0}}}};
        if (lane.contains("friction"))
            scene["friction"] = lane.value("friction");
        auto read = readScene(QJsonDocument(scene).toJson());
        if (auto* errors = std::get_if<std::vector<SceneError>>(&read)) {
            errors->front().path = "lane." + errors->front().path;
            return fail({.fault = GameFileFault::Shape, .scene = errors->front()});
        }
        m_game.lane = {std::get<Scene>(read).restitution, std::get<Scene>(read).friction};
        return true;
    }

    bool allPlayers(const QJsonArray& players) {
        if (players.isEmpty() || players.size() > qsizetype(mostPlayers))
            return fail(GameFileFault::PlayerCount, "players", double(players.size()), mostPlayers);
        for (qsizetype k = 0; k < players.size(); ++k)
            if (!player(players[k], item("players", k)))
                return false;
        return true;
    }

    bool player(const QJsonValue& value, const std::string& path) {
        if (!value.isObject())
            return fail({.fault = GameFileFault::Shape,
                         .scene = {.code = SceneErrorCode::NotAnObject, .path = path}});
        const QJsonObject object = value.toObject();
        Player player;
        double colour = 0;
        Members m(object, path, playerKeys, m_shape);
        m.string("name", player.name);
        m.number("colour", colour);
        const auto deliveries = m.array("deliveries", Need::Required);
        if (!sound())
            return false;
        if (QString::fromStdString(player.name).trimmed().isEmpty())
            return fail(GameFileFault::NoName, path + ".name");
        if (!(colour >= 0 && colour < double(mostPlayers)) || colour != std::floor(colour))
            return fail(GameFileFault::Colour, path + ".colour", colour, double(mostPlayers) - 1);
        player.colour = int(colour);
        m_game.players.push_back(std::move(player));
        m_game.deliveries.emplace_back();
        Scorecard card(m_game.rules);
        for (qsizetype k = 0; k < deliveries->size(); ++k)
            if (!delivery((*deliveries)[k], item(path + ".deliveries", k), card))
                return false;
        return true;
    }

    bool delivery(const QJsonValue& value, const std::string& path, Scorecard& card) {
        if (!value.isObject())
            return fail({.fault = GameFileFault::Shape,
                         .scene = {.code = SceneErrorCode::NotAnObject, .path = path}});
        const QJsonObject object = value.toObject();
        PlayedDelivery played;
        double pins = 0;
        Members m(object, path, deliveryKeys, m_shape);
        m.number("pins", pins);
        const auto down = m.array("down", Need::Optional);
        const auto thrown = m.object("throw");
        const auto standing = m.array("standing", thrown ? Need::Required : Need::Optional);
        if (!sound() || !flag(m, "foul", played.delivery.foul) ||
            !flag(m, "corrected", played.delivery.corrected))
            return false;
        if (pins != std::floor(pins) || std::abs(pins) > 1000)
            return fail(GameFileFault::NotWhole, path + ".pins", pins);
        played.delivery.pins = int(pins);
        if (down) {
            played.delivery.down.emplace();
            if (!pinSet(*down, path + ".down", *played.delivery.down))
                return false;
        }
        if (thrown &&
            (!ball(*thrown, path + ".throw", played) || !pinSet(*standing, path + ".standing", played.met)))
            return false;
        return fits(played, path, card);
    }

    bool flag(Members& m, const char* key, bool& out) {
        const auto value = m.value(key, Need::Optional);
        out = value && value->toBool();
        return !value || value->isBool() || fail(GameFileFault::NotABool, m.pathOf(key));
    }

    bool pinSet(const QJsonArray& array, const std::string& path, PinSet& out) {
        for (qsizetype k = 0; k < array.size(); ++k) {
            const QJsonValue pin = array[k];
            const double number = pin.toDouble(-1);
            if (!(number >= 1 && number <= pinsOfARack) || number != std::floor(number))
                return fail(GameFileFault::PinNumber, item(path, k), number, pinsOfARack);
            if (out[std::size_t(number) - 1])
                return fail(GameFileFault::PinTwice, item(path, k), number);
            out.set(std::size_t(number) - 1);
        }
        return true;
    }

    bool ball(const QJsonObject& object, const std::string& path, PlayedDelivery& played) {
        Throw t;
        Members m(object, path, throwKeys, m_shape);
        m.number("mass_kg", t.mass);
        m.number("speed_m_s", t.speed);
        m.number("direction_rad", t.direction);
        m.number("position_m", t.position);
        m.number("spin_rad_s", t.spin);
        m.number("axis_rad", t.axis);
        if (!sound())
            return false;
        // What cannot be thrown cannot have been: the rules for scenes know.
        const auto errors = validate(bowlingScene(t, m_game.lane.restitution, m_game.lane.friction));
        if (!errors.empty()) {
            SceneError error = errors.front();
            error.path = error.path.starts_with("bodies[0].mass") ? path + ".mass_kg" : path;
            return fail({.fault = GameFileFault::Shape, .scene = std::move(error)});
        }
        played.thrown = t;
        return true;
    }

    bool fits(const PlayedDelivery& played, const std::string& path, Scorecard& card) {
        const Delivery& d = played.delivery;
        const auto turn = card.next();
        if (turn && played.thrown && !d.corrected && turn->pins && played.met != *turn->pins &&
            !(turn->ball > 1 && card.frames().back().corrected))
            return fail(GameFileFault::NotMet, path + ".standing");
        if (const auto error = card.add(d))
            return misfit(*error, d, path);
        m_game.deliveries.back().push_back(played);
        return true;
    }

    bool misfit(const DeliveryError& error, const Delivery& d, const std::string& path) {
        switch (error.fault) {
        case DeliveryFault::NegativePins:
            return fail(GameFileFault::NegativePins, path + ".pins", d.pins);
        case DeliveryFault::MoreThanStand:
            return fail(GameFileFault::TooManyPins, path + ".pins", d.pins, error.turn.standing);
        case DeliveryFault::CountDiffers:
            return fail(GameFileFault::CountDiffers, path + ".pins", d.pins, double(d.down->count()));
        case DeliveryFault::PinNotStanding:
            return fail(GameFileFault::PinNotStanding, path + ".down", error.pins);
        case DeliveryFault::GameOver:
            break;
        }
        return fail(GameFileFault::GameOver, path);
    }

    // Nobody is a frame ahead of an earlier player, nor two of a later one.
    bool inTurn() {
        const auto turn = turnOf(m_game);
        const int frame = turn ? turn->turn.frame : framesOfAGame;
        for (std::size_t k = 0; turn && k < m_game.players.size(); ++k) {
            const int begun = int(cardOf(m_game, k).frames().size());
            const int most = k <= turn->player ? frame : frame - 1;
            if (begun > most)
                return fail(GameFileFault::OutOfTurn, item("players", qsizetype(k)) + ".deliveries", begun,
                            most);
        }
        return true;
    }

    Game m_game;
    std::vector<SceneError> m_shape;
    GameFileError m_error;
};

using Parts = QList<QByteArray>;

QByteArray member(const char* key, const QByteArray& value) {
    return '"' + QByteArray(key) + "\": " + value;
}

QByteArray braced(const Parts& members) {
    return '{' + members.join(", ") + '}';
}

QByteArray pinsText(const PinSet& pins) {
    Parts numbers;
    for (std::size_t k = 0; k < pins.size(); ++k)
        if (pins[k])
            numbers << QByteArray::number(int(k) + 1);
    return '[' + numbers.join(", ") + ']';
}

QByteArray throwText(const Throw& t) {
    const std::array values{t.mass, t.speed, t.direction, t.position, t.spin, t.axis};
    Parts members;
    for (std::size_t k = 0; k < values.size(); ++k)
        members << member(throwKeys[k].data(), jsonNumber(values[k]));
    return braced(members);
}

QByteArray deliveryText(const PlayedDelivery& played) {
    const Delivery& d = played.delivery;
    Parts members{member("pins", QByteArray::number(d.pins))};
    if (d.down)
        members << member("down", pinsText(*d.down));
    if (d.foul)
        members << member("foul", "true");
    if (d.corrected)
        members << member("corrected", "true");
    if (played.thrown)
        members << member("standing", pinsText(played.met)) << member("throw", throwText(*played.thrown));
    return braced(members);
}

QByteArray playerText(const Game& game, std::size_t k) {
    Parts lines;
    for (const PlayedDelivery& d : game.deliveries[k])
        lines << "      " + deliveryText(d);
    const QByteArray deliveries = lines.isEmpty() ? "[]" : "[\n" + lines.join(",\n") + "\n    ]";
    return "    {" + member("name", jsonString(game.players[k].name)) + ", " +
           member("colour", QByteArray::number(game.players[k].colour)) + ",\n     " +
           member("deliveries", deliveries) + '}';
}

// As a scene file writes it.
QByteArray laneText(const LaneConditions& lane) {
    Scene scene;
    scene.friction = lane.friction;
    const QJsonObject file = QJsonDocument::fromJson(writeScene(scene)).object();
    Parts members{member("restitution", jsonNumber(lane.restitution))};
    if (lane.friction)
        members << member("friction",
                          QJsonDocument(file.value("friction").toObject()).toJson(QJsonDocument::Compact));
    return braced(members);
}

} // namespace

std::variant<Game, GameFileError> readGame(const QByteArray& json) {
    return GameReader().read(json);
}

QByteArray writeGame(const Game& game) {
    Parts players;
    for (std::size_t k = 0; k < game.players.size(); ++k)
        players << playerText(game, k);
    return "{\n  " + member("format", "\"thetalane-game\"") + ", " + member("version", "1") + ",\n  " +
           member("rules", '"' + QByteArray(rulesNames[std::size_t(game.rules)]) + '"') + ",\n  " +
           member("lane", laneText(game.lane)) + ",\n  " +
           member("players", "[\n" + players.join(",\n") + "\n  ]") + "\n}\n";
}

} // namespace thetalane
