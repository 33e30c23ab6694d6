#include "ui/map/map_words.h"

#include "ui/count_text.h"
#include "ui/panels/pin_deck.h"
#include "ui/plot/strike_map_figure.h"
#include "ui/words/number_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace thetalane {
namespace {

struct MapText {
    Q_DECLARE_TR_FUNCTIONS(MapText)
};

QString secondsText(double seconds) {
    return numberText(seconds, seconds < 10 ? 2 : 3);
}

// Rough, and told as such.
QString leftText(const MapNews& news) {
    constexpr double tooEarly = 0.02; // of the work
    const double part = double(news.done) / double(std::max<std::size_t>(1, news.all));
    if (part < tooEarly || news.seconds < 0.3)
        return {};
    const double left = news.seconds * (1 - part) / part;
    return left < 1 ? MapText::tr("less than 1 s left")
                    : MapText::tr("about %1 s left").arg(std::lround(left));
}

QString missingText(const StrikeMap& map) {
    const auto missing = std::count_if(map.cells.begin(), map.cells.end(), [](const MapCell& cell) {
        return cell.state == MapCell::State::NoThrow;
    });
    if (missing == 0)
        return {};
    const QString part = numberText(100.0 * double(missing) / double(map.cells.size()), 2);
    return map.settings.scene == MapScene::Rack
               ? QString()
               : MapText::tr(
                     "In %1 % of the places no throw arrives: too little spin for the angle, or the lane "
                     "too narrow.")
                     .arg(part);
}

} // namespace

QString quantityName(MapQuantity quantity) {
    switch (quantity) {
    case MapQuantity::Offset:
        return MapText::tr("Offset");
    case MapQuantity::Angle:
        return MapText::tr("Entry angle");
    case MapQuantity::Speed:
        return MapText::tr("Speed");
    case MapQuantity::Spin:
        return MapText::tr("Spin");
    case MapQuantity::Mass:
        break;
    }
    return MapText::tr("Ball weight");
}

const char* quantityTerm(MapQuantity quantity) {
    switch (quantity) {
    case MapQuantity::Offset:
        return "offset";
    case MapQuantity::Angle:
        return "entry-angle";
    case MapQuantity::Speed:
        return "speed";
    case MapQuantity::Spin:
        return "angular-velocity";
    case MapQuantity::Mass:
        break;
    }
    return "mass";
}

QString quantityValue(MapQuantity quantity, double value) {
    const QString number = numberText(inShownUnit(quantity, value), 3);
    switch (quantity) {
    case MapQuantity::Offset:
        return number + QStringLiteral(" cm");
    case MapQuantity::Angle:
        return number + QStringLiteral("°");
    case MapQuantity::Speed:
        return number + QStringLiteral(" m/s");
    case MapQuantity::Spin:
        return MapText::tr("%1 rpm").arg(number);
    case MapQuantity::Mass:
        break;
    }
    return number + QStringLiteral(" kg");
}

QString placeText(const MapSettings& s, int column, int row) {
    return QStringLiteral("%1 %2, %3 %4")
        .arg(quantityName(s.across.quantity), quantityValue(s.across.quantity, s.across.at(column)),
             quantityName(s.up.quantity), quantityValue(s.up.quantity, s.up.at(row)));
}

QString cellText(const MapCell& cell) {
    if (!cell.known())
        return MapText::tr("No throw arrives so.");
    if (cell.strike())
        return MapText::tr("10 pins down: a strike");
    return cell.pinsDown() == 0 ? MapText::tr("No pin down")
                                : MapText::tr("Pins down: %1; left standing: %2")
                                      .arg(QString::number(cell.pinsDown()), pinsText(cell.left()));
}

QString mapState(const MapNews& news) {
    const QString done = countText(std::int64_t(news.done)), all = countText(std::int64_t(news.all));
    if (!news.ended) {
        const QString left = leftText(news);
        const QString now = MapText::tr("%1 of %2 throws").arg(done, all);
        return left.isEmpty() ? now : now + QStringLiteral(" · ") + left;
    }
    if (!news.map || news.map->stride == 0)
        return MapText::tr("Cancelled before there was a picture.");
    if (!news.map->whole())
        return MapText::tr("Cancelled after %1 of %2 throws: one column and row in %3 is shown.")
            .arg(done, all, QString::number(news.map->stride));
    const auto strikes = std::count_if(news.map->cells.begin(), news.map->cells.end(),
                                       [](const MapCell& cell) { return cell.strike(); });
    const QString whole =
        MapText::tr("%1 throws in %2 s, %3 strikes").arg(all, secondsText(news.seconds), countText(strikes));
    const QString missing = missingText(*news.map);
    return missing.isEmpty() ? whole : whole + u'\n' + missing;
}

QString refusalText(const MapRefusal& r) {
    switch (r.fault) {
    case MapFault::OutOfRange:
        return MapText::tr("%1 must be from %2 to %3, is %4")
            .arg(quantityName(r.quantity), quantityValue(r.quantity, r.low),
                 quantityValue(r.quantity, r.high), quantityValue(r.quantity, r.value));
    case MapFault::SpinWithoutFriction:
        return MapText::tr("Without friction spin does nothing; choose another quantity.");
    default:
        return MapText::tr("Such a map cannot be made.");
    }
}

QString carryNote() {
    return MapText::tr("Each place is a throw of its own. Pins here are discs that slide, and count as down "
                       "when struck hard "
                       "enough to tip; real pins fall over and sweep others down. Read where the pocket lies "
                       "and how it widens "
                       "with the angle, not how often a real bowler strikes.");
}

} // namespace thetalane
