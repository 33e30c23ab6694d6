// A short piece of a row's line, in its colour, as it is drawn over the lane and in the diagram.
#pragma once

#include "ui/appearance.h"
#include "ui/plot/study_plot.h"

#include <QIcon>
#include <QSize>

namespace thetalane {

// A row's colour as it stands out from the ground: lighter in the dark.
QColor seenColour(const QColor& colour, const Appearance& appearance);

QSize lineSampleSize(const Appearance& appearance);
QIcon lineSample(const MethodStyle& style, const Appearance& appearance);

} // namespace thetalane
