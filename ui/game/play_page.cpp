#include "ui/game/play_page.h"

#include "ui/game/game_words.h"
#include "ui/game/player_colours.h"
#include "ui/game/saved_games_list.h"
#include "ui/panels/pin_deck.h"
#include "ui/words/glossary.h"

#include <QAccessible>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

using Phase = Alley::Phase;

// All deliveries in the order of play, the latest first.
std::vector<DeliveryPlace> inOrder(const Game& game) {
    struct Played {
        int frame;
        DeliveryPlace place;
    };
    std::vector<Played> all;
    for (std::size_t k = 0; k < game.players.size(); ++k) {
        const Scorecard card = cardOf(game, k);
        for (std::size_t d = 0; d < card.deliveries().size(); ++d)
            all.push_back({card.deliveries()[d].turn.frame, {k, d}});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Played& a, const Played& b) { return a.frame < b.frame; });
    std::vector<DeliveryPlace> places;
    for (auto it = all.rbegin(); it != all.rend(); ++it)
        places.push_back(it->place);
    return places;
}

// Takes what room there is, and asks for three rows: the rest of the page comes first.
class DeliveryList : public QListWidget {
public:
    using QListWidget::QListWidget;
    QSize sizeHint() const override { return {200, 3 * row() + 2}; }
    QSize minimumSizeHint() const override { return {120, 2 * row() + 2}; }

private:
    int row() const { return std::max(fontMetrics().height(), sizeHintForRow(0)); }
};

} // namespace

PlayPage::PlayPage(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_alley(alley)
    , m_column(new QVBoxLayout)
    , m_name(new QLabel(this))
    , m_place(new QLabel(this))
    , m_deck(new PinDeck(appearance(), this))
    , m_standing(new QLabel(this))
    , m_go(new QPushButton(this))
    , m_told(new QLabel(this))
    , m_detail(new QLabel(this))
    , m_note(new QLabel(this))
    , m_fault(new QLabel(this))
    , m_undo(new QPushButton(this))
    , m_foul(new QPushButton(this))
    , m_again(new QPushButton(this))
    , m_heading(new QLabel(this))
    , m_list(new DeliveryList(this))
    , m_conditions(new QLabel(this))
    , m_leave(new QPushButton(this)) {
    setObjectName(QStringLiteral("playPage"));
    build();
    connect(&alley, &Alley::changed, this, &PlayPage::adopt);
    connect(&alley, &Alley::revealed, this, &PlayPage::announce);
    connect(m_go, &QPushButton::clicked, &alley, &Alley::goOn);
    connect(m_undo, &QPushButton::clicked, &alley, &Alley::undo);
    connect(m_foul, &QPushButton::clicked, &alley, &Alley::setFoul);
    connect(m_again, &QPushButton::clicked, this, [this] {
        if (const auto last = lastDelivery(m_alley.shown()))
            m_alley.replay(m_alley.replayed().value_or(*last));
    });
    connect(m_leave, &QPushButton::clicked, &alley, &Alley::close);
    connect(m_list, &QListWidget::itemClicked, this, &PlayPage::replayItem);
    connect(m_list, &QListWidget::itemActivated, this, &PlayPage::replayItem);
    restyle();
    retranslate();
}

void PlayPage::build() {
    m_name->setObjectName(QStringLiteral("turnName"));
    m_name->setTextFormat(Qt::PlainText);
    m_place->setObjectName(QStringLiteral("turnPlace"));
    m_deck->setObjectName(QStringLiteral("turnDeck"));
    m_go->setObjectName(QStringLiteral("goOn"));
    m_told->setObjectName(QStringLiteral("announcement"));
    m_detail->setObjectName(QStringLiteral("announcementDetail"));
    m_detail->setTextFormat(Qt::PlainText);
    m_note->setObjectName(QStringLiteral("gameNote"));
    m_fault->setObjectName(QStringLiteral("saveFault"));
    m_undo->setObjectName(QStringLiteral("undoDelivery"));
    m_foul->setObjectName(QStringLiteral("markFoul"));
    m_again->setObjectName(QStringLiteral("seeAgain"));
    m_list->setObjectName(QStringLiteral("deliveries"));
    m_leave->setObjectName(QStringLiteral("leaveGame"));
    setTerm(m_place, "frame");
    setTerm(m_heading, "delivery");
    setTerm(m_foul, "foul");
    setTerm(m_conditions, "scoring");
    m_go->setProperty("prominent", true);
    m_leave->setProperty("quiet", true);
    m_foul->setCheckable(true);
    for (QPushButton* b : {m_go, m_undo, m_foul, m_again, m_leave})
        b->setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    m_list->setFocusPolicy(Qt::TabFocus);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QLabel* label : {m_detail, m_note, m_conditions, m_told, m_name, m_place, m_standing})
        label->setWordWrap(true);

    auto* words = new QVBoxLayout;
    words->addWidget(m_name);
    words->addWidget(m_place);
    words->addWidget(m_standing);
    words->addStretch(1);
    auto* head = new QHBoxLayout;
    head->addLayout(words, 1);
    head->addWidget(m_deck);
    auto* row = new QHBoxLayout;
    for (QPushButton* b : {m_again, m_foul, m_undo})
        row->addWidget(b, 1);
    m_column->addLayout(head);
    for (QWidget* w : std::initializer_list<QWidget*>{m_note, m_go, m_told, m_detail, m_fault})
        m_column->addWidget(w);
    m_column->addLayout(row);
    m_column->addWidget(m_heading);
    m_column->addWidget(m_list, 1);
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_conditions, 1);
    foot->addWidget(m_leave, 0, Qt::AlignBottom);
    m_column->addLayout(foot);
    // Under a score sheet of many rows a projector leaves less room than the page needs.
    auto* scroll = new QScrollArea(this);
    auto* inside = new QWidget(scroll);
    inside->setLayout(m_column);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
}

void PlayPage::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    const int unit = look.unit();
    setStyleSheet(styleSheet() + listStyle(look) +
                  QStringLiteral("QPushButton { padding: 0 4px; } QPushButton:focus { padding: 0 3px; }"
                                 "QPushButton:checked { background: %1; color: %2; border-color: %1; }"
                                 "QPushButton:disabled { color: %3; }")
                      .arg(look.error().name(), look.card().name(), look.faintText().name()));
    m_column->setContentsMargins(2 * unit, 2 * unit, 2 * unit, unit);
    m_column->setSpacing(unit);
    m_name->setFont(look.font(Appearance::Size::Title, true));
    m_place->setFont(look.font(Appearance::Size::Large));
    m_deck->setFixedSize(look.projector() ? QSize(136, 122) : QSize(96, 87));
    makeQuiet(*m_standing, look);
    m_go->setFont(look.font(Appearance::Size::Large, true));
    m_told->setFont(look.font(Appearance::Size::Title, true));
    m_told->setStyleSheet(QStringLiteral("color: %1;").arg(look.accent().name()));
    m_detail->setFont(look.font(Appearance::Size::Normal));
    m_note->setFont(look.font(Appearance::Size::Normal));
    m_note->setStyleSheet(QStringLiteral("color: %1; background: %2; padding: %3px; border-radius: 4px;")
                              .arg(look.text().name(), look.noteGround().name(), QString::number(unit)));
    makeMessage(*m_fault, look);
    for (QPushButton* b : {m_undo, m_foul, m_again, m_leave})
        b->setFont(look.font(Appearance::Size::Normal));
    m_heading->setFont(look.font(Appearance::Size::Normal, true));
    m_list->setFont(look.font(Appearance::Size::Normal));
    makeQuiet(*m_conditions, look);
    adopt();
}

void PlayPage::retranslate() {
    const auto say = [](QPushButton* b, const QString& text, const QString& toolTip) {
        b->setText(text);
        b->setAccessibleName(text);
        b->setToolTip(toolTip);
    };
    say(m_undo, tr("Undo"), tr("Takes the last delivery back; the same player throws again"));
    say(m_foul, tr("Foul"),
        tr("The last delivery was over the foul line: its pins do not count and are set up again"));
    say(m_again, tr("See again"), tr("Plays the last delivery again, or the one that is shown"));
    say(m_leave, tr("Leave the game"), tr("The game is saved; it goes on from the list of saved games"));
    m_heading->setText(tr("Deliveries"));
    m_list->setAccessibleName(tr("Deliveries"));
    m_list->setToolTip(tr("Click a delivery to see it again"));
    adopt();
}

void PlayPage::adopt() {
    if (!m_alley.isOn())
        return;
    showTurn();
    showTold();
    showNotes();
    showButtons();
    showList();
}

void PlayPage::showTurn() {
    const Game& game = m_alley.shown();
    const auto turn = m_alley.turn();
    m_deck->setVisible(turn.has_value());
    m_standing->setVisible(turn && !turn->turn.pins);
    if (!turn) {
        m_name->setText(tr("Game over"));
        m_place->setText(m_alley.told() ? QString() : winnerText(game)); // else it has just been said
        return;
    }
    m_name->setText(playerName(game, turn->player));
    m_place->setText(placeText(turn->turn));
    const PinSet pins = pinsFor(turn->turn);
    m_deck->setStanding(pins);
    m_deck->setToolTip(standingText(pins));
    m_standing->setText(tr("Which pins stand was not entered: the hindmost are set up."));
}

void PlayPage::showTold() {
    // While something else is shown, what was bowled last would be taken for it.
    const auto told = m_alley.phase() == Phase::Replay || m_alley.phase() == Phase::Elsewhere
                          ? std::nullopt
                          : m_alley.told();
    m_told->setVisible(told.has_value());
    m_detail->setVisible(told.has_value());
    if (!told)
        return;
    m_told->setText(announcement(m_alley.shown(), *told));
    setTerm(m_told, announcementTerm(m_alley.shown(), *told));
    m_detail->setText(announcementDetail(m_alley.shown(), *told));
}

void PlayPage::showNotes() {
    QString note;
    if (m_alley.phase() == Phase::Elsewhere)
        note = tr("The window shows something that is not of this game. The game waits.");
    else if (m_alley.replayed())
        note = tr("Seen again: %1").arg(deliveryText(m_alley.shown(), *m_alley.replayed()));
    const bool ran = m_alley.phase() == Phase::Rolling || m_alley.phase() == Phase::Result ||
                     m_alley.phase() == Phase::Replay;
    if (ran && m_alley.isOtherEngine())
        note += (note.isEmpty() ? QString() : QStringLiteral("\n")) +
                tr("This run is another engine's; the score is the exact engine's.");
    m_note->setText(note);
    m_note->setVisible(!note.isEmpty());
    m_fault->setText(m_alley.saveFault().isEmpty()
                         ? QString()
                         : tr("The game could not be saved: %1").arg(m_alley.saveFault()));
    m_fault->setVisible(!m_fault->text().isEmpty());
    QString conditions =
        rulesText(m_alley.game().rules) + QStringLiteral(" · ") + laneText(m_alley.game().lane);
    if (m_alley.release() != Release::None)
        conditions += QStringLiteral(" · ") + releaseText(m_alley.release()) + QStringLiteral(" · ") +
                      tr("seed %1").arg(m_alley.seed());
    m_conditions->setText(conditions);
    m_conditions->setToolTip(releaseToolTip(m_alley.release()));
}

void PlayPage::showButtons() {
    QString words, toolTip;
    switch (m_alley.phase()) {
    case Phase::Aim:
        words = tr("Throw");
        toolTip = tr("Throws the ball as it is aimed (Enter)");
        break;
    case Phase::Replay:
    case Phase::Elsewhere:
        words = tr("Back to the game");
        toolTip = tr("Sets the turn up again (Enter)");
        break;
    default:
        words = tr("Next");
        toolTip = tr("Tells the score and sets the next turn up (Enter)");
    }
    m_go->setText(words);
    m_go->setAccessibleName(words);
    m_go->setToolTip(toolTip);
    m_go->setVisible(m_alley.phase() != Phase::Over);
    const auto last = lastDelivery(m_alley.game());
    m_undo->setEnabled(last.has_value());
    m_foul->setEnabled(last && m_alley.phase() != Phase::Rolling);
    m_foul->setChecked(m_foul->isEnabled() && m_alley.foulMarked());
    const auto seen = m_alley.replayed() ? m_alley.replayed() : lastDelivery(m_alley.shown());
    m_again->setEnabled(seen && m_alley.shown().deliveries[seen->player][seen->delivery].thrown);
}

void PlayPage::showList() {
    const Game& game = m_alley.shown();
    m_places = inOrder(game);
    m_list->clear();
    const int side = appearance().unit() + appearance().unit() / 2;
    m_list->setIconSize(QSize(side, side));
    for (const DeliveryPlace& place : m_places) {
        auto* item = new QListWidgetItem(playerIcon(game.players[place.player].colour, side),
                                         deliveryLine(game, place), m_list);
        if (!game.deliveries[place.player][place.delivery].thrown)
            item->setFlags(Qt::NoItemFlags);
        item->setSelected(m_alley.replayed() == place);
    }
    m_heading->setVisible(!m_places.empty());
}

void PlayPage::replayItem(QListWidgetItem* item) {
    m_alley.replay(DeliveryPlace(m_places[std::size_t(m_list->row(item))]));
}

// Read out at once by screen readers.
void PlayPage::announce() {
    if (const auto told = m_alley.told())
        m_told->setAccessibleName(announcement(m_alley.shown(), *told) + QStringLiteral(" ") +
                                  announcementDetail(m_alley.shown(), *told));
    QAccessibleEvent event(m_told, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

} // namespace thetalane
