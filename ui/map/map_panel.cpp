#include "ui/map/map_panel.h"

#include "ui/map/map_controls.h"
#include "ui/map/map_legend.h"
#include "ui/map/map_words.h"
#include "ui/panels/pin_deck.h"
#include "ui/words/glossary.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

namespace thetalane {
namespace {

bool isOffsetOverAngle(const MapSettings& s) {
    return s.across.quantity == MapQuantity::Offset && s.up.quantity == MapQuantity::Angle;
}

} // namespace

MapPanel::MapPanel(const Context& context, QWidget* parent, int cells)
    : Panel(context, parent)
    , m_worker(new MapWorker(this))
    , m_controls(new MapControls(context, cells, this))
    , m_view(new MapView(context.appearance, this))
    , m_legend(new MapLegend(context.appearance, this))
    , m_settled(new QTimer(this)) {
    setObjectName(QStringLiteral("mapPanel"));
    m_settled->setSingleShot(true);
    m_settled->setInterval(250);
    build();
    connect(m_worker, &MapWorker::news, this, &MapPanel::take);
    connect(m_controls, &MapControls::changed, this, &MapPanel::start);
    connect(m_view, &MapView::pointedChanged, this, &MapPanel::showPointed);
    connect(m_view, &MapView::chosen, this, &MapPanel::throwIt);
    connect(m_settled, &QTimer::timeout, this, &MapPanel::startIfOther);
    connect(m_stop, &QPushButton::clicked, this, &MapPanel::stopOrAgain);
    connect(&session(), &Session::runChanged, this, [this] {
        showPresent();
        m_settled->start();
    });
    restyle();
    retranslate();
}

void MapPanel::build() {
    auto* scroll = new QScrollArea(this);
    scroll->setFocusPolicy(Qt::NoFocus); // the Tab key goes to what stands in it
    auto* inside = new QWidget(scroll);
    m_column = new QVBoxLayout(inside);
    m_note = new QLabel(inside);
    m_note->setObjectName(QStringLiteral("mapNote"));
    m_note->setWordWrap(true);
    setTerm(this, "strike-map");
    setTerm(m_note, "pinfall");
    setTerm(m_legend, "pinfall");
    m_column->addWidget(m_controls);
    m_column->addWidget(makeProgress());
    m_column->addWidget(m_view);
    m_column->addWidget(m_legend);
    m_column->addWidget(m_note);
    m_column->addWidget(makeButtons());
    m_column->addStretch(1);
    scroll->setWidget(inside);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(scroll, 1);
    layout->addWidget(makePointed()); // in sight while one points at the map, however low the window
    layout->addStretch(0);
}

QWidget* MapPanel::makePointed() {
    auto* box = new QWidget(this);
    m_deck = new PinDeck(appearance(), box);
    m_deck->setObjectName(QStringLiteral("mapDeck"));
    m_pointed = new QLabel(box);
    m_pointed->setObjectName(QStringLiteral("mapPointed"));
    m_pointed->setWordWrap(true);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_deck);
    layout->addWidget(m_pointed, 1);
    m_deck->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    return box;
}

QWidget* MapPanel::makeProgress() {
    m_progress = new QWidget(this);
    m_state = new QLabel(m_progress);
    m_state->setObjectName(QStringLiteral("mapState"));
    m_state->setWordWrap(true);
    setTerm(m_state, "strike-map");
    m_bar = new QProgressBar(m_progress);
    m_bar->setObjectName(QStringLiteral("mapProgress"));
    m_bar->setRange(0, 1000);
    m_bar->setTextVisible(false);
    m_stop = new QPushButton(m_progress);
    m_stop->setObjectName(QStringLiteral("mapStop"));
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(m_state);
    words->addWidget(m_bar);
    auto* layout = new QHBoxLayout(m_progress);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(words, 1);
    layout->addWidget(m_stop);
    return m_progress;
}

QWidget* MapPanel::makeButtons() {
    auto* row = new QWidget(this);
    m_csv = new QPushButton(row);
    m_csv->setObjectName(QStringLiteral("mapCsv"));
    m_picture = new QPushButton(row);
    m_picture->setObjectName(QStringLiteral("mapPicture"));
    m_message = new QLabel(row);
    m_message->setObjectName(QStringLiteral("mapSaved"));
    m_message->setWordWrap(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_csv);
    buttons->addWidget(m_picture);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(buttons);
    layout->addWidget(m_message);
    connect(m_csv, &QPushButton::clicked, this, [this] {
        ask(tr("Save the map as a table"), tr("Tables (*.csv)"), QStringLiteral("csv"), &MapPanel::saveCsv);
    });
    connect(m_picture, &QPushButton::clicked, this, [this] {
        ask(tr("Save the map as a picture"), tr("Pictures (*.png)"), QStringLiteral("png"),
            &MapPanel::savePicture);
    });
    return row;
}

void MapPanel::retranslate() {
    m_controls->retranslate();
    m_bar->setAccessibleName(tr("Progress of the map"));
    m_bar->setToolTip(m_bar->accessibleName());
    m_deck->setTitle(tr("Pins left standing"));
    m_deck->setToolTip(tr("What the throw that is pointed at leaves standing"));
    m_csv->setText(tr("Table …"));
    m_csv->setAccessibleName(tr("Save the map as a table"));
    m_picture->setText(tr("Picture …"));
    m_picture->setAccessibleName(tr("Save the map as a picture"));
    m_picture->setToolTip(tr("Save the map as a PNG picture, with axes and legend"));
    m_note->setText(carryNote());
    showState();
    showPointed();
}

void MapPanel::restyle() {
    Panel::restyle();
    const Appearance& a = appearance();
    const int unit = a.unit();
    m_column->setContentsMargins(unit, unit, unit, unit);
    m_column->setSpacing(unit);
    makeQuiet(*m_state, a);
    makeQuiet(*m_note, a);
    makeQuiet(*m_message, a);
    m_pointed->setFont(a.font(Appearance::Size::Normal));
    for (QPushButton* button : {m_stop, m_csv, m_picture})
        button->setFont(a.font(Appearance::Size::Normal));
    m_bar->setFixedHeight(unit / 2);
    m_bar->setStyleSheet(QStringLiteral("QProgressBar { border: none; border-radius: 2px; background: %1; }"
                                        "QProgressBar::chunk { border-radius: 2px; background: %2; }")
                             .arg(a.line().name(), a.accent().name()));
    m_deck->parentWidget()->layout()->setContentsMargins(unit, unit / 2, unit, unit / 2);
    const int deck = a.projector() ? 92 : 68;
    m_deck->setFixedSize(deck, int(deck * 0.88));
    m_deck->parentWidget()->setMinimumHeight(m_deck->height() + unit); // nothing jumps when one points
}

void MapPanel::showEvent(QShowEvent* event) {
    startIfOther();
    Panel::showEvent(event);
}

// Where there is room for all of it, what is pointed at is read right below.
void MapPanel::resizeEvent(QResizeEvent* event) {
    findChild<QScrollArea*>()->setMaximumHeight(m_column->totalHeightForWidth(width()));
    Panel::resizeEvent(event);
}

void MapPanel::startIfOther() {
    if (isVisible() && (!m_asked || *m_asked != m_controls->settings()))
        start();
}

void MapPanel::start() {
    if (!m_controls->isSound())
        return;
    m_asked = m_controls->settings();
    m_news = {};
    m_worker->start(*m_asked);
    showState();
}

void MapPanel::stopOrAgain() {
    if (running())
        m_worker->cancel();
    else
        start();
}

void MapPanel::take(const MapNews& news) {
    const bool other = news.map != m_news.map;
    m_news = news;
    if (other && news.map && news.map->stride > 0)
        m_view->setMap(news.map);
    showState();
    if (!other)
        return;
    showPresent();
    showPointed();
}

void MapPanel::showState() {
    m_state->setText(m_news.all > 0 || m_news.ended ? mapState(m_news)
                     : m_asked                      ? tr("Begins …")
                                                    : QString());
    m_bar->setVisible(running());
    m_bar->setValue(m_news.all > 0 ? int(1000 * m_news.done / m_news.all) : 0);
    m_stop->setText(running() ? tr("Cancel") : tr("Again"));
    m_stop->setAccessibleName(m_stop->text());
    m_stop->setToolTip(running() ? tr("Stops, and keeps what there is") : tr("Computes the map once more"));
    const bool whole = !running() && map() && map()->whole();
    m_picture->setEnabled(whole);
    m_csv->setEnabled(whole && isOffsetOverAngle(map()->settings));
    m_csv->setToolTip(whole && !m_csv->isEnabled()
                          ? tr("A table is made of maps of offset and entry angle")
                          : tr("Save the map as CSV, a line for each place: as thetalane map --csv does"));
    m_message->setText(m_saved ? m_saved() : QString());
    m_message->setVisible(m_saved != nullptr);
}

// What is pointed at; else where the present throw lies.
void MapPanel::showPointed() {
    const auto place = m_view->pointed();
    m_deck->setVisible(place.has_value());
    m_legend->setMarked(-1);
    if (!place || !map()) {
        const auto present = m_controls->presentValues();
        const QString hint = tr("Point at a place to see what stands there; click to throw it.");
        const bool beside = map() && present && !m_view->shows(*present);
        m_pointed->setText(beside ? hint + u'\n' + tr("The present throw comes in beside this map.") : hint);
        m_view->describe(hint);
        return;
    }
    const MapCell& cell = map()->at(place->column, place->row);
    const QString where = placeText(map()->settings, place->column, map()->settings.firstRow + place->row);
    m_deck->setStanding(cell.known() ? cell.left() : PinSet());
    m_deck->setVisible(cell.known());
    m_legend->setMarked(cell.known() ? cell.pinsDown() : -1);
    m_pointed->setText(where + u'\n' + cellText(cell));
    m_view->describe(m_pointed->text());
}

void MapPanel::setDots(std::vector<Entry> entries) {
    m_entries = std::move(entries);
    showPresent();
}

void MapPanel::showPresent() {
    m_view->setPresent(m_controls->presentValues());
    std::vector<MapView::Values> dots;
    if (map() && isOffsetOverAngle(map()->settings))
        for (const Entry& entry : m_entries)
            dots.push_back({entry.offset, entry.angle});
    m_view->setDots(std::move(dots));
    if (!m_view->pointed())
        showPointed();
}

void MapPanel::throwIt(MapView::Place place) {
    const MapSettings& s = map()->settings;
    const int row = s.firstRow + place.row;
    if (s.scene == MapScene::Bowling) {
        const auto ballThrow = mapThrow(s, place.column, row);
        if (!ballThrow || !session().setDelivery(*ballThrow, allPins, {s.restitution, s.friction}).empty())
            return;
    } else {
        const auto scene = mapScene(s, place.column, row);
        if (!scene || !session().open(*scene).empty())
            return;
    }
    playhead().setPlaying(false);
    playhead().setTime(0);
    playhead().setPlaying(true);
    emit thrown();
}

} // namespace thetalane
