#include "ui/game/new_game_page.h"

#include "ui/game/game_words.h"
#include "ui/game/player_row.h"
#include "ui/game/saved_games_list.h"
#include "ui/panels/number_field.h"
#include "ui/words/glossary.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace thetalane {
namespace {

constexpr double mostSeed = 999'999;

LaneConditions laneOf(int choice) {
    LaneConditions lane;
    if (choice == 1)
        lane.friction->oil.clear();
    if (choice == 2)
        lane.friction.reset();
    return lane;
}
constexpr int laneChoices = 3;

// New words in the order they had, and the choice stays.
void rename(QComboBox& box, const QStringList& names) {
    const int chosen = std::max(0, box.currentIndex());
    const QSignalBlocker silent(box);
    box.clear();
    box.addItems(names);
    box.setCurrentIndex(chosen);
}

} // namespace

NewGamePage::NewGamePage(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_context(context)
    , m_alley(alley)
    , m_column(new QVBoxLayout)
    , m_rows(new QVBoxLayout)
    , m_continue(new QPushButton(this))
    , m_heading(new QLabel(this))
    , m_add(new QPushButton(this))
    , m_rules(new QComboBox(this))
    , m_lane(new QComboBox(this))
    , m_release(new QComboBox(this))
    , m_seed(new NumberField(appearance(), QStringLiteral("seedField"), this))
    , m_start(new QPushButton(this))
    , m_saved(new SavedGamesList(context, alley, this)) {
    setObjectName(QStringLiteral("newGamePage"));
    for (QComboBox* box : {m_rules, m_lane, m_release})
        markAsChooser(*box, appearance());
    build();
    addPlayer();
    addPlayer();
    connect(m_continue, &QPushButton::clicked, &alley, &Alley::continueLatest);
    connect(m_add, &QPushButton::clicked, this, [this] { addPlayer()->nameEdit()->setFocus(); });
    connect(m_start, &QPushButton::clicked, this, &NewGamePage::start);
    connect(m_release, &QComboBox::currentIndexChanged, this, &NewGamePage::takeRelease);
    connect(m_seed, &NumberField::edited, this, &NewGamePage::takeRelease);
    restyle();
    retranslate();
}

QLabel* NewGamePage::addChoice(const char* name, QWidget* field) {
    auto* label = new QLabel(this);
    if (field->objectName().isEmpty())
        field->setObjectName(QLatin1String(name));
    label->setBuddy(field);
    m_choices->addRow(label, field);
    return label;
}

void NewGamePage::build() {
    m_continue->setObjectName(QStringLiteral("continueGame"));
    m_add->setObjectName(QStringLiteral("addPlayer"));
    m_add->setProperty("quiet", true);
    m_start->setObjectName(QStringLiteral("startGame"));
    m_start->setProperty("prominent", true);
    m_seed->setStep(1, 0, mostSeed);
    m_seed->setValue(m_alley.seed());
    m_choices = new QFormLayout;
    m_choices->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_choices->setRowWrapPolicy(QFormLayout::DontWrapRows);
    m_rulesLabel = addChoice("rulesChoice", m_rules);
    m_laneLabel = addChoice("laneChoice", m_lane);
    m_releaseLabel = addChoice("releaseChoice", m_release);
    m_seedLabel = addChoice("seed", m_seed);
    for (const auto& [label, field, term] : std::initializer_list<std::tuple<QLabel*, QWidget*, const char*>>{
             {m_rulesLabel, m_rules, "scoring"},
             {m_laneLabel, m_lane, "oil-pattern"},
             {m_releaseLabel, m_release, "release"},
             {m_seedLabel, m_seed, "release"}}) {
        setTerm(label, term);
        setTerm(field, term);
    }

    auto* inside = new QWidget;
    inside->setLayout(m_column);
    m_column->addWidget(m_continue);
    m_column->addWidget(m_heading);
    m_column->addLayout(m_rows);
    m_column->addWidget(m_add, 0, Qt::AlignLeft);
    m_column->addLayout(m_choices);
    m_column->addWidget(m_start);
    m_column->addWidget(m_saved);
    m_column->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
}

// The first colour that nobody has.
PlayerRow* NewGamePage::addPlayer() {
    int colour = 0;
    const auto taken = [&] {
        return std::any_of(m_players.begin(), m_players.end(),
                           [&](const PlayerRow* row) { return row->colour() == colour; });
    };
    while (taken() && colour + 1 < int(mostPlayers))
        ++colour;
    auto* row = new PlayerRow(m_context, int(m_players.size()), colour, this);
    connect(row, &PlayerRow::removeAsked, this, [this, row] { removePlayer(row); });
    // Return goes to the next name, and from the last one to the button that starts.
    connect(row, &PlayerRow::entered, this, [this, row] {
        const auto next = std::find(m_players.begin(), m_players.end(), row) + 1;
        if (next == m_players.end())
            m_start->setFocus();
        else
            (*next)->nameEdit()->setFocus();
    });
    m_rows->addWidget(row);
    m_players.push_back(row);
    countPlayers();
    return row;
}

void NewGamePage::removePlayer(PlayerRow* row) {
    std::erase(m_players, row);
    row->hide();
    row->deleteLater();
    countPlayers();
}

void NewGamePage::countPlayers() {
    for (std::size_t k = 0; k < m_players.size(); ++k) {
        m_players[k]->setNumber(int(k));
        m_players[k]->setRemovable(m_players.size() > 1);
    }
    m_add->setVisible(m_players.size() < mostPlayers);
}

void NewGamePage::takeRelease() {
    const double seed = m_seed->value();
    const bool good = seed >= 0 && seed <= mostSeed && seed == std::floor(seed);
    m_seed->setWrong(!good);
    m_alley.setRelease(releases[std::size_t(std::max(0, m_release->currentIndex()))],
                       good ? std::uint32_t(seed) : m_alley.seed());
    showRelease();
}

void NewGamePage::showRelease() {
    const bool byChance = m_alley.release() != Release::None;
    m_seed->setVisible(byChance);
    m_seedLabel->setVisible(byChance);
    m_release->setToolTip(releaseToolTip(m_alley.release()));
}

void NewGamePage::start() {
    std::vector<Player> players;
    for (const PlayerRow* row : m_players)
        players.push_back(row->player());
    m_alley.start(std::move(players), ScoringRules(m_rules->currentIndex()), laneOf(m_lane->currentIndex()));
}

void NewGamePage::refresh() {
    m_saved->refresh();
    const auto& saved = m_alley.store().list();
    const auto unfinished = std::find_if(saved.begin(), saved.end(),
                                         [](const SavedGame& s) { return s.game() && turnOf(*s.game()); });
    m_continue->setVisible(unfinished != saved.end());
    if (unfinished == saved.end())
        return;
    const QString title = gameTitle(*unfinished->game());
    const QFontMetrics metrics(m_continue->font());
    m_continue->setText(
        tr("Go on: %1").arg(metrics.elidedText(title, Qt::ElideRight, 26 * appearance().unit())));
    m_continue->setAccessibleName(tr("Go on: %1").arg(title));
    m_continue->setToolTip(tr("Goes on with the latest game that is not over: %1").arg(title));
}

void NewGamePage::retranslate() {
    m_heading->setText(tr("New game"));
    m_add->setText(tr("+ Add a player"));
    m_add->setAccessibleName(tr("Add a player"));
    m_add->setToolTip(tr("Up to %1 players take turns").arg(mostPlayers));
    rename(*m_rules, {rulesText(ScoringRules::Traditional), rulesText(ScoringRules::CurrentFrame)});
    QStringList lanes, hands;
    for (int k = 0; k < laneChoices; ++k)
        lanes << laneText(laneOf(k));
    for (const Release release : releases)
        hands << releaseText(release);
    rename(*m_lane, lanes);
    rename(*m_release, hands);
    m_rulesLabel->setText(tr("Scoring"));
    m_laneLabel->setText(tr("Lane"));
    m_releaseLabel->setText(tr("Hand"));
    m_seedLabel->setText(tr("Seed"));
    m_rules->setAccessibleName(tr("Scoring"));
    m_rules->setToolTip(
        tr("Traditional: a strike adds the next two balls, a spare the next one. Current frame: "
           "a strike is 30, a spare 10 and its first ball."));
    m_lane->setAccessibleName(tr("Lane"));
    m_lane->setToolTip(tr("Oil to 40 ft and dry behind it; dry throughout; or no friction at all"));
    m_release->setAccessibleName(tr("Hand"));
    m_seed->setWords(tr("Seed"), tr("The same number brings the same chance: a game can be thrown again"));
    m_start->setText(tr("Start the game"));
    m_start->setAccessibleName(tr("Start the game"));
    m_start->setToolTip(tr("Sets the pins up for the first player"));
    showRelease();
    refresh();
}

void NewGamePage::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    m_column->setContentsMargins(2 * unit, 2 * unit, 2 * unit, 2 * unit);
    m_column->setSpacing(unit + unit / 2);
    m_rows->setSpacing(unit / 2);
    m_choices->setSpacing(unit);
    m_heading->setFont(appearance().font(Appearance::Size::Large, true));
    const QFont normal = appearance().font(Appearance::Size::Normal);
    for (QWidget* w : std::initializer_list<QWidget*>{m_continue, m_add, m_rules, m_lane, m_release,
                                                      m_rulesLabel, m_laneLabel, m_releaseLabel, m_seedLabel})
        w->setFont(normal);
    m_start->setFont(appearance().font(Appearance::Size::Large, true));
}

} // namespace thetalane
