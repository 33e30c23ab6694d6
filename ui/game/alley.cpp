#include "ui/game/alley.h"

#include <QFile>
#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace thetalane {

std::optional<DeliveryPlace> lastDelivery(const Game& game) {
    const auto without = withoutLast(game);
    for (std::size_t k = 0; without && k < game.players.size(); ++k)
        if (without->deliveries[k].size() < game.deliveries[k].size())
            return DeliveryPlace{k, game.deliveries[k].size() - 1};
    return std::nullopt;
}

Alley::Alley(Session& session, Playhead& playhead, QObject* parent)
    : Alley(session, playhead, GameStore::usualDirectory(), parent) {}

Alley::Alley(Session& session, Playhead& playhead, const QString& directory, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_playhead(playhead)
    , m_store(directory) {
    connect(&session, &Session::runChanged, this, &Alley::adoptRun);
    connect(&playhead, &Playhead::timeChanged, this, &Alley::look);
    // Whatever sets a ball going that is aimed has thrown it: a button, the space bar.
    connect(&playhead, &Playhead::playingChanged, this, [this](bool playing) {
        if (playing && m_phase == Phase::Aim)
            throwBall();
    });
}

const Game& Alley::shown() const {
    return m_before ? *m_before : m_game;
}

std::optional<GameTurn> Alley::turn() const {
    return isOn() ? turnOf(shown()) : std::nullopt;
}

bool Alley::foulMarked() const {
    const auto last = lastDelivery(m_game);
    return last && m_game.deliveries[last->player][last->delivery].delivery.foul;
}

bool Alley::isOtherEngine() const {
    EngineSettings scored, shown = m_session.run()->settings;
    shown.until = scored.until;
    shown.maxCollisions = scored.maxCollisions;
    shown.keepDetail = scored.keepDetail;
    return !(shown == scored);
}

void Alley::setRelease(Release release, std::uint32_t seed) {
    m_release = release;
    m_seed = seed;
    emit changed();
}

void Alley::start(std::vector<Player> players, ScoringRules rules, const LaneConditions& lane) {
    adopt(newGame(std::move(players), rules, lane), m_store.newPath());
    save();
    setUp();
}

std::optional<StoreFault> Alley::openSaved(const QString& path) {
    auto read = m_store.load(path);
    if (auto* fault = std::get_if<StoreFault>(&read))
        return std::move(*fault);
    adopt(std::get<Game>(std::move(read)), path);
    setUp();
    return std::nullopt;
}

bool Alley::continueLatest() {
    for (const SavedGame& saved : m_store.list())
        if (saved.game() && turnOf(*saved.game()))
            return !openSaved(QString(saved.path));
    return false;
}

// Each player aims as in the last throw of theirs.
void Alley::adopt(Game game, const QString& path) {
    if (path == m_path)
        m_path.clear(); // opened again: its file stays
    close();
    m_game = std::move(game);
    m_path = path;
    m_aims.assign(m_game.players.size(), Throw{});
    for (std::size_t k = 0; k < m_aims.size(); ++k)
        for (const PlayedDelivery& d : m_game.deliveries[k])
            m_aims[k] = d.thrown.value_or(m_aims[k]);
}

void Alley::close() {
    if (!isOn())
        return;
    const bool nothingThrown = !lastDelivery(m_game);
    if (nothingThrown && !m_path.isEmpty())
        QFile::remove(m_path);
    m_phase = Phase::NoGame;
    m_game = {};
    m_before.reset();
    m_told.reset();
    m_replayed.reset();
    m_path.clear();
    m_saveFault.clear();
    {
        const QScopedValueRollback own(m_own, true);
        m_session.holdForesight(std::nullopt);
    }
    emit changed();
}

void Alley::save() {
    m_saveFault = m_store.save(m_path, m_game);
}

// The aim is judged by the whole scene: whoever moved a pin, or changed the lane, no longer plays this game.
bool Alley::isAim(const Subject& subject) const {
    return subject.ballThrow && subject.standing == m_subject.standing &&
           subject.scene == bowlingScene(*subject.ballThrow, m_game.lane.restitution, m_game.lane.friction,
                                         subject.standing);
}

void Alley::adoptRun() {
    if (m_own)
        return;
    const Subject& subject = m_session.subject();
    switch (m_phase) {
    case Phase::Aim:
        if (!isAim(subject))
            return leave();
        m_aims[turnOf(m_game)->player] = *subject.ballThrow;
        if (isOtherEngine())
            emit changed();
        return;
    case Phase::Rolling:
    case Phase::Result:
    case Phase::Replay:
        if (!(subject == m_subject))
            return leave();
        emit changed(); // it may be another engine's now
        return;
    case Phase::NoGame:
    case Phase::Elsewhere:
    case Phase::Over:
        return;
    }
}

void Alley::leave() {
    tellScore();
    m_phase = Phase::Elsewhere;
    m_replayed.reset();
    {
        const QScopedValueRollback own(m_own, true);
        m_session.holdForesight(std::nullopt);
    }
    emit changed();
}

void Alley::look(double time) {
    if (m_phase == Phase::Rolling && !m_own && time >= m_playhead.end())
        reveal();
}

void Alley::reveal() {
    m_before.reset();
    m_phase = turnOf(m_game) ? Phase::Result : Phase::Over;
    m_told = lastDelivery(m_game);
    emit revealed();
    emit changed();
}

void Alley::show(const Throw& ballThrow, const PinSet& standing, Foresight foresight) {
    const QScopedValueRollback own(m_own, true);
    if (isOtherEngine())
        m_session.setEngine({}); // the record is the exact engine's, and so is what is shown of it
    m_session.holdForesight(foresight);
    m_session.openDelivery(ballThrow, standing, m_game.lane);
    m_subject = m_session.subject();
}

void Alley::setUp() {
    m_before.reset();
    m_replayed.reset();
    const auto turn = turnOf(m_game);
    m_phase = turn ? Phase::Aim : Phase::Over;
    if (turn)
        show(m_aims[turn->player], pinsFor(turn->turn), Foresight::FirstContact);
    else if (!m_session.currentThrow()) // a finished game was opened: its lane at least
        show(m_aims.front(), allPins, Foresight::Whole);
    emit changed();
}

void Alley::play() {
    m_playhead.setPlaying(false);
    m_playhead.setTime(0);
    m_playhead.setPlaying(true);
}

// Recorded and saved before anything is seen of it.
void Alley::throwBall() {
    const auto turn = turnOf(m_game);
    if (m_phase != Phase::Aim || !turn)
        return;
    const Throw aim = *m_session.currentThrow();
    const Throw thrown =
        released(aim, m_release, m_seed, turn->player, m_game.deliveries[turn->player].size());
    const auto played = playThrow(m_game, thrown);
    auto after = withDelivery(m_game, *played);
    m_aims[turn->player] = aim;
    m_before = std::exchange(m_game, std::get<Game>(std::move(after))); // what stands can always fall
    save();
    m_told.reset();
    show(thrown, played->met, Foresight::Whole);
    m_phase = Phase::Rolling;
    emit changed();
    play();
}

void Alley::tellScore() {
    if (m_phase == Phase::Rolling)
        reveal();
}

void Alley::next() {
    tellScore();
    if (m_phase == Phase::Result)
        setUp();
}

void Alley::backToGame() {
    if (m_phase == Phase::Replay || m_phase == Phase::Elsewhere)
        setUp();
}

void Alley::goOn() {
    switch (m_phase) {
    case Phase::Aim:
        return throwBall();
    case Phase::Rolling:
    case Phase::Result:
        return next();
    case Phase::Replay:
    case Phase::Elsewhere:
        return backToGame();
    case Phase::NoGame:
    case Phase::Over:
        return;
    }
}

void Alley::undo() {
    auto game = withoutLast(m_game);
    if (!isOn() || !game)
        return;
    m_told.reset();
    m_game = *std::move(game);
    save();
    setUp();
}

void Alley::setFoul(bool foul) {
    const auto last = lastDelivery(m_game);
    if (!isOn() || !last)
        return;
    PlayedDelivery delivery = m_game.deliveries[last->player][last->delivery];
    if (delivery.delivery.foul == foul)
        return;
    delivery.delivery.foul = foul;
    auto game = withDelivery(*withoutLast(m_game), delivery);
    if (auto* changedGame = std::get_if<Game>(&game))
        take(std::move(*changedGame));
}

std::optional<GameError> Alley::correct(std::size_t player, int frame,
                                        const std::vector<Delivery>& deliveries) {
    if (!isOn() || player >= m_game.players.size())
        return GameError{GameFault::NoSuchFrame};
    auto game = withFrame(m_game, player, frame, deliveries);
    if (const auto* error = std::get_if<GameError>(&game))
        return *error;
    take(std::get<Game>(std::move(game)));
    return std::nullopt;
}

void Alley::take(Game game) {
    tellScore();
    m_game = std::move(game);
    save();
    if (m_told)
        m_told = lastDelivery(m_game);
    if (m_phase == Phase::Aim)
        return setUp();
    if (m_phase == Phase::Result || m_phase == Phase::Over)
        m_phase = turnOf(m_game) ? Phase::Result : Phase::Over;
    emit changed();
}

bool Alley::replay(const DeliveryPlace& place) {
    if (!isOn() || place.player >= m_game.players.size() ||
        place.delivery >= m_game.deliveries[place.player].size())
        return false;
    const PlayedDelivery delivery = m_game.deliveries[place.player][place.delivery];
    if (!delivery.thrown)
        return false;
    tellScore();
    m_replayed = place;
    show(*delivery.thrown, delivery.met, Foresight::Whole);
    m_phase = Phase::Replay;
    emit changed();
    play();
    return true;
}

} // namespace thetalane
