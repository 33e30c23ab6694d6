#include "ui/plot/strike_map_figure.h"

#include "ui/words/number_text.h"

#include <QBrush>
#include <QCoreApplication>
#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace thetalane {
namespace {

struct StrikeMapFigure {
    Q_DECLARE_TR_FUNCTIONS(StrikeMapFigure)
};

constexpr QRgb paper = 0xFFFFFFFF, ink = 0xFF1F2933, quiet = 0xFF5B6770, hairline = 0xFFC9CED3;

// One hue whose lightness falls evenly: ColorBrewer's Blues, with two steps more at the dark end.
constexpr std::array<QRgb, 11> blues{0xFFF7FBFF, 0xFFE6F0F9, 0xFFD5E5F4, 0xFFBFD8ED, 0xFFA1CBE2, 0xFF7DB8DA,
                                     0xFF5BA3CF, 0xFF3F8FC5, 0xFF2676B5, 0xFF0F5A9E, 0xFF083D7E};
constexpr QRgb amber = 0xFFE69F00; // Okabe and Ito
constexpr QRgb stripe = 0xFF5C3D00;

struct Fonts {
    QFont title, text, small;
    Fonts(const QFont& family, double unit)
        : title(family)
        , text(family)
        , small(family) {
        title.setPixelSize(int(std::lround(2.1 * unit)));
        title.setBold(true);
        text.setPixelSize(int(std::lround(1.35 * unit)));
        small.setPixelSize(int(std::lround(1.15 * unit)));
    }
};

// Oblique lines; the same wherever the brush begins.
QBrush stripes(double unit) {
    const int size = std::max(4, int(std::lround(unit * 0.55)));
    QImage tile(size, size, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    for (int k = 0; k < size; ++k)
        tile.setPixel(k, size - 1 - k, stripe);
    return QBrush(tile);
}

// 1, 2 or 5 times a power of ten, at most `most` in the range.
double tickStep(double range, int most) {
    const double raw = range / most;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= raw * (1 - 1e-9))
            return times * power;
    return 10 * power;
}

struct Shown {
    double from, to;
};
Shown shownRange(const MapAxis& axis) {
    return {inShownUnit(axis.quantity, axis.from), inShownUnit(axis.quantity, axis.to)};
}

std::vector<double> ticksOf(const Shown& range, int most) {
    std::vector<double> ticks;
    const double low = std::min(range.from, range.to), high = std::max(range.from, range.to);
    if (!(high > low))
        return {low};
    const double step = tickStep(high - low, most);
    for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
        ticks.push_back(k == 0 ? 0 : k * step);
    return ticks;
}

// Cells are centred on their values: where a value lies, of the axis's length. The axis may be a part's.
double placeOf(double value, const Shown& range, int count, int first, int shown) {
    const double cell = count > 1 ? (value - range.from) / (range.to - range.from) * (count - 1) : 0;
    return (cell + 0.5 - first) / shown;
}

void paintFrame(QPainter& p, const QRectF& cells) {
    p.setPen(QPen(QColor(ink), 1));
    p.setBrush(Qt::NoBrush);
    p.drawRect(cells);
}

void paintAcross(QPainter& p, const QRectF& cells, const StrikeMap& map, const Fonts& fonts, double unit) {
    const MapAxis& axis = map.settings.across;
    const Shown range = shownRange(axis);
    p.setFont(fonts.text);
    for (const double tick : ticksOf(range, 9)) {
        const double x = cells.left() + placeOf(tick, range, axis.count, 0, axis.count) * cells.width();
        p.setPen(QPen(QColor(ink), 1));
        p.drawLine(QPointF(x, cells.bottom()), QPointF(x, cells.bottom() + 0.6 * unit));
        p.drawText(QRectF(x - 5 * unit, cells.bottom() + 0.7 * unit, 10 * unit, 2 * unit),
                   Qt::AlignHCenter | Qt::AlignTop, numberText(tick));
    }
    p.drawText(QRectF(cells.left(), cells.bottom() + 2.7 * unit, cells.width(), 2 * unit),
               Qt::AlignHCenter | Qt::AlignTop, quantityTitle(axis.quantity));
}

void paintUp(QPainter& p, const QRectF& cells, const StrikeMap& map, const Fonts& fonts, double unit) {
    const MapAxis& axis = map.settings.up;
    const Shown range = shownRange(axis);
    p.setFont(fonts.text);
    for (const double tick : ticksOf(range, 9)) {
        const double place = placeOf(tick, range, axis.count, map.settings.firstRow, map.rows());
        if (place < 0 || place > 1)
            continue;
        const double y = cells.bottom() - place * cells.height();
        p.setPen(QPen(QColor(ink), 1));
        p.drawLine(QPointF(cells.left() - 0.6 * unit, y), QPointF(cells.left(), y));
        p.drawText(QRectF(cells.left() - 6.8 * unit, y - unit, 6 * unit, 2 * unit),
                   Qt::AlignRight | Qt::AlignVCenter, numberText(tick));
    }
    p.save();
    p.translate(cells.left() - 6.6 * unit, cells.center().y());
    p.rotate(-90);
    p.drawText(QRectF(-cells.height() / 2, -unit, cells.height(), 2 * unit), Qt::AlignCenter,
               quantityTitle(axis.quantity));
    p.restore();
}

// The pocket of the books: 17½ boards in, 6°; for a right-hander and, where it is on the map, a left-hander.
void paintPocket(QPainter& p, const QRectF& cells, const StrikeMap& map, const Fonts& fonts, double unit) {
    const MapSettings& s = map.settings;
    if (s.across.quantity != MapQuantity::Offset || s.up.quantity != MapQuantity::Angle)
        return;
    constexpr double offset = 6.76, angle = 6; // cm, °
    const double x = placeOf(offset, shownRange(s.across), s.across.count, 0, s.across.count);
    const double y = placeOf(angle, shownRange(s.up), s.up.count, s.firstRow, map.rows());
    if (x < 0 || x > 1 || y < 0 || y > 1)
        return;
    const QPointF at(cells.left() + x * cells.width(), cells.bottom() - y * cells.height());
    const double r = 1.1 * unit;
    for (const auto& [colour, width] : {std::pair{QColor(paper), 0.45 * unit}, {QColor(ink), 0.18 * unit}}) {
        p.setPen(QPen(colour, width));
        p.setBrush(Qt::NoBrush);
        p.drawEllipse(at, r, r);
    }
    const QString text = StrikeMapFigure::tr("pocket");
    p.setFont(fonts.text);
    QPainterPath letters;
    const double width = QFontMetricsF(fonts.text).horizontalAdvance(text);
    const bool fits = at.x() + r + 0.5 * unit + width < cells.right();
    letters.addText(fits ? at.x() + r + 0.5 * unit : at.x() - r - 0.5 * unit - width, at.y() + 0.5 * unit,
                    fonts.text, text);
    p.strokePath(letters, QPen(QColor(paper), 0.4 * unit, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    p.fillPath(letters, QColor(ink));
}

void paintLegend(QPainter& p, const QRectF& where, const StrikeMap& map, const Fonts& fonts, double unit) {
    p.setFont(fonts.text);
    p.setPen(QColor(ink));
    p.drawText(QRectF(where.left(), where.top(), where.width(), 2 * unit), Qt::AlignLeft | Qt::AlignVCenter,
               StrikeMapFigure::tr("Pins down"));
    double y = where.top() + 2.6 * unit;
    const auto entry = [&](const QColor& colour, bool striped, const QString& text) {
        const QRectF swatch(where.left(), y, 3 * unit, 2 * unit);
        p.fillRect(swatch, colour);
        if (striped)
            p.fillRect(swatch, stripes(unit));
        p.setPen(QPen(QColor(hairline), 1));
        p.drawRect(swatch);
        p.setPen(QColor(ink));
        p.drawText(QRectF(swatch.right() + unit, y, where.width() - 4 * unit, 2 * unit),
                   Qt::AlignLeft | Qt::AlignVCenter, text);
        y += 2.3 * unit;
    };
    entry(strikeColour(), true, StrikeMapFigure::tr("10, strike"));
    for (int pins = 9; pins >= 0; --pins)
        entry(pinsDownColour(pins), false, QString::number(pins));
    const bool missing = std::any_of(map.cells.begin(), map.cells.end(),
                                     [](const MapCell& c) { return c.state == MapCell::State::NoThrow; });
    if (missing)
        entry(QColor(paper), false, StrikeMapFigure::tr("no such throw"));
}

QString titleOf(const StrikeMap& map) {
    return map.settings.scene == MapScene::Rack ? StrikeMapFigure::tr("Strike map: the rack without friction")
                                                : StrikeMapFigure::tr("Strike map: the whole lane");
}

// What an axis varies is not said of the ball.
QString ballOf(const MapSettings& s) {
    const auto varied = [&](MapQuantity q) { return s.across.quantity == q || s.up.quantity == q; };
    const QString mass = numberText(s.base.mass), speed = numberText(s.base.speed);
    if (varied(MapQuantity::Mass))
        return varied(MapQuantity::Speed) ? QString() : StrikeMapFigure::tr("Ball %1 m/s").arg(speed);
    return varied(MapQuantity::Speed) ? StrikeMapFigure::tr("Ball %1 kg").arg(mass)
                                      : StrikeMapFigure::tr("Ball %1 kg, %2 m/s").arg(mass, speed);
}

QString settingsOf(const StrikeMap& map) {
    const MapSettings& s = map.settings;
    const auto strikes =
        std::count_if(map.cells.begin(), map.cells.end(), [](auto& c) { return c.strike(); });
    QStringList said{ballOf(s)};
    if (s.scene == MapScene::Bowling) {
        if (s.across.quantity != MapQuantity::Spin && s.up.quantity != MapQuantity::Spin)
            said << StrikeMapFigure::tr("%1 rpm").arg(
                numberText(inShownUnit(MapQuantity::Spin, s.base.spin)));
        if (s.friction == houseFriction())
            said << StrikeMapFigure::tr("house oil");
    }
    said << StrikeMapFigure::tr("e = %1").arg(numberText(s.restitution))
         << StrikeMapFigure::tr("%1 throws, %2 strikes").arg(map.cells.size()).arg(strikes);
    said.removeAll(QString());
    return said.join(QStringLiteral(" · "));
}

QString noteText() {
    return StrikeMapFigure::tr(
        "Each cell is a throw of its own, counted by pins that were struck hard enough to tip. Pins here are "
        "discs that slide; real pins fall over and sweep others down. Read where the pocket lies and how it "
        "widens, not how often a real bowler strikes.");
}

} // namespace

QColor pinsDownColour(int pinsDown) {
    return QColor(blues[std::size_t(std::clamp(pinsDown, 0, 10))]);
}

QColor strikeColour() {
    return QColor(amber);
}

QString quantityTitle(MapQuantity quantity) {
    switch (quantity) {
    case MapQuantity::Offset:
        return StrikeMapFigure::tr("Offset from the head pin, to the right [cm]");
    case MapQuantity::Angle:
        return StrikeMapFigure::tr("Entry angle, to the left [°]");
    case MapQuantity::Speed:
        return StrikeMapFigure::tr("Speed [m/s]");
    case MapQuantity::Spin:
        return StrikeMapFigure::tr("Spin [rpm]");
    case MapQuantity::Mass:
        return StrikeMapFigure::tr("Weight of the ball [kg]");
    }
    return {};
}

double inShownUnit(MapQuantity quantity, double value) {
    // To and fro between units leaves a rounding that would be shown as digits.
    const auto shown = [](double v) { return std::round(v * 1e9) / 1e9; };
    switch (quantity) {
    case MapQuantity::Offset:
        return shown(value * 100);
    case MapQuantity::Angle:
        return shown(value * 180 / std::numbers::pi);
    case MapQuantity::Spin:
        return shown(value * 60 / (2 * std::numbers::pi));
    default:
        return value;
    }
}

QImage cellImage(const StrikeMap& map) {
    QImage image(std::max(1, map.columns()), std::max(1, map.rows()), QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int row = 0; row < map.rows(); ++row)
        for (int column = 0; column < map.columns(); ++column)
            if (const MapCell& cell = map.at(column, row); cell.known())
                image.setPixel(column, map.rows() - 1 - row,
                               cell.strike() ? amber : blues[std::size_t(cell.pinsDown())]);
    return image;
}

void paintCells(QPainter& painter, const QRectF& where, const StrikeMap& map) {
    const QImage cells = cellImage(map);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
    painter.drawImage(where, cells);
    // The stripes go through a mask of the strikes, at the resolution of the picture.
    QImage mask(where.size().toSize().expandedTo({1, 1}), QImage::Format_ARGB32_Premultiplied);
    mask.fill(Qt::transparent);
    QPainter p(&mask);
    p.fillRect(mask.rect(), stripes(std::min(where.width(), where.height()) / 60));
    QImage strikes = cells;
    for (int y = 0; y < strikes.height(); ++y)
        for (int x = 0; x < strikes.width(); ++x)
            strikes.setPixel(x, y, cells.pixel(x, y) == amber ? 0xFF000000 : 0);
    p.setCompositionMode(QPainter::CompositionMode_DestinationIn);
    p.drawImage(mask.rect(), strikes);
    p.end();
    painter.drawImage(where.topLeft(), mask);
}

std::vector<double> axisTicks(const MapAxis& axis, int most) {
    return ticksOf(shownRange(axis), most);
}

double axisPlace(const MapAxis& axis, double shownValue) {
    return placeOf(shownValue, shownRange(axis), axis.count, 0, axis.count);
}

void paintStrikeMap(QPainter& p, const QRectF& where, const StrikeMap& map) {
    const double unit = std::min(where.width() / 92, where.height() / 68); // all sizes are so many of it
    const Fonts fonts(p.font(), unit);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(where, QColor(paper));
    const QRectF page = where.adjusted(2.5 * unit, 2 * unit, -2.5 * unit, -2 * unit);
    p.setPen(QColor(ink));
    p.setFont(fonts.title);
    p.drawText(QRectF(page.left(), page.top(), page.width(), 3 * unit), Qt::AlignLeft | Qt::AlignVCenter,
               titleOf(map));
    p.setPen(QColor(quiet));
    p.setFont(fonts.text);
    p.drawText(QRectF(page.left(), page.top() + 3.2 * unit, page.width(), 2 * unit),
               Qt::AlignLeft | Qt::AlignVCenter, settingsOf(map));
    const double legend = 15 * unit, noteHeight = 5 * unit;
    const QRectF cells(page.left() + 8 * unit, page.top() + 6.8 * unit, page.width() - 8 * unit - legend,
                       page.height() - 6.8 * unit - 5.6 * unit - noteHeight);
    // Whole pixels, so that the cells' edges and the stripes lie where they are meant to.
    const QRectF pixels(cells.toAlignedRect());
    paintCells(p, pixels, map);
    paintFrame(p, pixels);
    paintAcross(p, pixels, map, fonts, unit);
    paintUp(p, pixels, map, fonts, unit);
    paintPocket(p, pixels, map, fonts, unit);
    paintLegend(p, QRectF(pixels.right() + 2.5 * unit, pixels.top(), legend - 2.5 * unit, pixels.height()),
                map, fonts, unit);
    p.setFont(fonts.small);
    p.setPen(QColor(quiet));
    p.drawText(QRectF(page.left(), page.bottom() - noteHeight, page.width(), noteHeight),
               int(Qt::AlignLeft | Qt::AlignBottom) | Qt::TextWordWrap, noteText());
}

} // namespace thetalane
