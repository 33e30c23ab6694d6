// The work-precision diagram of a study: what a throw costs, and how far off it ends.
#pragma once

#include "core/study/study.h"
#include "ui/plot/plot.h"

namespace thetalane {

// Its colour, line and marker: the same wherever the method is drawn. By family, not by step.
struct MethodStyle {
    QColor colour;
    Qt::PenStyle line = Qt::SolidLine;
    Marker marker = Marker::Circle;
};
MethodStyle methodStyle(const Method& method);

// A series a family, from the cheapest to the dearest; the truth and what was not measured are left out.
Plot workPrecisionPlot(const StudyResult& result, const QString& title, bool throws);

// The method behind a point of that plot, as an index into result.methods.
std::size_t methodOfPoint(const StudyResult& result, std::size_t series, std::size_t point);

} // namespace thetalane
