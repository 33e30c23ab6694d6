// The strike map as a picture: cells, axes with units, legend, and what it does not claim. For a file and for
// a panel.
#pragma once

#include "core/study/strike_map.h"

#include <QColor>
#include <QImage>
#include <QRectF>
#include <QString>

class QPainter;

namespace thetalane {

// Of pins down: light to dark blue, read in every kind of colour blindness and in grey. A strike is amber,
// and striped where it is drawn large enough.
QColor pinsDownColour(int pinsDown);
QColor strikeColour();

// A pixel for each cell, the first row at the bottom; what is pending or cannot be thrown is transparent.
QImage cellImage(const StrikeMap& map);

// "Entry angle [°]": of an axis, with its unit; and a value of it in that unit.
QString quantityTitle(MapQuantity quantity);
double inShownUnit(MapQuantity quantity, double value);

// At most `most` round values of an axis, in its shown unit; and where one of them lies, of the axis's
// length: cells are centred on their values.
std::vector<double> axisTicks(const MapAxis& axis, int most);
double axisPlace(const MapAxis& axis, double shownValue);

// The cells alone, smooth at no scale, strikes striped.
void paintCells(QPainter& painter, const QRectF& where, const StrikeMap& map);

// All of it, in the painter's family of type. A map of offset over angle has its pocket marked.
void paintStrikeMap(QPainter& painter, const QRectF& where, const StrikeMap& map);

} // namespace thetalane
