#include "ui/predict/predict_panel.h"

#include "core/study/just_before.h"
#include "ui/count_text.h"
#include "ui/predict/guess_fields.h"
#include "ui/predict/predict_figure.h"
#include "ui/predict/predict_words.h"
#include "ui/words/kept_units.h"
#include "ui/words/number_text.h"

#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace thetalane {
namespace {

QLabel* label(const char* name, QWidget* parent) {
    auto* l = new QLabel(parent);
    l->setObjectName(QLatin1String(name));
    l->setTextFormat(Qt::PlainText);
    l->setWordWrap(true);
    return l;
}

QPushButton* button(const char* name, QWidget* parent, const char* kind) {
    auto* b = new QPushButton(parent);
    b->setObjectName(QLatin1String(name));
    b->setProperty(kind, true);
    return b;
}

void setWords(QPushButton& b, const QString& text, const QString& toolTip) {
    b.setText(text);
    b.setToolTip(toolTip);
    b.setAccessibleName(text);
}

} // namespace

PredictPanel::PredictPanel(const Context& context, QWidget* parent)
    : Panel(context, parent)
    , m_pages(new QStackedWidget(this)) {
    setObjectName(QStringLiteral("predictPanel"));
    m_pages->addWidget(makeInvitation());
    m_pages->addWidget(makeWork(context));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);
    connect(&session(), &Session::runChanged, this, &PredictPanel::drop);
    connect(&session(), &Session::progressed, this, &PredictPanel::showInvitation);
    connect(&playhead(), &Playhead::timeChanged, this, &PredictPanel::followPlayhead);
    connect(&playhead(), &Playhead::selectionChanged, this, &PredictPanel::followPlayhead);
    restyle();
    retranslate();
    setState(State::Invitation);
}

QWidget* PredictPanel::makeInvitation() {
    auto* page = new QWidget;
    m_invitation = label("predictInvitation", page);
    m_invitation->setAlignment(Qt::AlignHCenter);
    m_begin = button("beginPrediction", page, "prominent");
    connect(m_begin, &QPushButton::clicked, this, &PredictPanel::begin);
    auto* column = new QVBoxLayout(page);
    column->addStretch(2);
    column->addWidget(m_invitation);
    column->addWidget(m_begin, 0, Qt::AlignHCenter);
    column->addStretch(3);
    return page;
}

QWidget* PredictPanel::makeWork(const Context& context) {
    auto* inside = new QWidget;
    m_column = new QVBoxLayout(inside);
    m_title = label("predictTitle", inside);
    m_facts = label("predictFacts", inside);
    m_score = label("predictScore", inside);
    m_wrong = label("predictWrong", inside);
    m_figure = new PredictFigure(context.appearance, inside);
    m_truth = label("predictTruth", inside);
    m_fields = new GuessFields(context.appearance, inside);
    m_message = label("predictMessage", inside);
    m_rule = label("predictRule", inside);
    for (QWidget* w : std::initializer_list<QWidget*>{m_title, m_facts, m_score, m_figure, m_wrong, m_truth,
                                                      m_fields, m_message, m_rule})
        m_column->addWidget(w, w == m_figure ? 1 : 0);
    m_column->addStretch(1); // what the figure leaves is left below
    m_scroll = new QScrollArea;
    m_scroll->setWidget(inside);
    m_scroll->viewport()->installEventFilter(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    auto* page = new QWidget;
    m_hold = button("holdBefore", page, "quiet");
    m_reveal = button("revealPrediction", page, "prominent");
    m_next = button("predictNext", page, "quiet");
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_scroll, 1);
    m_foot = new QVBoxLayout;
    m_foot->addWidget(m_hold);
    m_foot->addWidget(m_reveal);
    m_foot->addWidget(m_next);
    column->addLayout(m_foot);
    connect(m_figure, &PredictFigure::guessed, m_fields, &GuessFields::setVelocities);
    connect(m_fields, &GuessFields::edited, this, [this] {
        m_figure->setGuess(m_fields->prediction().after);
        showWords();
    });
    connect(m_hold, &QPushButton::clicked, this, &PredictPanel::hold);
    connect(m_reveal, &QPushButton::clicked, this,
            [this] { m_state == State::Revealed ? tryAgain() : reveal(); });
    connect(m_next, &QPushButton::clicked, this, &PredictPanel::goOn);
    return page;
}

// Of several that are resolved together each depends on all: none of them follows from its own arrows.
std::optional<std::size_t> PredictPanel::wanted() const {
    const auto collisions = session().timeline().collisions();
    auto index = playhead().selected();
    if (!index)
        index = session().timeline().collisionAfter(playhead().time());
    while (index && *index < collisions.size() && collisions[*index].together > 1)
        ++*index;
    return index && *index < collisions.size() ? index : std::nullopt;
}

void PredictPanel::begin() {
    if (const auto index = wanted())
        open(*index);
}

void PredictPanel::open(std::size_t index) {
    m_run = session().run();
    m_collision = m_run->timeline.collisions()[index];
    m_number = session().part().collisionsBefore + std::int64_t(index) + 1;
    m_holdAt = justBefore(m_run->timeline, index);
    const PairCollision<double>& s = m_collision.steps;
    const double speed = std::max(norm(s.before.first), norm(s.before.second));
    const QString first = bodyName(m_run->scene, m_collision.first);
    const QString second = m_collision.isWall() ? QString() : bodyName(m_run->scene, m_collision.second);
    m_figure->setKnown({s.first, s.second, s.contact, speed, first, second, m_collision.isWall()});
    m_fields->setUp(first, second, m_collision.isWall(), speed);
    m_fields->setVelocities(s.before);
    m_figure->setGuess(s.before);
    m_verdict.reset();
    setState(State::Predicting);
    hold();
    m_figure->setFocus();
}

void PredictPanel::hold() {
    playhead().setPlaying(false);
    playhead().setTime(m_holdAt);
}

void PredictPanel::reveal() {
    if (m_state != State::Predicting || !m_fields->isReadable())
        return;
    m_verdict = judge(m_collision.steps, m_fields->prediction());
    m_figure->reveal(m_collision.steps.after);
    const bool hadFocus = isAncestorOf(window()->focusWidget());
    setState(State::Revealed);
    if (hadFocus) // the fields are gone
        m_next->setFocus();
    playhead().selectNumber(m_number);
    playhead().setStage(Stage::Check); // before and after, side by side
    m_scroll->ensureVisible(0, 0);
}

void PredictPanel::tryAgain() {
    m_verdict.reset();
    m_figure->reveal(std::nullopt);
    setState(State::Predicting);
    hold();
    m_figure->setFocus();
}

void PredictPanel::goOn() {
    const auto collisions = session().timeline().collisions();
    auto index = std::size_t(m_number - session().part().collisionsBefore);
    while (index < collisions.size() && collisions[index].together > 1)
        ++index;
    if (index < collisions.size())
        return open(index);
    drop();
}

// Another run, other collisions.
void PredictPanel::drop() {
    m_run.reset();
    m_verdict.reset();
    setState(State::Invitation);
}

void PredictPanel::setState(State state) {
    m_state = state;
    m_pages->setCurrentIndex(state == State::Invitation ? 0 : 1);
    m_fields->setEditable(state == State::Predicting);
    m_fields->setVisible(state != State::Revealed); // the figure and the words have them then
    showWords();
    tellOthers();
}

// Who is about to predict does not want to see it either.
void PredictPanel::tellOthers() {
    emit predicting(m_state == State::Predicting ||
                    (m_state == State::Invitation && isVisible() && wanted()));
}

void PredictPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    tellOthers();
}

void PredictPanel::hideEvent(QHideEvent* event) {
    Panel::hideEvent(event);
    tellOthers();
}

void PredictPanel::followPlayhead() {
    if (m_state == State::Predicting)
        m_hold->setVisible(playhead().time() >= m_collision.time);
    else
        showInvitation();
}

void PredictPanel::showInvitation() {
    const bool any = wanted().has_value();
    m_invitation->setText(
        any ? tr("What will the collision do? Set the arrows you expect, then reveal.")
            : tr("No collision is left to predict. Go back in time, or change a velocity or a position."));
    setWords(*m_begin,
             playhead().selected() ? tr("Predict this collision") : tr("Predict the next collision"),
             tr("Holds just before the collision and asks what comes of it"));
    m_begin->setVisible(any);
}

void PredictPanel::showWords() {
    showInvitation();
    const bool revealed = m_state == State::Revealed;
    for (QLabel* l : {m_score, m_wrong, m_truth, m_rule})
        l->setVisible(revealed);
    m_hold->setVisible(m_state == State::Predicting && playhead().time() >= m_collision.time);
    m_next->setVisible(revealed);
    setWords(*m_hold, tr("Hold before the collision"),
             tr("The lane has gone past it and shows what happens"));
    setWords(*m_next, tr("Predict the collision after it"), tr("Holds before the next one"));
    setWords(*m_reveal, revealed ? tr("Try again") : tr("Reveal"),
             revealed ? tr("Hides the truth and takes your arrows up again")
                      : tr("Shows what happens beside what you expect"));
    const QString unreadable = m_fields->unreadable();
    m_message->setText(unreadable);
    m_message->setVisible(!unreadable.isEmpty());
    m_reveal->setEnabled(unreadable.isEmpty());
    m_rule->setText(scoreRule());
    if (!m_run)
        return;
    const Scene& scene = m_run->scene;
    const PairCollision<double>& s = m_collision.steps;
    m_title->setText(
        tr("Collision %1: %2 → %3")
            .arg(countText(m_number), bodyName(scene, m_collision.first), partnerName(scene, m_collision)));
    QStringList facts{
        QStringLiteral("%1: %2 kg").arg(bodyName(scene, m_collision.first), numberText(s.first.mass))};
    if (!m_collision.isWall())
        facts << QStringLiteral("%1: %2 kg")
                     .arg(bodyName(scene, m_collision.second), numberText(s.second.mass));
    facts << QStringLiteral("e = %1").arg(numberText(s.restitution));
    m_facts->setText(facts.join(QStringLiteral(" · ")));
    if (revealed)
        showVerdict();
    fit();
}

bool PredictPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_scroll->viewport() && event->type() == QEvent::Resize)
        fit();
    return Panel::eventFilter(watched, event);
}

// The figure gets the room that the words and numbers leave.
void PredictPanel::fit() {
    const QSize room = m_scroll->viewport()->size();
    const int least = m_figure->minimumSizeHint().height();
    m_figure->setFixedHeight(least);
    m_column->invalidate();
    const int height = m_column->totalHeightForWidth(room.width());
    const int spare = std::max(0, room.height() - height);
    m_figure->setFixedHeight(std::min(least + spare, std::max(least, room.width())));
    m_scroll->widget()->resize(room.width(), height + spare);
}

void PredictPanel::showVerdict() {
    m_score->setText(tr("%1 / 100 · %2").arg(m_verdict->score).arg(praise(*m_verdict)));
    QStringList wrong;
    for (const Diagnosis& d : m_verdict->wrong)
        wrong << QStringLiteral("• ") + keptUnits(diagnosisText(m_run->scene, m_collision, d));
    m_wrong->setText(wrong.mid(0, 3).join(u'\n'));
    m_wrong->setVisible(!wrong.isEmpty());
    m_truth->setText(truthText());
}

// Theirs above the truth, number by number.
QString PredictPanel::truthText() const {
    const PairCollision<double>& s = m_collision.steps;
    const Prediction& guess = m_fields->prediction();
    const auto number = [](double v, double of) { return numberText(std::abs(v) < 1e-12 * of ? 0 : v, 3); };
    const double scale = speedScale(s);
    const auto velocity = [&](const Vec2d& v) {
        return QStringLiteral("(%1, %2)").arg(number(v.x, scale), number(v.y, scale));
    };
    QStringList lines;
    const auto compare = [&](const QString& what, const QString& theirs, const QString& truth,
                             const char* unit) {
        lines << QStringLiteral("%1: %2 → %3 %4").arg(what, theirs, truth, QString::fromUtf8(unit));
    };
    compare(bodyName(m_run->scene, m_collision.first), velocity(guess.after.first), velocity(s.after.first),
            "m/s");
    if (!m_collision.isWall())
        compare(bodyName(m_run->scene, m_collision.second), velocity(guess.after.second),
                velocity(s.after.second), "m/s");
    const double energy = energyOf(s, s.before);
    const QString lost = number(s.energyLoss, energy);
    if (guess.energyLost)
        compare(tr("Energy lost"), number(*guess.energyLost, energy), lost, "J");
    else
        lines << QStringLiteral("%1: %2 J").arg(tr("Energy lost"), lost);
    return tr("Expected → truth") + u'\n' + keptUnits(lines.join(u'\n'));
}

void PredictPanel::retranslate() {
    setAccessibleName(tr("Predict, then reveal"));
    showWords();
}

void PredictPanel::restyle() {
    Panel::restyle();
    using Size = Appearance::Size;
    const Appearance& look = appearance();
    const int unit = look.unit();
    m_column->setContentsMargins(2 * unit, unit, 2 * unit, unit);
    m_column->setSpacing(unit / 2);
    m_foot->setContentsMargins(2 * unit, unit / 2, 2 * unit, unit);
    m_foot->setSpacing(unit / 2);
    m_pages->widget(0)->layout()->setContentsMargins(3 * unit, 2 * unit, 3 * unit, 2 * unit);
    m_pages->widget(0)->layout()->setSpacing(2 * unit);
    m_invitation->setFont(look.font(Size::Large));
    m_title->setFont(look.font(Size::Large, true));
    m_facts->setFont(look.font(Size::Normal));
    m_score->setFont(look.font(Size::Large, true));
    m_wrong->setFont(look.font(Size::Normal));
    m_truth->setFont(look.font(Size::Normal));
    makeQuiet(*m_rule, look);
    makeMessage(*m_message, look);
    m_score->setStyleSheet(QStringLiteral("color: %1;").arg(look.accent().name()));
    for (QPushButton* b : {m_begin, m_reveal})
        b->setFont(look.font(Size::Large, true));
    for (QPushButton* b : {m_hold, m_next})
        b->setFont(look.font(Size::Normal));
    m_fields->restyle();
    showWords();
}

} // namespace thetalane
