// The game being played in the window: whose turn it is, what was thrown, and the file it is kept in. It sets
// the session's scene up for each turn; what anybody does with the scene apart from aiming only makes it
// wait.
#pragma once

#include "ui/game/game_store.h"
#include "ui/game/release_error.h"
#include "ui/playhead.h"
#include "ui/session.h"

#include <QObject>

namespace thetalane {

// One delivery of a game; both from 0.
struct DeliveryPlace {
    std::size_t player = 0;
    std::size_t delivery = 0;

    friend bool operator==(const DeliveryPlace&, const DeliveryPlace&) = default;
};

// The latest one in the order of play.
std::optional<DeliveryPlace> lastDelivery(const Game& game);

class Alley : public QObject {
    Q_OBJECT
public:
    enum class Phase {
        NoGame,
        Aim,       // the turn is set up, shown up to its first contact
        Rolling,   // thrown and recorded; the score waits for the end of the run
        Result,    // the score is told; the pins can still be looked at
        Replay,    // a delivery from before
        Elsewhere, // the window shows something else
        Over,
    };

    Alley(Session& session, Playhead& playhead, QObject* parent = nullptr);
    Alley(Session& session, Playhead& playhead, const QString& directory, QObject* parent = nullptr);

    Phase phase() const { return m_phase; }
    bool isOn() const { return m_phase != Phase::NoGame; }
    const Game& game() const { return m_game; } // as recorded, and as it stands in the file
    const Game& shown() const;                  // without the delivery that is still rolling
    std::optional<GameTurn> turn() const;       // of what is shown
    std::optional<DeliveryPlace> replayed() const { return m_replayed; }
    bool foulMarked() const; // the last delivery
    // The run in the window is not of the engine that the game is scored with.
    bool isOtherEngine() const;

    // Told by revealed() as well: of the delivery that was shown last, until the next throw.
    std::optional<DeliveryPlace> told() const { return m_told; }

    void setRelease(Release release, std::uint32_t seed);
    Release release() const { return m_release; }
    std::uint32_t seed() const { return m_seed; }

    QString path() const { return m_path; }
    QString saveFault() const { return m_saveFault; } // why the file could not be written, or empty
    GameStore& store() { return m_store; }

    void start(std::vector<Player> players, ScoringRules rules, const LaneConditions& lane);
    std::optional<StoreFault> openSaved(const QString& path); // a damaged file changes nothing
    bool continueLatest(); // the latest unfinished game; false: there is none
    void close();          // the file stays, unless nothing was thrown

    std::optional<GameError> correct(std::size_t player, int frame, const std::vector<Delivery>& deliveries);
    bool replay(const DeliveryPlace& place); // false: that one was not thrown

public slots:
    void throwBall();
    void tellScore();  // of the delivery that still rolls
    void next();       // tells the score, and sets the next turn up
    void backToGame(); // from a replay, or from another scene
    void goOn();       // whatever comes next: what the Enter key does
    void undo();
    void setFoul(bool foul); // the last delivery

signals:
    void changed();  // anything above
    void revealed(); // the score of told()

private:
    void adoptRun();
    void look(double time);
    void reveal();
    void leave();
    void setUp();
    void show(const Throw& ballThrow, const PinSet& standing, Foresight foresight);
    void play();
    void take(Game game); // recorded anew, and what is set up follows
    void adopt(Game game, const QString& path);
    void save();
    bool isAim(const Subject& subject) const;

    Session& m_session;
    Playhead& m_playhead;
    GameStore m_store;
    Phase m_phase = Phase::NoGame;
    Game m_game;
    std::optional<Game> m_before; // while a delivery rolls
    std::vector<Throw> m_aims;    // of each player, the last one
    std::optional<DeliveryPlace> m_told;
    std::optional<DeliveryPlace> m_replayed;
    Subject m_subject;  // what the session shows for us
    bool m_own = false; // it is us who change the session
    Release m_release = Release::None;
    std::uint32_t m_seed = 1;
    QString m_path;
    QString m_saveFault;
};

} // namespace thetalane
