#include "ui/tables/sheet.h"

#include "ui/words/number_text.h"

#include <QStringList>

#include <cmath>

namespace thetalane {
namespace {

QString written(const SheetCell& cell) {
    return cell.exact.isEmpty() ? cell.shown : cell.exact;
}

// A field with a comma, a quotation mark or a line break stands in quotation marks.
QString quoted(QString field) {
    if (!field.contains(u',') && !field.contains(u'"') && !field.contains(u'\n') && !field.contains(u'\r'))
        return field;
    return u'"' + field.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

// A tab or a line break in a name would part what belongs together.
QString unbroken(QString field) {
    for (const QChar c : {u'\t', u'\n', u'\r'})
        field.replace(c, u' ');
    return field;
}

template <class Write> QString lines(const Sheet& sheet, QChar separator, Write&& write, const QString& end) {
    QString text;
    QStringList fields;
    for (const SheetColumn& column : sheet.columns)
        fields << write(columnTitle(column));
    text += fields.join(separator) + end;
    for (const auto& row : sheet.rows) {
        fields.clear();
        for (const SheetCell& cell : row)
            fields << write(written(cell));
        while (std::size_t(fields.size()) < sheet.columns.size())
            fields << QString();
        text += fields.join(separator) + end;
    }
    return text;
}

} // namespace

SheetCell textCell(const QString& text, Ink ink, bool strong) {
    return {text, {}, {}, ink, strong};
}

SheetCell numberCell(double value, const QString& unit, Ink ink, bool strong) {
    const QString exact = exactText(value);
    return {numberText(value), exact, unit.isEmpty() ? exact : exact + u' ' + unit, ink, strong};
}

bool isRounding(double residual, double scale) {
    return std::abs(residual) <= 1e-12 * scale;
}

SheetCell numberCellOf(double value, double scale, const QString& unit, Ink ink, bool strong) {
    SheetCell cell = numberCell(value, unit, ink, strong);
    if (isRounding(value, scale))
        cell.shown = QStringLiteral("0");
    return cell;
}

QString columnTitle(const SheetColumn& column) {
    return column.unit.isEmpty() ? column.name : QStringLiteral("%1 [%2]").arg(column.name, column.unit);
}

QString tabbed(const Sheet& sheet) {
    return lines(sheet, u'\t', unbroken, QStringLiteral("\n"));
}

QByteArray commaSeparated(const Sheet& sheet) {
    return QByteArray("\xEF\xBB\xBF") + lines(sheet, u',', quoted, QStringLiteral("\r\n")).toUtf8();
}

} // namespace thetalane
