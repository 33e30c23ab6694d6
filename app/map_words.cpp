#include "app/map_words.h"

#include "app/console.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

struct MapWords {
    Q_DECLARE_TR_FUNCTIONS(MapWords)
};

// The option that the quantity is asked for by, and its unit there.
struct Asked {
    const char* option;
    double unit;
};
Asked askedBy(MapQuantity quantity) {
    switch (quantity) {
    case MapQuantity::Offset:
        return {"--offset-from, --offset-to", 1};
    case MapQuantity::Angle:
        return {"--angle-from, --angle-to", std::numbers::pi / 180};
    case MapQuantity::Speed:
        return {"--speed", 1};
    case MapQuantity::Spin:
        return {"--spin", 2 * std::numbers::pi / 60};
    case MapQuantity::Mass:
        break;
    }
    return {"--mass", 1};
}

QString said(const std::string& text) {
    return oneLine(QString::fromStdString(text));
}

QString columnFault(const MapFileError& e) {
    const QString what = said(e.text), expected = said(e.expected), other = said(e.other);
    switch (e.fault) {
    case MapFileFault::NotANumber:
        return MapWords::tr("must be a number, is \"%1\"").arg(what);
    case MapFileFault::WrongValue:
        return MapWords::tr("must be %1, is \"%2\"").arg(expected, what);
    default:
        return MapWords::tr("is %1, but %2 in %3; the parts of one map are made with the same settings")
            .arg(what, expected, other);
    }
}

QString fault(const MapFileError& e) {
    const QString what = said(e.text), expected = said(e.expected), other = said(e.other);
    switch (e.fault) {
    case MapFileFault::NotAMap:
        return MapWords::tr("is no part of a strike map; line 1 must be \"%1\", is \"%2\"")
            .arg(expected, what);
    case MapFileFault::FieldCount:
        return MapWords::tr("must have %1 fields, has %2").arg(expected, what);
    case MapFileFault::RowTwice:
        return MapWords::tr("row %1 is in %2, too; parts must not overlap").arg(e.row).arg(other);
    case MapFileFault::RowUnfinished:
        return MapWords::tr("row %1 has %2 cells, the rows of %4 have %3; make this part again")
            .arg(QString::number(e.row), what, expected, other);
    case MapFileFault::RowsMissing:
        return e.row == e.lastRow
                   ? MapWords::tr("row %1 is in none of the files; make it with --rows %1-%1").arg(e.row)
                   : MapWords::tr("rows %1 to %2 are in none of the files; make them with --rows %1-%2")
                         .arg(e.row)
                         .arg(e.lastRow);
    case MapFileFault::Empty:
        return MapWords::tr("has no rows; a part is made with --csv");
    case MapFileFault::NotANumber:
    case MapFileFault::WrongValue:
    case MapFileFault::OtherSettings:
        break;
    }
    return said(e.column) + ": " + columnFault(e);
}

} // namespace

QString mapRefusalMessage(const MapRefusal& r, const MapSettings& settings) {
    switch (r.fault) {
    case MapFault::TooManyCells:
        return "--offsets, --angles: " + MapWords::tr("%1 cells are too many; at most %2 fit")
                                             .arg(r.value, 0, 'f', 0)
                                             .arg(mostMapCells);
    case MapFault::Rows:
        return "--rows: " + MapWords::tr("must be within 1 to %1").arg(settings.up.count);
    case MapFault::OutOfRange: {
        const Asked asked = askedBy(r.quantity);
        // To and fro between units leaves a rounding that would be shown as digits.
        const auto shown = [&](double v) { return numberText(std::round(v / asked.unit * 1e9) / 1e9); };
        return QString(asked.option) + ": " +
               MapWords::tr("must be from %1 to %2, is %3").arg(shown(r.low), shown(r.high), shown(r.value));
    }
    case MapFault::Count:
        return "--offsets, --angles: " + MapWords::tr("must be at least 1");
    case MapFault::SpinWithoutFriction:
        return "--spin: " + MapWords::tr("has no meaning on the rack, which has no friction");
    case MapFault::SameQuantity:
        break;
    }
    return MapWords::tr("both axes ask for the same");
}

QString mapFileMessage(const MapFileError& e) {
    QString text = e.file.empty() ? QString("--merge: ") : said(e.file) + ": ";
    if (e.line > 0 && e.fault != MapFileFault::NotAMap && e.fault != MapFileFault::Empty)
        text += MapWords::tr("line %1: ").arg(e.line);
    else if (e.row > 0 && e.fault == MapFileFault::OtherSettings)
        text += MapWords::tr("row %1: ").arg(e.row);
    return text + fault(e);
}

} // namespace thetalane
