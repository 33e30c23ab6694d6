#include "ui/panels/timeline_bar.h"

#include "ui/panels/icon_button.h"
#include "ui/panels/rate_chooser.h"
#include "ui/panels/scrub_bar.h"
#include "ui/panels/slow_motion_button.h"
#include "ui/panels/time_readout.h"
#include "ui/panels/until_chooser.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSettings>

#include <algorithm>

namespace thetalane {
namespace {

const char* const slowKey = "playback/slowAtImpact";

} // namespace

TimelineBar::TimelineBar(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_controls(new QWidget(this))
    , m_grid(new QGridLayout(this)) {
    setObjectName(QStringLiteral("timelineBar"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    makeControls(); // first: the Tab key meets them first
    makeRate(context);
    m_scrub = new ScrubBar(context, this);
    m_readout = new TimeReadout(context, this);
    m_until = new UntilChooser(context, this);
    // The arrangement follows the width, so the grid must not hold on to the width of the wide one.
    m_grid->setSizeConstraint(QLayout::SetNoConstraint);
    connect(&playhead(), &Playhead::playingChanged, this, &TimelineBar::showPlaying);
    connect(&playhead(), &Playhead::timeChanged, this, &TimelineBar::showReachable);
    connect(&playhead(), &Playhead::selectionChanged, this, &TimelineBar::showReachable);
    connect(&session(), &Session::runChanged, this, &TimelineBar::showReachable);
    connect(&session(), &Session::chapterChanged, this, &TimelineBar::showReachable);
    connect(&session(), &Session::progressed, this, &TimelineBar::showReachable);
    connect(m_until, &UntilChooser::resized, this, &TimelineBar::arrange);
    restyle();
    retranslate();
    showReachable();
}

void TimelineBar::makeControls() {
    auto* row = new QHBoxLayout(m_controls);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    const auto add = [&](Icon icon, const char* name, auto action,
                         IconButton::Weight weight = IconButton::Weight::Quiet) {
        auto* button = new IconButton(appearance(), icon, name, m_controls, weight);
        connect(button, &QAbstractButton::clicked, this, action);
        row->addWidget(button);
        return button;
    };
    m_start = add(Icon::Start, "startButton", [this] {
        playhead().setPlaying(false);
        playhead().setTime(0);
    });
    m_collisionBack =
        add(Icon::CollisionBack, "collisionBackButton", [this] { playhead().stepCollisions(-1); });
    m_frameBack = add(Icon::FrameBack, "frameBackButton", [this] { playhead().stepFrames(-1); });
    row->addSpacing(4);
    m_play = add(
        Icon::Play, "playButton", [this] { playhead().togglePlaying(); }, IconButton::Weight::Prominent);
    row->addSpacing(4);
    m_frameForward = add(Icon::FrameForward, "frameForwardButton", [this] { playhead().stepFrames(1); });
    m_collisionForward =
        add(Icon::CollisionForward, "collisionForwardButton", [this] { playhead().stepCollisions(1); });
}

void TimelineBar::makeRate(const Context& context) {
    m_rate = new QWidget(this);
    auto* row = new QHBoxLayout(m_rate);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(new RateChooser(context, m_rate));
    m_slow = new SlowMotionButton(context, m_rate);
    row->addWidget(m_slow);
    connect(m_slow, &QAbstractButton::clicked, this, [](bool on) { QSettings().setValue(slowKey, on); });
    connect(&session(), &Session::runChanged, this, &TimelineBar::showPins);
    showPins();
}

// Where there are none, there is nothing to be slow for.
void TimelineBar::showPins() {
    const auto& bodies = session().scene().bodies;
    const bool pins =
        std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.kind == BodyKind::Pin; });
    if (m_slow->isHidden() != pins)
        return;
    m_slow->setVisible(pins);
    if (m_until)
        arrange();
}

void TimelineBar::restoreChoices() {
    playhead().setSlowAtImpact(QSettings().value(slowKey, false).toBool());
}

void TimelineBar::retranslate() {
    m_start->setWords(tr("To the start"), tr("To the start (R)"));
    m_collisionBack->setWords(tr("Collision before"), tr("Collision before (Ctrl+←)"));
    m_frameBack->setWords(tr("One frame back"), tr("One frame back (←)"));
    m_frameForward->setWords(tr("One frame forward"), tr("One frame forward (→)"));
    m_collisionForward->setWords(tr("Next collision"), tr("Next collision (Ctrl+→)"));
    showPlaying();
}

void TimelineBar::restyle() {
    setFont(appearance().font(Appearance::Size::Normal));
    const int unit = appearance().unit();
    m_grid->setContentsMargins(unit, unit / 2, unit, unit / 2);
    m_grid->setHorizontalSpacing(unit);
    m_grid->setVerticalSpacing(0);
    arrange();
}

void TimelineBar::showPlaying() {
    const bool playing = playhead().playing();
    m_play->showIcon(playing ? Icon::Pause : Icon::Play);
    m_play->setWords(playing ? tr("Pause") : tr("Play"), playing ? tr("Pause (Space)") : tr("Play (Space)"));
}

void TimelineBar::showReachable() {
    const double time = playhead().time();
    m_start->setEnabled(time > 0);
    m_frameBack->setEnabled(time > 0);
    m_frameForward->setEnabled(time < playhead().end());
    m_collisionBack->setEnabled(playhead().canStepCollisions(-1));
    m_collisionForward->setEnabled(playhead().canStepCollisions(1));
}

// In one row where there is room for a line worth dragging on, else in two: the line above, the buttons
// below.
void TimelineBar::hideFuture(bool hidden) {
    m_scrub->hideFuture(hidden);
}

void TimelineBar::arrange() {
    const int unit = appearance().unit();
    const int others = m_controls->sizeHint().width() + m_rate->sizeHint().width() + timesWidth() + 5 * unit;
    m_wide = width() >= others + 40 * unit;
    for (QWidget* part : {m_controls, m_rate, static_cast<QWidget*>(m_scrub),
                          static_cast<QWidget*>(m_readout), static_cast<QWidget*>(m_until)})
        m_grid->removeWidget(part);
    for (int column = 0; column < 5; ++column)
        m_grid->setColumnStretch(column, 0);
    if (m_wide) {
        m_grid->addWidget(m_controls, 0, 0);
        m_grid->addWidget(m_rate, 0, 1);
        m_grid->addWidget(m_scrub, 0, 2);
        m_grid->addWidget(m_readout, 0, 3);
        m_grid->addWidget(m_until, 0, 4);
        m_grid->setColumnStretch(2, 1);
    } else {
        m_grid->addWidget(m_scrub, 0, 0, 1, 4);
        m_grid->addWidget(m_controls, 1, 0);
        m_grid->addWidget(m_rate, 1, 1, Qt::AlignCenter);
        m_grid->addWidget(m_readout, 1, 2, Qt::AlignRight | Qt::AlignVCenter);
        m_grid->addWidget(m_until, 1, 3, Qt::AlignRight | Qt::AlignVCenter);
        m_grid->setColumnStretch(1, 1);
    }
    updateGeometry();
}

int TimelineBar::timesWidth() const {
    return m_readout->sizeHint().width() +
           (m_until->isHidden() ? 0 : m_until->sizeHint().width() + appearance().unit());
}

QSize TimelineBar::sizeHint() const {
    return {appearance().unit() * 80, minimumSizeHint().height()};
}

QSize TimelineBar::minimumSizeHint() const {
    const int unit = appearance().unit();
    const int row = m_controls->sizeHint().height();
    const int others = m_controls->sizeHint().width() + m_rate->sizeHint().width() + timesWidth() + 4 * unit;
    return {others, unit + row + (m_wide ? 0 : m_scrub->sizeHint().height())};
}

void TimelineBar::resizeEvent(QResizeEvent* event) {
    arrange();
    Panel::resizeEvent(event);
}

} // namespace thetalane
