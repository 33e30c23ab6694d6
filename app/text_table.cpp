#include "app/text_table.h"

#include "app/console.h"

#include <algorithm>

namespace thetalane {
namespace {

// Unicode Standard Annex 11, the wide and full-width blocks that ids and titles can be expected to use.
bool isWide(char32_t c) {
    static constexpr char32_t blocks[][2] = {{0x1100, 0x115F},   {0x2E80, 0xA4CF},   {0xA960, 0xA97C},
                                             {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},
                                             {0xFF00, 0xFF60},   {0xFFE0, 0xFFE6},   {0x1F300, 0x1F64F},
                                             {0x1F680, 0x1F6FF}, {0x1F900, 0x1FAFF}, {0x20000, 0x3FFFD}};
    return std::any_of(std::begin(blocks), std::end(blocks),
                       [c](const auto& block) { return c >= block[0] && c <= block[1]; });
}

bool takesNoCell(char32_t c) {
    const auto category = QChar::category(c);
    return category == QChar::Mark_NonSpacing || category == QChar::Mark_Enclosing ||
           category == QChar::Other_Format;
}

QString joined(const QList<Column>& columns, const QList<int>& widths, const QStringList& cells) {
    QString line;
    for (qsizetype i = 0; i < columns.size(); ++i) {
        const QString padding(std::max(0, widths[i] - displayWidth(cells[i])), ' ');
        line += i == 0 ? "" : "  ";
        line += columns[i].align == Column::Align::Right ? padding + cells[i] : cells[i] + padding;
    }
    while (line.endsWith(' '))
        line.chop(1);
    return line;
}

void widen(QList<int>& widths, const QStringList& cells) {
    for (qsizetype i = 0; i < widths.size(); ++i)
        widths[i] = std::max(widths[i], displayWidth(cells[i]));
}

} // namespace

int displayWidth(const QString& text) {
    int width = 0;
    for (const char32_t c : text.toUcs4())
        width += takesNoCell(c) ? 0 : isWide(c) ? 2 : 1;
    return width;
}

void printTable(const QList<Column>& columns, std::size_t count,
                const std::function<QStringList(std::size_t)>& row) {
    QStringList headers;
    for (const Column& column : columns)
        headers << column.header;
    QList<int> widths(columns.size(), 0);
    widen(widths, headers);
    for (std::size_t i = 0; i < count; ++i)
        widen(widths, row(i));
    printLine(joined(columns, widths, headers));
    for (std::size_t i = 0; i < count; ++i)
        printLine(joined(columns, widths, row(i)));
}

QString tableText(const QList<QStringList>& rows) {
    const qsizetype count = rows.isEmpty() ? 0 : rows.first().size();
    const QList<Column> columns(count, Column{{}, Column::Align::Left});
    QList<int> widths(count, 0);
    for (const QStringList& row : rows)
        widen(widths, row);
    QString text;
    for (const QStringList& row : rows)
        text += joined(columns, widths, row) + '\n';
    return text;
}

} // namespace thetalane
