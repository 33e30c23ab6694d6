#include "ui/practice/spare_box.h"

#include "core/study/vary_throw.h"
#include "ui/panels/pin_deck.h"
#include "ui/practice/latest_job.h"
#include "ui/practice/leaves.h"
#include "ui/words/glossary.h"
#include "ui/words/number_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <numbers>

namespace thetalane {
namespace {

constexpr double degree = std::numbers::pi / 180;

Throw presentThrow(const Session& session) {
    return session.currentThrow().value_or(Throw{});
}

LaneConditions presentLane(const Session& session) {
    return session.currentThrow() ? session.laneConditions() : LaneConditions{};
}

} // namespace

SpareBox::SpareBox(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_search(new LatestJob(this))
    , m_deck(new PinDeck(appearance(), this))
    , m_title(new QLabel(this))
    , m_hint(new QLabel(this))
    , m_count(new QLabel(this))
    , m_result(new QLabel(this))
    , m_line(new QLabel(this))
    , m_throw(new QPushButton(this))
    , m_show(new QPushButton(this))
    , m_leafArea(new QWidget(this))
    , m_column(new QVBoxLayout(this)) {
    setObjectName(QStringLiteral("spareBox"));
    build();
    connect(m_deck, &PinDeck::picked, this, &SpareBox::pick);
    connect(m_throw, &QPushButton::clicked, this, &SpareBox::throwBall);
    connect(m_show, &QPushButton::clicked, this, &SpareBox::advise);
    connect(&session(), &Session::runChanged, this, &SpareBox::followSession);
    connect(&playhead(), &Playhead::timeChanged, this, &SpareBox::followPlayhead);
    restyle();
    retranslate();
    followSession();
}

void SpareBox::build() {
    const std::pair<QLabel*, const char*> labels[] = {{m_title, "spareTitle"},
                                                      {m_hint, "spareHint"},
                                                      {m_count, "spareCount"},
                                                      {m_result, "spareResult"},
                                                      {m_line, "spareLine"}};
    for (const auto& [label, name] : labels) {
        label->setObjectName(QLatin1String(name));
        label->setWordWrap(true);
    }
    m_deck->setObjectName(QStringLiteral("spareDeck"));
    m_deck->setPickable(true);
    setTerm(m_title, "spare");
    setTerm(m_count, "leave");
    setTerm(m_leafArea, "leave");
    m_throw->setObjectName(QStringLiteral("spareThrow"));
    m_throw->setProperty("prominent", true);
    m_show->setObjectName(QStringLiteral("spareAdvice"));
    for (QPushButton* button : {m_throw, m_show})
        button->setFocusPolicy(Qt::TabFocus); // the space bar stays where it is
    for (const PinSet& pins : classicLeaves()) {
        auto* leaf = new LeafButton(appearance(), pins, m_leafArea);
        connect(leaf, &LeafButton::clicked, this, [this, pins] { pick(pins); });
        m_leaves.push_back(leaf);
    }
    auto* beside = new QVBoxLayout;
    beside->addWidget(m_count);
    beside->addWidget(m_result);
    beside->addStretch(1);
    auto* top = new QHBoxLayout;
    top->addWidget(m_deck);
    top->addLayout(beside, 1);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->addWidget(m_title);
    m_column->addWidget(m_hint);
    m_column->addLayout(top);
    m_column->addWidget(m_leafArea);
    m_column->addWidget(m_throw);
    m_column->addWidget(m_show);
    m_column->addWidget(m_line);
}

// As many leaves side by side as there is room for; a layout would hold on to its columns.
void SpareBox::arrange() {
    const QSize leaf = m_leaves.front()->sizeHint();
    const int gap = appearance().unit() / 2;
    const int columns = std::max(1, (width() + gap) / (leaf.width() + gap));
    const int rows = (int(m_leaves.size()) + columns - 1) / columns;
    for (int k = 0; k < int(m_leaves.size()); ++k)
        m_leaves[std::size_t(k)]->setGeometry(
            QRect(QPoint(k % columns * (leaf.width() + gap), k / columns * (leaf.height() + gap)), leaf));
    m_leafArea->setFixedHeight(rows * (leaf.height() + gap) - gap);
}

void SpareBox::resizeEvent(QResizeEvent* event) {
    arrange();
    Panel::resizeEvent(event);
}

const PinSet& SpareBox::standing() const {
    return m_deck->standing();
}

SpareBox::Count SpareBox::countOf(const PinSet& pins) const {
    const auto found = m_counts.find(pins.to_ulong());
    return found == m_counts.end() ? Count() : found->second;
}

bool SpareBox::searching() const {
    return m_advice == Advice::Searching;
}

void SpareBox::pick(const PinSet& pins) {
    settle();
    m_deck->setStanding(pins);
    m_last.reset();
    m_advice = Advice::None;
    m_search->drop();
    playhead().setPlaying(false);
    m_applying = true;
    session().setDelivery(presentThrow(session()), pins, presentLane(session()));
    m_applying = false;
    playhead().setTime(0);
    showCounts();
    showResult();
    showAdvice();
}

// The try is what the exact engine makes of the throw, however much of it the window shows.
void SpareBox::throwBall() {
    settle();
    const PinSet pins = standing();
    if (!session().currentThrow() || session().standing() != pins)
        session().setDelivery(presentThrow(session()), pins, presentLane(session()));
    const VariedThrow outcome = outcomeOf(presentThrow(session()), pins, presentLane(session()));
    playhead().setPlaying(false);
    playhead().setTime(0);
    m_last.reset();
    m_flying = Try{pins, outcome.left};
    showResult();
    playhead().setPlaying(true);
    emit thrown();
}

void SpareBox::settle() {
    if (!m_flying)
        return;
    m_last = *std::exchange(m_flying, std::nullopt);
    Count& count = m_counts[m_last->pins.to_ulong()];
    ++count.tries;
    count.made += m_last->left.none();
    showCounts();
    showResult();
}

void SpareBox::followPlayhead() {
    if (m_flying && playhead().time() >= playhead().end())
        settle();
}

// Another throw, or other pins, from anywhere: what flew counts first.
void SpareBox::followSession() {
    settle();
    if (session().currentThrow())
        m_deck->setStanding(session().standing());
    if (!m_applying) {
        m_last.reset();
        m_advice = Advice::None; // it was about another throw
        m_search->drop();
        showResult();
        showAdvice();
    }
    showCounts();
}

void SpareBox::advise() {
    m_advice = Advice::Searching;
    showAdvice();
    const Throw base = presentThrow(session());
    const PinSet pins = standing();
    const LaneConditions lane = presentLane(session());
    m_search->start([this, base, pins, lane](const std::stop_token& stop) -> LatestJob::Answer {
        const auto line = spareLine(base, pins, lane, stop);
        return [this, line, pins, lane] {
            m_advice = line ? Advice::Found : Advice::NotFound;
            if (line && pins == standing()) {
                m_spread = line->spread;
                playhead().setPlaying(false);
                m_applying = true;
                session().setDelivery(line->ballThrow, pins, lane);
                m_applying = false;
                playhead().setTime(0);
            }
            showAdvice();
        };
    });
}

void SpareBox::retranslate() {
    m_title->setText(tr("Spare practice"));
    m_hint->setText(tr("Click pins to set them up or take them away, or choose a leave; then throw."));
    m_throw->setText(tr("Throw at these pins"));
    m_throw->setAccessibleName(m_throw->text());
    m_throw->setToolTip(tr("Throws the ball as it is set; it counts as a try"));
    m_show->setText(tr("Show a line that makes it"));
    m_show->setAccessibleName(m_show->text());
    m_show->setToolTip(
        tr("Looks for position and direction with this weight, speed and rotation that forgive most"));
    for (LeafButton* leaf : m_leaves)
        leaf->retranslate();
    showCounts();
    showResult();
    showAdvice();
}

void SpareBox::showCounts() {
    const PinSet pins = standing();
    const Count here = countOf(pins);
    Count all;
    for (const auto& [bits, count] : m_counts) {
        all.tries += count.tries;
        all.made += count.made;
    }
    QString text = leafName(pins) + u'\n';
    text += here.tries > 0 ? tr("made %1 of %2").arg(here.made).arg(here.tries) : tr("not tried yet");
    if (all.tries > here.tries)
        text += u'\n' + tr("all leaves: %1 of %2").arg(all.made).arg(all.tries);
    m_count->setText(text);
    m_throw->setEnabled(pins.any());
    m_show->setEnabled(pins.any());
    for (LeafButton* leaf : m_leaves)
        leaf->setChecked(leaf->pins() == pins);
}

void SpareBox::showResult() {
    QString text;
    if (m_flying)
        text = tr("On its way …");
    else if (m_last)
        text = m_last->left.any()   ? tr("Missed: %1 left").arg(pinsText(m_last->left))
               : m_last->pins.all() ? tr("A strike!")
                                    : tr("Made!");
    m_result->setText(text);
}

void SpareBox::showAdvice() {
    QString text;
    if (m_advice == Advice::Searching)
        text = tr("Looking …");
    else if (m_advice == Advice::NotFound)
        text = tr("With this ball, no line among those tried makes it.");
    else if (m_advice == Advice::Found)
        text = tr("It is set: the direction may be off by %1° to either side.")
                   .arg(numberText(m_spread / 2 / degree, 2));
    m_line->setText(text);
    m_line->setVisible(!text.isEmpty());
}

void SpareBox::restyle() {
    Panel::restyle();
    const Appearance& a = appearance();
    m_column->setSpacing(a.unit());
    m_title->setFont(a.font(Appearance::Size::Large, true));
    makeQuiet(*m_hint, a);
    m_count->setFont(a.font(Appearance::Size::Normal));
    m_result->setFont(a.font(Appearance::Size::Large, true));
    m_line->setFont(a.font(Appearance::Size::Normal));
    m_throw->setFont(a.font(Appearance::Size::Normal, true));
    m_show->setFont(a.font(Appearance::Size::Normal));
    arrange();
}

} // namespace thetalane
