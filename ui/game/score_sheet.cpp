#include "ui/game/score_sheet.h"

#include "ui/game/frame_editor.h"
#include "ui/game/score_table.h"
#include "ui/words/glossary.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>

#include <algorithm>

namespace thetalane {
namespace {

// Whether a widget with the focus has a use for Enter itself.
bool usesEnter(const QWidget* w) {
    for (const QWidget* p = w; p; p = p->parentWidget())
        if (qobject_cast<const FrameEditor*>(p))
            return true;
    return qobject_cast<const QLineEdit*>(w) || qobject_cast<const QAbstractItemView*>(w) ||
           qobject_cast<const QComboBox*>(w) || qobject_cast<const QAbstractSpinBox*>(w);
}

} // namespace

ScoreSheet::ScoreSheet(const Context& context, Alley& alley, QWidget* parent)
    : Panel(context, parent)
    , m_context(context)
    , m_alley(alley)
    , m_scroll(new QScrollArea(this))
    , m_table(new ScoreTable(context, alley)) {
    setObjectName(QStringLiteral("scoreSheet"));
    setTerm(this, "frame");
    m_scroll->setWidget(m_table);
    m_scroll->setWidgetResizable(true);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setFocusPolicy(Qt::NoFocus);
    connect(m_scroll->verticalScrollBar(), &QScrollBar::valueChanged, m_table, &ScoreTable::setTop);
    connect(m_table, &ScoreTable::replayAsked, &alley, &Alley::replay);
    connect(m_table, &ScoreTable::correctionAsked, this, &ScoreSheet::correct);
    connect(m_table, &ScoreTable::cursorMoved, this, &ScoreSheet::bringIntoView);
    connect(&alley, &Alley::changed, this, &ScoreSheet::adopt);
    addShortcuts();
    restyle();
    retranslate();
    adopt();
}

void ScoreSheet::addShortcuts() {
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Enter}) {
        auto* shortcut = new QShortcut(key, this);
        shortcut->setAutoRepeat(false); // a key held down is no second throw
        connect(shortcut, &QShortcut::activated, &m_alley, &Alley::goOn);
        connect(qApp, &QApplication::focusChanged, shortcut,
                [shortcut](QWidget*, QWidget* now) { shortcut->setEnabled(!usesEnter(now)); });
    }
}

void ScoreSheet::retranslate() {
    setAccessibleName(tr("Score sheet"));
    m_table->retranslate();
}

void ScoreSheet::restyle() {
    Panel::restyle();
    fit();
}

void ScoreSheet::adopt() {
    fit();
    setVisible(m_alley.isOn());
    // Once the rows have the places that they will have.
    QMetaObject::invokeMethod(this, &ScoreSheet::bringTurnIntoView, Qt::QueuedConnection);
}

void ScoreSheet::resizeEvent(QResizeEvent* event) {
    Panel::resizeEvent(event);
    m_scroll->setGeometry(rect()); // at once: the row of now is then brought into view
    fit();
    QMetaObject::invokeMethod(this, &ScoreSheet::bringTurnIntoView, Qt::QueuedConnection);
}

// As high as its rows, up to four of them (three for a projector); a bar to scroll sideways has its own room.
void ScoreSheet::fit() {
    const int most = appearance().projector() ? 3 : 4;
    const int rows = std::clamp(int(m_alley.shown().players.size()), 1, most);
    const int wide = SheetLayout::leastWidth(appearance(), m_alley.shown().rules);
    const int bar = width() < wide ? m_scroll->horizontalScrollBar()->sizeHint().height() : 0;
    setFixedHeight(SheetLayout::headerHeight(appearance()) + rows * SheetLayout::rowHeight(appearance()) + 1 +
                   bar);
}

// By whole rows: none stands half under the header.
void ScoreSheet::bringIntoView(const QRectF& frame) {
    const int header = SheetLayout::headerHeight(appearance()), row = SheetLayout::rowHeight(appearance());
    const int shown = std::max(1, (m_scroll->viewport()->height() - header) / row);
    const int wanted = (int(frame.top()) - header) / row;
    QScrollBar* bar = m_scroll->verticalScrollBar();
    bar->setSingleStep(row);
    bar->setValue(std::clamp((bar->value() + row / 2) / row, wanted - shown + 1, wanted) * row);
    m_scroll->ensureVisible(int(frame.center().x()), bar->value() + header + 1, int(frame.width()), 0);
}

void ScoreSheet::bringTurnIntoView() {
    m_scroll->setGeometry(rect()); // a height that was fitted while hidden comes without an event of its own
    if (const auto turn = m_alley.turn(); turn && !m_table->hasFocus())
        bringIntoView(m_table->sheetLayout().frame(turn->player, turn->turn.frame - 1));
}

void ScoreSheet::correct(std::size_t player, int frame) {
    m_alley.tellScore(); // what is corrected is what was thrown, all of it
    if (!m_editor)
        m_editor = new FrameEditor(m_context, m_alley, window());
    const QRectF place = m_table->sheetLayout().frame(player, frame - 1);
    const QRect inWindow(m_table->mapTo(window(), place.topLeft().toPoint()), place.size().toSize());
    m_editor->edit(player, frame, inWindow);
}

} // namespace thetalane
