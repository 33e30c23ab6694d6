// A method of the study in words: the same in the table, the picture and the panel.
#pragma once

#include "core/study/study.h"

#include <QString>

namespace thetalane {

QString methodText(const Method& method);   // "event, double", "the paper's loop, 1/60 s", "without friction"
QString methodFamily(const Method& method); // without step and precision: what a line of a plot joins
QString precisionText(Precision precision);
QString modelText(Model model);        // "friction"
QString stepText(double step);         // "1/60 s"
QString costText(double microseconds); // "4.5 µs", "320 ms"

} // namespace thetalane
