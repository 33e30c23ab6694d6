// The table of the worksheet: names and masses, then before and after, a row a body and one of the sums.
#include "ui/words/instant.h"
#include "ui/words/number_text.h"
#include "ui/words/worked_steps.h"
#include "ui/worksheet/worksheet_parts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

struct SheetText {
    Q_DECLARE_TR_FUNCTIONS(Worksheet)
};

constexpr int columnsOfTable = 12;

// Where the columns of the table begin and end, as parts of its width: names and masses, before, after.
constexpr double edges[columnsOfTable + 1] = {0,     0.095, 0.165, 0.249, 0.333, 0.417, 0.501,
                                              0.583, 0.667, 0.751, 0.835, 0.919, 1};

double edge(const Paper& paper, int column) {
    return Paper::margin + edges[column] * paper.room();
}

} // namespace

void WorksheetParts::tableCell(Paper& paper, int column, double top, const QString& text, bool bold,
                               bool answer) const {
    const double left = edge(paper, column), right = edge(paper, column + 1);
    double size = 0.92;
    while (size > 0.5 && paper.textWidth(text, size, bold) > right - left - 30)
        size -= 0.03;
    const double wide = paper.textWidth(text, size, bold);
    const double x = column == 0 ? left + 30 : (left + right - wide) / 2;
    paper.text(x, top + (0.92 - size) * 0.6 * paper.em(), text,
               answer ? paper.appearance().accent() : paper.appearance().text(), size, bold);
}

void WorksheetParts::tableHead(Paper& paper, double top) const {
    const double row = 1.5 * paper.em();
    const auto over = [&](int from, int to, const QString& text) {
        const double middle = (edge(paper, from) + edge(paper, to)) / 2;
        paper.text(middle - paper.textWidth(text, 0.95, true) / 2, top, text, paper.appearance().text(), 0.95,
                   true);
    };
    over(2, 7, SheetText::tr("Before the collision"));
    over(7, 12, SheetText::tr("After the collision"));
    tableCell(paper, 0, top + row, SheetText::tr("Body"), false, false);
    const char* names[] = {"m", "vx", "vy", "px", "py", "Ek", "vx", "vy", "px", "py", "Ek"};
    const char* units[] = {"kg",  "m/s", "m/s",    "kg·m/s", "kg·m/s", "J",
                           "m/s", "m/s", "kg·m/s", "kg·m/s", "J"};
    for (int c = 1; c < columnsOfTable; ++c) {
        tableCell(paper, c, top + row, QString::fromUtf8(names[c - 1]), false, false);
        tableCell(paper, c, top + 2 * row - 0.25 * paper.em(), '[' + QString::fromUtf8(units[c - 1]) + ']',
                  false, false);
    }
}

std::vector<WorksheetParts::TableLine> WorksheetParts::tableLines() const {
    std::vector<TableLine> lines;
    TableLine sum{SheetText::tr("Total"), 0, {}, {}, {}};
    for (const PassBody& b : bodiesOf(m_pass)) {
        TableLine line{bodyName(m_subject.scene, b.body), b.mass, {b.before, b.after}, {}, {}};
        for (int k = 0; k < 2; ++k) {
            line.momentum[k] = b.mass * *line.velocity[k];
            line.energy[k] = b.mass * dot(*line.velocity[k], *line.velocity[k]) / 2;
            sum.momentum[k] = sum.momentum[k] + line.momentum[k];
            sum.energy[k] += line.energy[k];
        }
        sum.mass += b.mass;
        lines.push_back(std::move(line));
    }
    lines.push_back(std::move(sum));
    return lines;
}

void WorksheetParts::tableLine(Paper& paper, const TableLine& line, double y, double scale) const {
    const bool total = !line.velocity[0];
    tableCell(paper, 0, y, line.name, total, false);
    tableCell(paper, 1, y, numberText(line.mass), false, false);
    for (int k = 0; k < 2; ++k) {
        int column = 2 + 5 * k;
        const auto answer = [&](double value) {
            if (!asks())
                tableCell(paper, column, y, numberText(value), total, true);
            ++column;
        };
        for (const auto part : {&Vec2d::x, &Vec2d::y}) {
            if (total) // it has no velocity of its own
                tableCell(paper, column++, y, QStringLiteral("—"), false, false);
            else
                answer((*line.velocity[k]).*part);
        }
        // What rounding leaves of nothing is no answer to write down.
        for (const auto part : {&Vec2d::x, &Vec2d::y})
            answer(std::abs(line.momentum[k].*part) < 1e-12 * scale ? 0 : line.momentum[k].*part);
        answer(line.energy[k]);
    }
}

void WorksheetParts::tableRules(Paper& paper, double top, double first, double row, std::size_t count) const {
    const QColor ink = paper.appearance().quietText(), fine = paper.appearance().line();
    const double names = top + 1.6 * paper.em(), end = first + double(count) * row;
    for (int c = 0; c <= columnsOfTable; ++c) {
        const bool strong = c == 0 || c == 2 || c == 7 || c == columnsOfTable;
        paper.line({edge(paper, c), strong ? top : names}, {edge(paper, c), end}, strong ? ink : fine,
                   strong ? 7 : 5);
    }
    const double left = edge(paper, 0), right = edge(paper, columnsOfTable);
    paper.line({edge(paper, 2), names}, {right, names}, fine, 5);
    for (const double y : {top, first, end - row, end})
        paper.line({left, y}, {right, y}, ink, 7);
    for (std::size_t k = 1; k + 1 < count; ++k)
        paper.line({left, first + double(k) * row}, {right, first + double(k) * row}, fine, 5);
}

void WorksheetParts::table(Paper& paper) const {
    const double row = (asks() ? 2.05 : 1.75) * paper.em();
    const double top = paper.y(), first = top + 4.4 * paper.em();
    const std::vector<TableLine> lines = tableLines();
    double scale = 0;
    for (const TableLine& line : lines)
        scale = std::max({scale, norm(line.momentum[0]), norm(line.momentum[1])});
    tableHead(paper, top);
    for (std::size_t k = 0; k < lines.size(); ++k)
        tableLine(paper, lines[k], first + double(k) * row + (row - 1.5 * paper.em()) / 2, scale);
    tableRules(paper, top, first, row, lines.size());
    paper.moveTo(first + double(lines.size()) * row);
}

} // namespace thetalane
