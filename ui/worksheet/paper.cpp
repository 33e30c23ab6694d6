#include "ui/worksheet/paper.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

constexpr double blankEms = 7; // of a number to be written in

const QColor blankColour(0x55, 0x5E, 0x68);

QStringList wrapped(const QString& text, const QFontMetricsF& metrics, double width) {
    QStringList lines{QString()};
    for (const QString& word : text.split(u' ')) {
        const QString longer = lines.last().isEmpty() ? word : lines.last() + u' ' + word;
        if (metrics.horizontalAdvance(longer) <= width || lines.last().isEmpty())
            lines.last() = longer;
        else
            lines << word;
    }
    return lines;
}

// The unit behind a number that is not told.
Formula unitOf(const Formula& result) {
    if (result.kind == Formula::Kind::Row && result.parts.size() == 2 &&
        result.parts[1].kind == Formula::Kind::Upright)
        return result.parts[1];
    return {};
}

} // namespace

struct Paper::Piece {
    FormulaBox box;
    double blank = 0; // its width, where there is something to be written before the box
    bool result = false;

    double width() const { return blank + box.width; }
};

// Simple shaping: with it some fonts take other figures, and then the figures in the file are no text.
QFont Paper::font(double size, bool bold) const {
    QFont font = m_appearance.font(Appearance::Size::Normal, bold);
    font.setPixelSize(std::max(1, int(std::lround(size * m_em))));
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setStyleStrategy(QFont::PreferNoShaping);
    return font;
}

double Paper::textWidth(const QString& text, double size, bool bold) const {
    return QFontMetricsF(font(size, bold)).horizontalAdvance(text);
}

void Paper::text(double x, double y, const QString& text, const QColor& colour, double size,
                 bool bold) const {
    if (!m_painter)
        return;
    m_painter->setFont(font(size, bold));
    m_painter->setPen(colour);
    // Composed syllables, however they were typed: nothing puts them together later.
    m_painter->drawText(QPointF(x, y + 1.1 * size * m_em), text.normalized(QString::NormalizationForm_C));
}

double Paper::paragraph(double x, double y, double width, const QString& text, const QColor& colour,
                        double size) const {
    const QStringList lines = wrapped(text, QFontMetricsF(font(size)), width);
    for (qsizetype k = 0; k < lines.size(); ++k)
        this->text(x, y + double(k) * 1.45 * size * m_em, lines[k], colour, size);
    return double(lines.size()) * 1.45 * size * m_em;
}

void Paper::line(QPointF from, QPointF to, const QColor& colour, double wide, Qt::PenStyle style) const {
    if (!m_painter)
        return;
    m_painter->setPen(QPen(colour, wide, style, Qt::FlatCap));
    m_painter->drawLine(from, to);
}

std::vector<Paper::Piece> Paper::piecesOf(const WorkedLine& line, double width, Fill fill) const {
    const FormulaLayout layout(m_appearance, int(std::lround(m_em)));
    std::vector<Piece> pieces{{layout.box(line.left, width), 0, false}};
    const FormulaBox equals = layout.text(QStringLiteral("="), false, Ink::Plain);
    const double space = layout.relationSpace();
    const auto add = [&](const FormulaBox& right, double blank, bool result) {
        Piece piece{{}, 0, result};
        piece.box.add(equals, {space, 0});
        const double start = 2 * space + equals.width;
        piece.box.add(right, {start + blank, 0});
        piece.box.width = start + blank + right.width;
        piece.blank = 0;
        pieces.push_back(std::move(piece));
    };
    const double inside = width - 3 * m_em;
    if (!isEmpty(line.symbolic))
        add(layout.box(line.symbolic, inside), 0, false);
    if (fill == Fill::Blank) {
        const FormulaBox unit = layout.box(unitOf(line.result));
        add(unit, blankEms * m_em, true);
        return pieces;
    }
    if (!isEmpty(line.substituted))
        add(layout.box(line.substituted, inside), 0, false);
    add(layout.box(line.result), 0, true);
    return pieces;
}

double Paper::worked(double x, double y, double width, const WorkedLine& line, Fill fill) const {
    const FormulaLayout layout(m_appearance, int(std::lround(m_em)));
    const std::vector<Piece> pieces = piecesOf(line, width, fill);
    const double leading = 0.5 * m_em, least = 0.85 * m_em, hang = 1.4 * m_em;
    double top = y;
    for (std::size_t begin = 0; begin < pieces.size();) {
        double wide = begin == 0 ? 0 : hang, up = least, down = 0.3 * m_em;
        std::size_t end = begin;
        while (end < pieces.size() && (end == begin || wide + pieces[end].width() <= width)) {
            wide += pieces[end].width();
            up = std::max(up, pieces[end].box.ascent);
            down = std::max(down, pieces[end].box.descent);
            ++end;
        }
        const double baseline = top + leading / 2 + up;
        double left = x + (begin == 0 ? 0 : hang);
        for (; begin < end; ++begin) {
            const Piece& piece = pieces[begin];
            if (m_painter)
                paintFormula(*m_painter, piece.box, {left, baseline}, m_appearance);
            if (piece.result) {
                const double start = left + 2 * layout.relationSpace() +
                                     layout.text(QStringLiteral("="), false, Ink::Plain).width;
                const double over =
                    fill == Fill::Blank ? blankEms * m_em - 0.2 * m_em : left + piece.width() - start;
                this->line({start, baseline + 0.28 * m_em}, {start + over, baseline + 0.28 * m_em},
                           fill == Fill::Blank ? blankColour : m_appearance.accent(),
                           fill == Fill::Blank ? 5 : 8);
            }
            left += piece.width();
        }
        top = baseline + down + leading / 2;
    }
    return top - y;
}

// The first column takes the half that comes nearest to an equal height.
void Paper::columns(const std::vector<WorkedLine>& lines, Fill fill) {
    const double gap = 2 * m_em, wide = (room() - gap) / 2;
    const Paper measure(m_appearance, m_em, nullptr);
    std::vector<double> heights;
    double all = 0;
    for (const WorkedLine& line : lines) {
        heights.push_back(measure.worked(0, 0, wide, line, fill));
        all += heights.back();
    }
    std::size_t split = 0;
    double first = 0, best = all;
    double sum = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        sum += heights[k];
        if (std::max(sum, all - sum) < best) {
            best = std::max(sum, all - sum);
            split = k + 1;
            first = sum;
        }
    }
    if (split == 0) {
        split = lines.size();
        first = all;
    }
    double y = m_y;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        if (k == split)
            y = m_y;
        worked(margin + (k < split ? 0 : wide + gap), y, wide, lines[k], fill);
        y += heights[k];
    }
    m_y += std::max(first, all - first);
}

} // namespace thetalane
