// The lines of one worked step, aligned at their equals signs and broken to the width there is. Hovering
// shows all digits, Ctrl+C and the menu copy them.
#pragma once

#include "ui/steps/formula_layout.h"
#include "ui/words/worked_steps.h"

#include <QWidget>

#include <optional>

namespace thetalane {

class FormulaView : public QWidget {
    Q_OBJECT
public:
    explicit FormulaView(const Appearance& appearance, QWidget* parent = nullptr);

    void setLines(std::vector<WorkedLine> lines);
    const std::vector<WorkedLine>& lines() const { return m_lines; }

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    // Every glyph and stroke as painted at this width, in pixels of the widget: for tests.
    std::vector<QRectF> inkRectsAt(int width) const;

    void retranslate();

public slots:
    void copy() const; // the line under the pointer, or all of them; all digits

protected:
    void paintEvent(QPaintEvent*) override;
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Placed {
        QPointF baseline;
        FormulaBox box;
    };
    struct Block { // one worked line
        double top = 0;
        double bottom = 0;
        std::vector<Placed> rows;
    };
    struct Sheet {
        int width = 0;
        double height = 0;
        std::vector<Block> blocks;
    };
    const Sheet& sheetFor(int width) const;
    Sheet layOut(int width) const;
    FormulaBox fitted(const Formula& formula, double room) const;
    double layLine(const WorkedLine& line, double equals, double width, double top, Block& block) const;
    std::optional<std::size_t> lineAt(QPointF position) const;
    QString textOf(std::optional<std::size_t> line) const;

    const Appearance& m_appearance;
    std::vector<WorkedLine> m_lines;
    mutable Sheet m_sheet;
    std::optional<std::size_t> m_hovered;
};

} // namespace thetalane
