#include "ui/game/score_table.h"

#include "ui/game/game_words.h"

#include <QAccessible>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace thetalane {

ScoreTable::ScoreTable(const Context& context, Alley& alley, QWidget* parent)
    : QWidget(parent)
    , m_context(context)
    , m_alley(alley) {
    setObjectName(QStringLiteral("scoreSheetTable"));
    setFocusPolicy(Qt::TabFocus); // a click leaves the keys to the lane
    setMouseTracking(true);
    connect(&alley, &Alley::changed, this, &ScoreTable::adopt);
    connect(&context.appearance, &Appearance::changed, this, [this] {
        updateGeometry();
        update();
    });
    adopt();
    retranslate();
}

void ScoreTable::retranslate() {
    setAccessibleName(tr("Score sheet"));
    describe();
    update();
}

void ScoreTable::adopt() {
    const Game& game = m_alley.shown();
    const bool moreRows = m_cards.size() != game.players.size();
    m_cards.clear();
    for (std::size_t k = 0; k < game.players.size(); ++k)
        m_cards.push_back(cardOf(game, k));
    if (m_cursor.player >= m_cards.size())
        m_cursor = {};
    if (const auto turn = m_alley.turn(); turn && !hasFocus())
        m_cursor = {turn->player, turn->turn.frame - 1, std::nullopt};
    m_hovered.reset();
    if (moreRows)
        updateGeometry();
    describe();
    update();
}

SheetLayout ScoreTable::sheetLayout() const {
    return {m_context.appearance, m_alley.shown().rules, m_cards.size(), width()};
}

QSize ScoreTable::sizeHint() const {
    return {SheetLayout::leastWidth(m_context.appearance, m_alley.shown().rules), sheetLayout().height()};
}

QSize ScoreTable::minimumSizeHint() const {
    return sizeHint();
}

void ScoreTable::setTop(int top) {
    m_top = top;
    update();
}

SheetContent ScoreTable::content() const {
    SheetContent c{m_alley.shown(), m_cards,     m_alley.turn(),
                   std::nullopt,    m_hovered,   std::nullopt,
                   tr("Player"),    tr("Total"), tr("max %1", "the highest possible score")};
    if (hasFocus())
        c.cursor = m_cursor;
    if (const auto replayed = m_alley.replayed(); replayed && replayed->player < m_cards.size()) {
        const Scorecard& card = m_cards[replayed->player];
        const Turn& turn = card.deliveries()[replayed->delivery].turn;
        const bool alone =
            card.deliveries()[replayed->delivery].strike && sheetLayout().rollCount(turn.frame - 1) == 2;
        c.replayed = SheetPlace{replayed->player, turn.frame - 1, alone ? 1 : turn.ball - 1};
    }
    return c;
}

void ScoreTable::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const SheetLayout layout = sheetLayout();
    const SheetContent now = content();
    paintSheet(painter, layout, now, m_context.appearance);
    if (!m_cards.empty())
        paintSheetHeader(painter, layout, now, m_context.appearance, m_top);
}

bool ScoreTable::isPlayed(const SheetPlace& place) const {
    return place.player < m_cards.size() && place.frame < int(m_cards[place.player].frames().size());
}

bool ScoreTable::canReplay(const DeliveryPlace& place) const {
    return m_alley.shown().deliveries[place.player][place.delivery].thrown.has_value();
}

bool ScoreTable::replayRoll(std::size_t player, int frame, int roll) {
    const auto delivery = deliveryAt(m_cards[player], frame, roll, sheetLayout().rollCount(frame));
    if (!delivery || !canReplay({player, *delivery}))
        return false;
    emit replayAsked({player, *delivery});
    return true;
}

// A roll that was thrown is shown again; all else of a frame that was played opens the correction.
void ScoreTable::press(const SheetPlace& place) {
    m_cursor = {place.player, place.frame, std::nullopt};
    describe();
    update();
    if (!isPlayed(place) || (place.roll && replayRoll(place.player, place.frame, *place.roll)))
        return;
    emit correctionAsked(place.player, place.frame + 1);
}

void ScoreTable::mousePressEvent(QMouseEvent* event) {
    const auto place = sheetLayout().at(event->position());
    if (event->button() == Qt::LeftButton && place)
        press(*place);
}

void ScoreTable::mouseMoveEvent(QMouseEvent* event) {
    auto place = sheetLayout().at(event->position());
    if (place && !isPlayed(*place))
        place.reset();
    setCursor(place ? Qt::PointingHandCursor : Qt::ArrowCursor);
    if (place == m_hovered)
        return;
    m_hovered = place;
    update();
}

void ScoreTable::leaveEvent(QEvent* event) {
    m_hovered.reset();
    update();
    QWidget::leaveEvent(event);
}

bool ScoreTable::moveCursor(int key) {
    SheetPlace to = m_cursor;
    const int player = int(m_cursor.player);
    switch (key) {
    case Qt::Key_Left:
        to.frame = std::max(0, to.frame - 1);
        break;
    case Qt::Key_Right:
        to.frame = std::min(framesOfAGame - 1, to.frame + 1);
        break;
    case Qt::Key_Home:
        to.frame = 0;
        break;
    case Qt::Key_End:
        to.frame = framesOfAGame - 1;
        break;
    case Qt::Key_Up:
        to.player = std::size_t(std::max(0, player - 1));
        break;
    case Qt::Key_Down:
        to.player = std::size_t(std::min(int(m_cards.size()) - 1, player + 1));
        break;
    default:
        return false;
    }
    m_cursor = to;
    describe();
    update();
    emit cursorMoved(sheetLayout().frame(to.player, to.frame));
    return true;
}

bool ScoreTable::usesKey(const QKeyEvent& event) const {
    static constexpr int keys[] = {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Home,
                                   Qt::Key_End,  Qt::Key_F2,    Qt::Key_1,  Qt::Key_2,    Qt::Key_3};
    return (event.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier &&
           std::find(std::begin(keys), std::end(keys), event.key()) != std::end(keys);
}

void ScoreTable::keyPressEvent(QKeyEvent* event) {
    if (m_cards.empty() || !usesKey(*event))
        return QWidget::keyPressEvent(event);
    if (event->key() == Qt::Key_F2) {
        if (isPlayed(m_cursor))
            emit correctionAsked(m_cursor.player, m_cursor.frame + 1);
    } else if (!moveCursor(event->key())) {
        replayRoll(m_cursor.player, m_cursor.frame, event->key() - Qt::Key_1);
    }
}

// The window's shortcuts give way to the keys that the sheet uses; help is of the frame pointed at.
bool ScoreTable::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && usesKey(*static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const auto place = sheetLayout().at(help->pos());
        if (place && isPlayed(*place))
            QToolTip::showText(help->globalPos(),
                               frameText(m_alley.shown(), place->player, place->frame + 1) + u'\n' +
                                   tr("Click a roll to see it again, the total to correct the frame (F2)"));
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

void ScoreTable::contextMenuEvent(QContextMenuEvent* event) {
    if (m_cards.empty())
        return;
    const bool byMouse = event->reason() == QContextMenuEvent::Mouse;
    const SheetLayout layout = sheetLayout();
    const auto place = byMouse ? layout.at(event->pos()) : std::optional(m_cursor);
    if (place && isPlayed(*place))
        openMenu(*place, byMouse
                             ? event->globalPos()
                             : mapToGlobal(layout.frame(place->player, place->frame).bottomLeft().toPoint()));
}

void ScoreTable::openMenu(const SheetPlace& place, const QPoint& at) {
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("frameMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setFont(m_context.appearance.font(Appearance::Size::Normal));
    const FrameScore& frame = m_cards[place.player].frames()[std::size_t(place.frame)];
    for (int k = 0; k < frame.count; ++k) {
        const DeliveryPlace delivery{place.player, std::size_t(frame.first + k)};
        QAction* action = menu->addAction(tr("See ball %1 again").arg(k + 1),
                                          [this, delivery] { emit replayAsked(delivery); });
        action->setEnabled(canReplay(delivery));
    }
    menu->addSeparator();
    menu->addAction(tr("Correct this frame…"),
                    [this, place] { emit correctionAsked(place.player, place.frame + 1); });
    menu->popup(at);
}

void ScoreTable::describe() {
    if (m_cards.empty())
        return setAccessibleDescription({});
    const QString text = frameText(m_alley.shown(), m_cursor.player, m_cursor.frame + 1);
    if (text == accessibleDescription())
        return;
    setAccessibleDescription(text);
    QAccessibleEvent event(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&event);
}

void ScoreTable::focusInEvent(QFocusEvent* event) {
    update();
    QWidget::focusInEvent(event);
}

void ScoreTable::focusOutEvent(QFocusEvent* event) {
    update();
    QWidget::focusOutEvent(event);
}

} // namespace thetalane
