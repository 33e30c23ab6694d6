#include "ui/steps/formula_layout.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

using Kind = Formula::Kind;
const QString prime = QStringLiteral("′");

bool isRelation(const Formula& f) {
    static const QStringList relations{"=", "≤", "≥", "<", ">", "≈"};
    return f.kind == Kind::Operator && relations.contains(f.text);
}

// A half stands small beside its factors.
bool isSmallFraction(const Formula& f) {
    return std::all_of(f.parts.begin(), f.parts.end(), [](const Formula& part) {
        return part.kind == Kind::Number && part.text.size() == 1;
    });
}

FormulaItem filled(QPainterPath path) {
    return {{}, {}, {}, std::move(path), Ink::Plain};
}

QPainterPath stroked(const QPainterPath& path, double width) {
    QPainterPathStroker stroker;
    stroker.setWidth(width);
    stroker.setJoinStyle(Qt::MiterJoin);
    return stroker.createStroke(path);
}

// One parenthesis, thin at its ends: the space between two arcs.
QPainterPath parenthesis(double x, double top, double bottom, double bulge, double weight) {
    const double middle = (top + bottom) / 2;
    QPainterPath path(QPointF(x, top));
    path.quadTo(QPointF(x - bulge - weight, middle), QPointF(x, bottom));
    path.quadTo(QPointF(x - bulge + weight, middle), QPointF(x, top));
    return path;
}

} // namespace

void FormulaBox::add(const FormulaBox& box, QPointF at) {
    for (FormulaItem item : box.items) {
        item.position += at;
        item.path.translate(at);
        items.push_back(std::move(item));
    }
    ascent = std::max(ascent, box.ascent - at.y());
    descent = std::max(descent, box.descent + at.y());
}

FormulaLayout::FormulaLayout(const Appearance& appearance, int pixelSize)
    : m_appearance(appearance)
    , m_size(pixelSize) {}

FormulaLayout FormulaLayout::smaller() const {
    return FormulaLayout(m_appearance, std::max(8, int(std::lround(m_size * 0.72))));
}

double FormulaLayout::stroke() const {
    return std::max(1.0, 0.065 * m_size);
}

double FormulaLayout::axis() const {
    const QRectF minus =
        QFontMetricsF(m_appearance.formulaFont(m_size, false)).tightBoundingRect(QStringLiteral("−"));
    return -minus.center().y();
}

FormulaBox FormulaLayout::text(const QString& text, bool italic, Ink ink) const {
    if (text.isEmpty())
        return {};
    const QFont font = m_appearance.formulaFont(m_size, italic);
    const QFontMetricsF metrics(font);
    const QRectF tight = metrics.tightBoundingRect(text);
    FormulaBox box;
    box.width = std::max(metrics.horizontalAdvance(text), tight.right());
    box.ascent = std::max(0.0, -tight.top());
    box.descent = std::max(0.0, tight.bottom());
    box.items.push_back({{}, text, font, {}, ink});
    return box;
}

// A prime is drawn: a font's own is too faint in an index. It never gets smaller than the eye can see.
FormulaBox FormulaLayout::primes(int count, Ink ink) const {
    const double tall = std::max(0.36 * m_size, 4.6);
    const double thick = std::max(0.1 * m_size, 1.6);
    const double top = -0.82 * m_size;
    FormulaBox box;
    for (int i = 0; i < count; ++i) {
        const double x = box.width + 0.06 * m_size;
        QPainterPath path(QPointF(x, top + tall));
        path.lineTo(x + 0.45 * tall, top);
        path.lineTo(x + 0.45 * tall + thick, top + 0.1 * tall);
        path.lineTo(x + 0.4 * thick, top + tall);
        path.closeSubpath();
        box.items.push_back({{}, {}, {}, path, ink});
        box.width = x + 0.45 * tall + thick;
    }
    box.ascent = -top;
    return box;
}

// A symbol with its primes: the letter slants.
FormulaBox FormulaLayout::letters(const QString& text, bool italic, Ink ink) const {
    const auto at = italic ? text.indexOf(prime) : -1;
    if (at < 0)
        return this->text(text, italic, ink);
    FormulaBox box;
    if (at > 0)
        box = this->text(text.left(at), true, ink);
    const FormulaBox marks = primes(int(text.size() - at), ink);
    const double x = box.width;
    box.add(marks, {x, 0});
    box.width = x + marks.width;
    return box;
}

double FormulaLayout::spaceBetween(const Formula& left, const Formula& right, bool leftUnary) const {
    const auto around = [&](const Formula& o) {
        return isRelation(o) ? relationSpace() : o.text == "·" ? 0.14 * m_size : 0.26 * m_size;
    };
    if (right.kind == Kind::Operator)
        return right.text == "," ? 0 : around(right);
    if (left.kind == Kind::Operator)
        return leftUnary ? 0.06 * m_size : around(left);
    if (right.text == "°")
        return 0;
    const bool word = left.kind == Kind::Upright || right.kind == Kind::Upright || right.kind == Kind::Row;
    return (word ? 0.2 : 0.12) * m_size;
}

FormulaBox FormulaLayout::row(const std::vector<Formula>& parts) const {
    FormulaBox box;
    const Formula* last = nullptr;
    bool lastUnary = false;
    for (const Formula& part : parts) {
        if (isEmpty(part))
            continue;
        const bool unary =
            part.kind == Kind::Operator && part.text != "+" && (!last || last->kind == Kind::Operator);
        if (last)
            box.width += spaceBetween(*last, part, lastUnary);
        const FormulaBox inner = this->box(part);
        box.add(inner, {box.width, 0});
        box.width += inner.width;
        last = &part;
        lastUnary = unary;
    }
    return box;
}

// Letters of an index stand close: no spaces but after a comma.
FormulaBox FormulaLayout::index(const Formula& f) const {
    if (f.kind != Kind::Row)
        return box(f);
    FormulaBox result;
    for (const Formula& part : f.parts) {
        const FormulaBox inner = index(part);
        result.add(inner, {result.width, 0});
        result.width += inner.width + 0.05 * m_size;
    }
    return result;
}

FormulaBox FormulaLayout::fraction(const FormulaBox& above, const FormulaBox& below) const {
    const double pad = 0.14 * m_size;
    const double gap = 0.2 * m_size;
    const double bar = stroke();
    FormulaBox box;
    box.width = std::max(above.width, below.width) + 2 * pad;
    box.add(above, {(box.width - above.width) / 2, -axis() - bar / 2 - gap - above.descent});
    box.add(below, {(box.width - below.width) / 2, -axis() + bar / 2 + gap + below.ascent});
    QPainterPath line;
    line.addRect(QRectF(pad / 2, -axis() - bar / 2, box.width - pad, bar));
    box.items.push_back(filled(line));
    return box;
}

FormulaBox FormulaLayout::root(const FormulaBox& under) const {
    const double gap = 0.16 * m_size;
    const double bar = stroke();
    const double top = -std::max(under.ascent, strut()) - gap;
    const double bottom = under.descent + 0.06 * m_size;
    const double sign = 0.62 * m_size;
    FormulaBox box;
    box.add(under, {sign + 0.08 * m_size, 0});
    box.width = sign + under.width + 0.2 * m_size;
    QPainterPath tick(QPointF(0.05 * m_size, bottom + 0.36 * (top - bottom)));
    tick.lineTo(0.17 * m_size, bottom + 0.42 * (top - bottom));
    QPainterPath down(tick.currentPosition());
    down.lineTo(0.34 * m_size, bottom);
    QPainterPath up(down.currentPosition());
    up.lineTo(sign, top);
    up.lineTo(box.width, top);
    for (const auto& [path, width] : {std::pair{tick, bar}, {down, 1.9 * bar}, {up, bar}})
        box.items.push_back(filled(stroked(path, width)));
    box.ascent = std::max(box.ascent, -top + bar);
    box.descent = std::max(box.descent, bottom + bar);
    return box;
}

FormulaBox FormulaLayout::group(const FormulaBox& inner) const {
    const bool tall = inner.ascent > 0.95 * m_size || inner.descent > 0.4 * m_size;
    FormulaBox box;
    if (!tall) {
        const FormulaBox open = text(QStringLiteral("("), false, Ink::Plain);
        const FormulaBox close = text(QStringLiteral(")"), false, Ink::Plain);
        box.add(open, {0, 0});
        box.add(inner, {open.width, 0});
        box.add(close, {open.width + inner.width, 0});
        box.width = open.width + inner.width + close.width;
        return box;
    }
    const double side = 0.34 * m_size;
    const double reach = std::max(inner.ascent - axis(), inner.descent + axis()) + 0.05 * m_size;
    QPainterPath open =
        parenthesis(side * 0.85, -axis() - reach, -axis() + reach, 0.4 * m_size, 0.055 * m_size);
    box.add(inner, {side, 0});
    box.width = inner.width + 2 * side;
    box.items.push_back(filled(open));
    box.items.push_back(filled(QTransform(-1, 0, 0, 1, box.width, 0).map(open)));
    box.ascent = std::max(box.ascent, reach + axis());
    box.descent = std::max(box.descent, reach - axis());
    return box;
}

FormulaBox FormulaLayout::script(const Formula& f) const {
    FormulaBox box = this->box(f.parts[0]);
    const FormulaLayout low = smaller();
    const double start = box.width + 0.02 * m_size;
    const double baseAscent = box.ascent;
    const double baseDescent = box.descent;
    const bool tall = baseAscent > 1.1 * m_size;
    if (!isEmpty(f.parts[1])) {
        const FormulaBox sub = low.index(f.parts[1]);
        box.add(sub, {start, std::max(0.24 * m_size, baseDescent - 0.05 * m_size)});
        box.width = std::max(box.width, start + sub.width);
    }
    if (!isEmpty(f.parts[2])) {
        const bool isPrime = f.parts[2].text == prime;
        const FormulaBox super = isPrime ? letters(prime, true, f.parts[0].ink) : low.index(f.parts[2]);
        const double up = isPrime ? 0.06 * m_size : tall ? baseAscent - 0.4 * m_size : 0.4 * m_size;
        box.add(super, {start + 0.04 * m_size, -up});
        box.width = std::max(box.width, start + 0.04 * m_size + super.width);
    }
    return box;
}

FormulaBox FormulaLayout::box(const Formula& f) const {
    switch (f.kind) {
    case Kind::Row:
        return row(f.parts);
    case Kind::Symbol:
        return letters(f.text, true, f.ink);
    case Kind::Upright:
    case Kind::Number:
    case Kind::Operator:
        return text(f.text, false, f.ink);
    case Kind::Fraction: {
        const FormulaLayout inner = isSmallFraction(f) ? smaller() : *this;
        return fraction(inner.box(f.parts[0]), inner.box(f.parts[1]));
    }
    case Kind::Root:
        return root(box(f.parts[0]));
    case Kind::Script:
        return script(f);
    case Kind::Group:
        return group(box(f.parts[0]));
    }
    return {};
}

void paintFormula(QPainter& painter, const FormulaBox& box, QPointF baseline, const Appearance& appearance) {
    painter.setRenderHint(QPainter::Antialiasing);
    for (const FormulaItem& item : box.items) {
        const QColor color = appearance.textInk(item.ink);
        if (item.text.isEmpty()) {
            painter.fillPath(item.path.translated(baseline), color);
            continue;
        }
        painter.setFont(item.font);
        painter.setPen(color);
        painter.drawText(baseline + item.position, item.text);
    }
}

std::vector<QRectF> inkRects(const FormulaBox& box, QPointF baseline) {
    std::vector<QRectF> rects;
    for (const FormulaItem& item : box.items)
        rects.push_back(
            item.text.isEmpty()
                ? item.path.boundingRect().translated(baseline)
                : QFontMetricsF(item.font).tightBoundingRect(item.text).translated(baseline + item.position));
    return rects;
}

} // namespace thetalane
