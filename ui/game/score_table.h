// The rows of a score sheet, as a widget: painted, pointed at, and gone through by the arrow keys.
#pragma once

#include "ui/context.h"
#include "ui/game/alley.h"
#include "ui/game/sheet_painting.h"

#include <QWidget>

class QMenu;

namespace thetalane {

class ScoreTable : public QWidget {
    Q_OBJECT
public:
    ScoreTable(const Context& context, Alley& alley, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    SheetLayout sheetLayout() const;
    void setTop(int top); // where the part that is seen begins: there stands the header
    void retranslate();

signals:
    void replayAsked(const thetalane::DeliveryPlace& place);
    void correctionAsked(std::size_t player, int frame); // from 1
    void cursorMoved(const QRectF& frame);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    bool event(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void adopt();
    void press(const SheetPlace& place);
    bool replayRoll(std::size_t player, int frame, int roll);
    bool moveCursor(int key);
    void describe();
    bool isPlayed(const SheetPlace& place) const;
    bool canReplay(const DeliveryPlace& place) const;
    bool usesKey(const QKeyEvent& event) const;
    void openMenu(const SheetPlace& place, const QPoint& at);
    SheetContent content() const;

    Context m_context;
    Alley& m_alley;
    std::vector<Scorecard> m_cards;
    SheetPlace m_cursor;
    std::optional<SheetPlace> m_hovered;
    int m_top = 0;
};

} // namespace thetalane
