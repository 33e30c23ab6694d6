// A table as a value: what is shown, copied and written to a file is one and the same.
#pragma once

#include "ui/words/formula.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace thetalane {

struct SheetCell {
    QString shown;
    QString exact; // copied and written: all digits; empty: what is shown
    QString hover; // all digits with the unit, or why
    Ink ink = Ink::Plain;
    bool strong = false; // a total, or the name of a block
};

struct SheetColumn {
    QString name;
    QString unit; // under the name; in files "name [unit]"
};

struct Sheet {
    std::vector<SheetColumn> columns;
    std::vector<std::vector<SheetCell>> rows; // a row may be shorter: the rest is empty
};

SheetCell textCell(const QString& text, Ink ink = Ink::Plain, bool strong = false);
SheetCell numberCell(double value, const QString& unit, Ink ink = Ink::Plain, bool strong = false);

// Whether `residual` is what rounding leaves of numbers of that size.
bool isRounding(double residual, double scale);
// What rounding leaves of nothing, against numbers of the size of `scale`, shows as 0; its digits stay.
SheetCell numberCellOf(double value, double scale, const QString& unit, Ink ink = Ink::Plain,
                       bool strong = false);
QString columnTitle(const SheetColumn& column); // "vx [m/s]"

// Parted by tabs, for the clipboard: all digits, a line for each row.
QString tabbed(const Sheet& sheet);
// For a file: UTF-8 with the mark at the beginning by which spreadsheets know Korean.
QByteArray commaSeparated(const Sheet& sheet);

} // namespace thetalane
