#include "ui/game/frame_editor.h"

#include "ui/game/game_words.h"
#include "ui/panels/pin_deck.h"
#include "ui/words/game_text.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>

#include <algorithm>

namespace thetalane {
namespace {

bool isEnter(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}

} // namespace

FrameEditor::FrameEditor(const Context& context, Alley& alley, QWidget* window)
    : Panel(context, window)
    , m_alley(alley)
    , m_title(new QLabel(this))
    , m_rolls(new QLineEdit(this))
    , m_hint(new QLabel(this))
    , m_message(new QLabel(this))
    , m_apply(new QPushButton(this))
    , m_cancel(new QPushButton(this)) {
    setObjectName(QStringLiteral("frameEditor"));
    build();
    connect(&alley, &Alley::changed, this, &FrameEditor::follow);
    connect(m_rolls, &QLineEdit::textEdited, this, &FrameEditor::readText);
    connect(m_rolls, &QLineEdit::returnPressed, this, &FrameEditor::apply);
    connect(m_apply, &QPushButton::clicked, this, &FrameEditor::apply);
    connect(m_cancel, &QPushButton::clicked, this, &QWidget::hide);
    restyle();
    retranslate();
    hide();
}

void FrameEditor::build() {
    m_rolls->setObjectName(QStringLiteral("frameRolls"));
    m_message->setObjectName(QStringLiteral("frameMessage"));
    m_apply->setObjectName(QStringLiteral("applyFrame"));
    m_apply->setProperty("prominent", true);
    m_cancel->setObjectName(QStringLiteral("cancelFrame"));
    m_cancel->setProperty("quiet", true);
    m_rolls->setMaxLength(8);
    m_hint->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->addWidget(m_title, 0, 0, 1, mostBalls);
    grid->addWidget(m_rolls, 1, 0, 1, mostBalls);
    grid->addWidget(m_hint, 2, 0, 1, mostBalls);
    for (int ball = 0; ball < mostBalls; ++ball) {
        auto* deck = new PinDeck(appearance(), this);
        deck->setObjectName(QStringLiteral("frameDeck%1").arg(ball + 1));
        deck->setPickable(true);
        connect(deck, &PinDeck::turned, this, [this, ball](int pin) { toggle(ball, pin); });
        m_names[std::size_t(ball)] = new QLabel(this);
        m_decks[std::size_t(ball)] = deck;
        grid->addWidget(m_names[std::size_t(ball)], 3, ball, Qt::AlignHCenter);
        grid->addWidget(deck, 4, ball, Qt::AlignHCenter);
    }
    grid->addWidget(m_message, 5, 0, 1, mostBalls);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_apply);
    grid->addLayout(buttons, 6, 0, 1, mostBalls);
}

void FrameEditor::restyle() {
    Panel::restyle();
    const int unit = appearance().unit();
    layout()->setContentsMargins(2 * unit, 3 * unit / 2, 2 * unit, 3 * unit / 2);
    layout()->setSpacing(unit);
    m_title->setFont(appearance().font(Appearance::Size::Large, true));
    m_rolls->setFont(appearance().font(Appearance::Size::Large));
    for (QPushButton* b : {m_apply, m_cancel})
        b->setFont(appearance().font(Appearance::Size::Normal));
    for (QLabel* name : m_names)
        makeQuiet(*name, appearance());
    for (PinDeck* deck : m_decks) // three side by side
        deck->setFixedSize(deck->minimumSizeHint());
    makeQuiet(*m_hint, appearance());
    makeMessage(*m_message, appearance());
    place();
}

void FrameEditor::retranslate() {
    m_rolls->setAccessibleName(tr("Rolls of the frame"));
    m_rolls->setToolTip(tr("The rolls as they stand on a score sheet"));
    m_hint->setText(tr("X strike, / spare, - none, F foul; or click the pins that fell."));
    m_apply->setText(tr("Correct"));
    m_apply->setAccessibleName(tr("Correct"));
    m_apply->setToolTip(tr("Puts the frame right and marks it as corrected"));
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAccessibleName(tr("Cancel"));
    m_cancel->setToolTip(tr("Leaves the frame as it is (Esc)"));
    if (m_player < m_alley.game().players.size())
        m_title->setText(
            tr("%1, frame %2").arg(playerName(m_alley.game(), m_player), QString::number(m_frame)));
    setAccessibleName(tr("Correction by hand"));
    showDraft();
}

void FrameEditor::edit(std::size_t player, int frame, const QRect& place) {
    const Game& game = m_alley.game();
    const Scorecard card = cardOf(game, player);
    if (frame > int(card.frames().size()))
        return;
    const FrameScore& score = card.frames()[std::size_t(frame - 1)];
    std::vector<Delivery> deliveries;
    for (int k = 0; k < score.count; ++k)
        deliveries.push_back(card.deliveries()[std::size_t(score.first + k)].delivery);
    m_player = player;
    m_frame = frame;
    m_place = place;
    m_draft = FrameDraft(game.rules, frame, std::move(deliveries));
    m_before = game.deliveries[player];
    m_unreadable.reset();
    m_refused.reset();
    m_rolls->setText(m_draft.text());
    retranslate();
    show();
    raise();
    this->place();
    m_rolls->setFocus();
    m_rolls->selectAll();
}

// Below the frame where there is room, and always within the window.
void FrameEditor::place() {
    const QSize size = sizeHint().boundedTo(parentWidget()->size());
    const QSize room = parentWidget()->size() - size;
    const int x = m_place.center().x() - size.width() / 2;
    setGeometry(QRect(QPoint(std::clamp(x, 0, std::max(0, room.width())),
                             std::clamp(m_place.bottom() + 4, 0, std::max(0, room.height()))),
                      size));
}

void FrameEditor::follow() {
    const Game& game = m_alley.game();
    if (isVisible() && (m_player >= game.players.size() || game.deliveries[m_player] != m_before))
        hide();
}

void FrameEditor::readText() {
    m_unreadable = m_draft.setText(m_rolls->text());
    m_refused.reset();
    showDraft();
}

void FrameEditor::toggle(int ball, int pin) {
    m_draft.togglePin(ball, pin);
    m_unreadable.reset();
    m_refused.reset();
    m_rolls->setText(m_draft.text());
    showDraft();
}

void FrameEditor::showDraft() {
    for (int ball = 0; ball < mostBalls; ++ball) {
        const auto k = std::size_t(ball);
        const auto turn = m_draft.turn(ball);
        const bool shown = ball < m_draft.mostBalls();
        m_names[k]->setVisible(shown);
        m_decks[k]->setVisible(shown);
        m_decks[k]->setEnabled(turn && turn->pins);
        const bool thrown = ball < int(m_draft.deliveries().size());
        const Delivery* d = thrown ? &m_draft.deliveries()[k] : nullptr;
        const bool known = turn && turn->pins && (!d || d->down);
        m_names[k]->setText(!d      ? tr("Ball %1").arg(ball + 1)
                            : known ? tr("Ball %1: %2").arg(ball + 1).arg(d->pins)
                                    : tr("Ball %1: %2, pins not known").arg(ball + 1).arg(d->pins));
        m_decks[k]->setTitle(m_names[k]->text());
        const PinSet met = turn && turn->pins ? *turn->pins : PinSet{};
        m_decks[k]->setPresent(met);
        m_decks[k]->setStanding(d && d->down ? met & ~*d->down : met);
    }
    showMessage();
    if (isVisible())
        place();
}

void FrameEditor::showMessage() {
    m_message->setText(m_unreadable ? rollsFaultText(*m_unreadable)
                       : m_refused  ? gameErrorMessage(*m_refused)
                                    : QString());
    m_message->setVisible(!m_message->text().isEmpty());
    m_apply->setEnabled(!m_unreadable && !m_draft.deliveries().empty());
}

void FrameEditor::apply() {
    if (!m_apply->isEnabled())
        return;
    m_refused = m_alley.correct(m_player, m_frame, m_draft.deliveries());
    if (!m_refused)
        return hide();
    showMessage();
    place();
}

void FrameEditor::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(appearance().accent(), appearance().projector() ? 3 : 2));
    painter.setBrush(appearance().card());
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), 6, 6);
}

void FrameEditor::keyPressEvent(QKeyEvent* event) {
    if (!isVisible()) // a field's Enter, after it closed the editor
        return event->accept();
    if (event->key() == Qt::Key_Escape || (isEnter(event->key()) && m_cancel->hasFocus()))
        return hide();
    if (isEnter(event->key()))
        return apply();
    Panel::keyPressEvent(event);
}

// Esc is the window's as well, and Enter the game's: here they are the editor's.
bool FrameEditor::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || isEnter(key)) {
            event->accept();
            return true;
        }
    }
    return Panel::event(event);
}

} // namespace thetalane
