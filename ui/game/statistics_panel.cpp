#include "ui/game/statistics_panel.h"

#include "ui/game/game_words.h"
#include "ui/game/player_colours.h"
#include "ui/game/saved_games_list.h"
#include "ui/words/glossary.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace thetalane {
namespace {

enum Row { Games, Average, Best, Strikes, Spares, Opens, Splits, FirstBall, Pocket, rowCount };

QString share(int part, int whole) {
    return whole > 0 ? QStringLiteral("%1/%2").arg(part).arg(whole) : QStringLiteral("–");
}

QString rounded(const std::optional<double>& value) {
    return value ? QString::number(*value, 'f', 1) : QStringLiteral("–");
}

std::array<QString, rowCount> textsOf(const Statistics& s) {
    std::array<QString, rowCount> texts;
    texts[Games] = QString::number(s.games);
    texts[Average] = rounded(s.average());
    texts[Best] = s.games > 0 ? QString::number(s.best) : QStringLiteral("–");
    texts[Strikes] = share(s.strikes, s.firstBalls);
    texts[Spares] = share(s.spares, s.spareChances);
    texts[Opens] = QString::number(s.opens);
    texts[Splits] = QString::number(s.splits);
    texts[FirstBall] = rounded(s.firstBallAverage());
    texts[Pocket] = share(s.pocketHits, s.pocketChances);
    return texts;
}

} // namespace

StatisticsPanel::StatisticsPanel(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_alley(alley)
    , m_which(new QComboBox(this))
    , m_empty(new QLabel(this))
    , m_table(new QTableWidget(this))
    , m_note(new QLabel(this)) {
    markAsChooser(*m_which, appearance());
    setObjectName(QStringLiteral("statisticsPanel"));
    m_which->setObjectName(QStringLiteral("statisticsOf"));
    m_table->setObjectName(QStringLiteral("statisticsTable"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setShowGrid(false);
    m_table->setCornerButtonEnabled(false);
    m_table->setFocusPolicy(Qt::TabFocus);
    m_table->setRowCount(rowCount);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_empty->setWordWrap(true);
    m_note->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_which);
    layout->addWidget(m_empty);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_note);
    layout->addStretch(0);
    m_which->addItems({QString(), QString()});
    connect(m_which, &QComboBox::currentIndexChanged, this, &StatisticsPanel::refresh);
    connect(&alley, &Alley::changed, this, [this] {
        if (isVisible())
            refresh();
    });
    restyle();
    retranslate();
}

void StatisticsPanel::showEvent(QShowEvent* event) {
    refresh();
    Panel::showEvent(event);
}

void StatisticsPanel::restyle() {
    Panel::restyle();
    const Appearance& look = appearance();
    const int unit = look.unit();
    layout()->setContentsMargins(2 * unit, 2 * unit, 2 * unit, unit);
    layout()->setSpacing(unit);
    const QFont normal = look.font(Appearance::Size::Normal);
    for (QWidget* w : std::initializer_list<QWidget*>{m_which, m_empty, m_table})
        w->setFont(normal);
    setStyleSheet(
        styleSheet() +
        QStringLiteral(
            "QTableCornerButton::section { background: transparent; border: none; }"
            "QTableView::corner, QAbstractScrollArea::corner { background: transparent; border: none; }"
            "QHeaderView:vertical, QHeaderView::section:vertical { border: none; padding: 0 4px 3px 0; }"
            "QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }"
            "QScrollBar::handle:horizontal { background: %1; border-radius: 4px;"
            " min-width: 32px; margin: 1px; }")
            .arg(look.line().name()));
    m_table->horizontalHeader()->setFont(look.font(Appearance::Size::Normal, true));
    m_table->verticalHeader()->setFont(normal);
    m_table->verticalHeader()->setDefaultSectionSize(normal.pixelSize() + 2 * unit);
    m_table->setIconSize(QSize(unit, unit) * 3 / 2);
    makeQuiet(*m_note, look);
    fitNames();
    refresh();
}

void StatisticsPanel::retranslate() {
    m_which->setItemText(0, tr("This game"));
    m_which->setItemText(1, tr("All saved games"));
    m_which->setAccessibleName(tr("Statistics of"));
    m_which->setToolTip(tr("Which games are counted"));
    m_table->setAccessibleName(tr("Statistics"));
    m_empty->setText(tr("Nothing has been bowled yet."));
    m_note->setText(
        tr("Strikes of the balls at ten pins; spares of the balls at what a first ball left; pocket "
           "hits of the first balls that were thrown. The average is of games that are over."));
    const std::array<QString, rowCount> names{
        tr("Games"),       tr("Average"), tr("Best game"),           tr("Strikes"),    tr("Spares"),
        tr("Open frames"), tr("Splits"),  tr("First ball, average"), tr("Pocket hits")};
    m_table->setVerticalHeaderLabels(QStringList(names.begin(), names.end()));
    static constexpr std::array<const char*, rowCount> terms{
        nullptr, nullptr, "perfect-game", "strike", "spare", "open-frame", "split", "pinfall", "pocket"};
    for (int r = 0; r < rowCount; ++r)
        if (terms[std::size_t(r)])
            m_table->verticalHeaderItem(r)->setData(termRole, QString::fromLatin1(terms[std::size_t(r)]));
    fitNames();
    refresh();
}

// Under a style sheet the header measures with another font than it writes with.
void StatisticsPanel::fitNames() {
    const QFontMetrics metrics(appearance().font(Appearance::Size::Normal));
    int widest = 0;
    for (int r = 0; r < rowCount; ++r)
        if (const QTableWidgetItem* item = m_table->verticalHeaderItem(r))
            widest = std::max(widest, metrics.horizontalAdvance(item->text()));
    m_table->verticalHeader()->setFixedWidth(widest + 2 * appearance().unit());
}

std::vector<StatisticsPanel::Column> StatisticsPanel::ofThisGame() const {
    std::vector<Column> columns;
    const Game& game = m_alley.shown();
    Column all{tr("All"), -1, {}};
    for (std::size_t k = 0; k < game.players.size(); ++k) {
        columns.push_back({playerName(game, k), game.players[k].colour, statisticsOf(game, k)});
        all.statistics += columns.back().statistics;
    }
    if (columns.size() > 1)
        columns.push_back(all);
    return columns;
}

// Players of the same name are taken for the same; who played last stands first.
std::vector<StatisticsPanel::Column> StatisticsPanel::ofAllGames() const {
    std::vector<Column> columns;
    Column all{tr("All"), -1, {}};
    for (const SavedGame& saved : m_alley.store().list())
        for (std::size_t k = 0; k < saved.statistics.size(); ++k) {
            const QString name = playerName(*saved.game(), k);
            auto column =
                std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
            if (column == columns.end())
                column = columns.insert(column, {name, saved.game()->players[k].colour, {}});
            column->statistics += saved.statistics[k];
            all.statistics += saved.statistics[k];
        }
    if (!columns.empty())
        columns.insert(columns.begin(), all);
    return columns;
}

void StatisticsPanel::refresh() {
    const auto columns = m_which->currentIndex() == 0 ? ofThisGame() : ofAllGames();
    m_empty->setVisible(columns.empty());
    m_table->setVisible(!columns.empty());
    m_note->setVisible(!columns.empty());
    fill(columns);
}

void StatisticsPanel::fill(const std::vector<Column>& columns) {
    const int side = appearance().unit() * 3 / 2;
    m_table->setColumnCount(int(columns.size()));
    for (int c = 0; c < int(columns.size()); ++c) {
        const Column& column = columns[std::size_t(c)];
        auto* heading = new QTableWidgetItem(column.name);
        if (column.colour >= 0)
            heading->setIcon(playerIcon(column.colour, side));
        m_table->setHorizontalHeaderItem(c, heading);
        const auto texts = textsOf(column.statistics);
        for (int r = 0; r < rowCount; ++r) {
            auto* item = new QTableWidgetItem(texts[std::size_t(r)]);
            item->setTextAlignment(Qt::AlignCenter);
            m_table->setItem(r, c, item);
        }
    }
}

} // namespace thetalane
