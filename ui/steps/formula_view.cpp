#include "ui/steps/formula_view.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace thetalane {
namespace {

constexpr double widestLeft = 0.3;       // of the view; longer left sides get a row of their own
constexpr double slightlySmaller = 0.88; // rather than a break
constexpr double smallestScale = 0.7;

int formulaPixels(const Appearance& appearance) {
    return appearance.pixels(Appearance::Size::Normal) + (appearance.projector() ? 2 : 1);
}

} // namespace

FormulaView::FormulaView(const Appearance& appearance, QWidget* parent)
    : QWidget(parent)
    , m_appearance(appearance) {
    setObjectName("formulaView");
    setMouseTracking(true);
    setFocusPolicy(Qt::ClickFocus);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&appearance, &Appearance::changed, this, [this] {
        m_sheet = {};
        updateGeometry();
        update();
    });
    retranslate();
}

void FormulaView::retranslate() {
    setAccessibleName(tr("Formulas of this step"));
    setAccessibleDescription(textOf({}));
}

void FormulaView::setLines(std::vector<WorkedLine> lines) {
    m_lines = std::move(lines);
    m_sheet = {};
    m_hovered.reset();
    setAccessibleDescription(textOf({}));
    updateGeometry();
    update();
}

int FormulaView::heightForWidth(int width) const {
    return int(std::ceil(sheetFor(width).height));
}

QSize FormulaView::sizeHint() const {
    const int width = 40 * formulaPixels(m_appearance) / 2;
    return {width, heightForWidth(width)};
}

QSize FormulaView::minimumSizeHint() const {
    return {120, formulaPixels(m_appearance)};
}

const FormulaView::Sheet& FormulaView::sheetFor(int width) const {
    if (m_sheet.width != width)
        m_sheet = layOut(width);
    return m_sheet;
}

FormulaView::Sheet FormulaView::layOut(int width) const {
    const FormulaLayout layout(m_appearance, formulaPixels(m_appearance));
    double equals = 0;
    for (const WorkedLine& line : m_lines) {
        const double left = layout.box(line.left).width;
        if (left <= widestLeft * width)
            equals = std::max(equals, left);
    }
    Sheet sheet;
    sheet.width = width;
    double y = 0;
    const double gap = 0.75 * layout.pixelSize();
    for (const WorkedLine& line : m_lines) {
        Block block;
        block.top = y;
        y = layLine(line, equals, width, y + gap / 2, block) + gap / 2;
        block.bottom = y;
        sheet.blocks.push_back(std::move(block));
    }
    sheet.height = y;
    return sheet;
}

// Whole if it fits, perhaps a little smaller; then broken; then smaller still.
FormulaBox FormulaView::fitted(const Formula& f, double room) const {
    const int usual = formulaPixels(m_appearance);
    for (int size = usual; size >= slightlySmaller * usual; --size)
        if (FormulaBox box = FormulaLayout(m_appearance, size).box(f); box.width <= room)
            return box;
    FormulaBox box;
    for (int size = usual; size >= smallestScale * usual; --size) {
        box = FormulaLayout(m_appearance, size).box(f, room);
        if (box.width <= room)
            break;
    }
    return box;
}

// One worked line: on one row if it fits; otherwise symbols, numbers and result on rows of their own, the
// result beside the numbers where there is room.
double FormulaView::layLine(const WorkedLine& line, double equals, double width, double top,
                            Block& block) const {
    const FormulaLayout layout(m_appearance, formulaPixels(m_appearance));
    const FormulaBox left = layout.box(line.left);
    const FormulaBox sign = layout.text(QStringLiteral("="), false, Ink::Plain);
    const double space = layout.relationSpace();
    const double start = equals + 2 * space + sign.width;
    const double room = width - start - 1;

    std::vector<FormulaBox> parts;
    double whole = -space;
    for (const Formula* f : {&line.symbolic, &line.substituted, &line.result}) {
        if (isEmpty(*f))
            continue;
        FormulaBox box = fitted(*f, room);
        whole += box.width + (parts.empty() ? space : 3 * space + sign.width);
        parts.push_back(std::move(box));
    }

    std::vector<FormulaBox> rows;
    FormulaBox current; // its origin is where parts start, right of the aligned equals signs
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double joined = current.width + 2 * space + sign.width + parts[i].width;
        const bool joins =
            i > 0 && !parts[i - 1].broken && (whole <= room || (i + 1 == parts.size() && joined <= room));
        if (i > 0 && !joins) {
            rows.push_back(std::move(current));
            current = {};
        }
        if (joins) {
            current.add(sign, {current.width + space, 0});
            current.add(parts[i], {joined - parts[i].width, 0});
            current.width = joined;
        } else {
            current.add(sign, {-space - sign.width, 0});
            current.add(parts[i], {0, 0});
            current.width = parts[i].width;
        }
    }
    rows.push_back(std::move(current));

    const bool leftAlone = left.width > equals;
    double y = top;
    if (leftAlone) {
        const double ascent = std::max(left.ascent, layout.strut());
        block.rows.push_back({{0, y + ascent}, left});
        y += ascent + left.descent + 0.35 * layout.pixelSize();
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool withLeft = i == 0 && !leftAlone;
        const double ascent = std::max({rows[i].ascent, layout.strut(), withLeft ? left.ascent : 0});
        const double descent = std::max(rows[i].descent, withLeft ? left.descent : 0);
        if (withLeft)
            block.rows.push_back({{equals - left.width, y + ascent}, left});
        block.rows.push_back({{start, y + ascent}, rows[i]});
        const double gap = descent > 0.5 * layout.pixelSize() ? 0.6 : 0.35; // more below a fraction
        y += ascent + descent + (i + 1 < rows.size() ? gap * layout.pixelSize() : 0);
    }
    return y;
}

std::vector<QRectF> FormulaView::inkRectsAt(int width) const {
    std::vector<QRectF> rects;
    for (const Block& block : sheetFor(width).blocks)
        for (const Placed& placed : block.rows)
            for (const QRectF& rect : inkRects(placed.box, placed.baseline))
                rects.push_back(rect);
    return rects;
}

void FormulaView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Sheet& sheet = sheetFor(width());
    for (std::size_t i = 0; i < sheet.blocks.size(); ++i) {
        const Block& block = sheet.blocks[i];
        if (m_hovered == i)
            painter.fillRect(QRectF(0, block.top, width(), block.bottom - block.top), m_appearance.window());
        for (const Placed& placed : block.rows)
            paintFormula(painter, placed.box, placed.baseline, m_appearance);
    }
}

std::optional<std::size_t> FormulaView::lineAt(QPointF position) const {
    const Sheet& sheet = sheetFor(width());
    for (std::size_t i = 0; i < sheet.blocks.size(); ++i)
        if (position.y() >= sheet.blocks[i].top && position.y() < sheet.blocks[i].bottom)
            return i;
    return std::nullopt;
}

QString FormulaView::textOf(std::optional<std::size_t> line) const {
    if (line)
        return plainText(m_lines[*line], Digits::All);
    QStringList all;
    for (const WorkedLine& each : m_lines)
        all << plainText(each, Digits::All);
    return all.join('\n');
}

void FormulaView::copy() const {
    QGuiApplication::clipboard()->setText(textOf(m_hovered));
}

bool FormulaView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const auto line = lineAt(help->pos()))
        QToolTip::showText(help->globalPos(), textOf(line), this);
    else
        QToolTip::hideText();
    return true;
}

void FormulaView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void FormulaView::mouseMoveEvent(QMouseEvent* event) {
    const auto line = lineAt(event->position());
    if (line == m_hovered)
        return;
    m_hovered = line;
    update();
}

void FormulaView::leaveEvent(QEvent*) {
    m_hovered.reset();
    update();
}

void FormulaView::contextMenuEvent(QContextMenuEvent* event) {
    const auto line = lineAt(event->pos());
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto put = [this](std::optional<std::size_t> which) {
        QGuiApplication::clipboard()->setText(textOf(which));
    };
    QAction* one = menu->addAction(tr("Copy this line"), this, [put, line] { put(line); });
    one->setEnabled(line.has_value());
    menu->addAction(tr("Copy all lines"), this, [put] { put({}); });
    menu->popup(event->globalPos());
}

void FormulaView::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Copy))
        copy();
    else
        QWidget::keyPressEvent(event);
}

} // namespace thetalane
