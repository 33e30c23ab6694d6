// Columns of text for a terminal, where a Korean letter is two cells wide.
#pragma once

#include <QList>
#include <QString>
#include <QStringList>

#include <functional>

namespace thetalane {

// Cells that a terminal gives the text.
int displayWidth(const QString& text);

struct Column {
    enum class Align { Left, Right };
    QString header;
    Align align = Align::Right;
};

// Prints rows 0 to count - 1. `row` is asked for each twice, first for the widths, so that a million rows are
// never held.
void printTable(const QList<Column>& columns, std::size_t count,
                const std::function<QStringList(std::size_t)>& row);

// Without headers, everything to the left.
QString tableText(const QList<QStringList>& rows);

} // namespace thetalane
