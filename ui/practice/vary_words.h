// The attributes of a throw as people say and read them.
#pragma once

#include "core/study/vary_throw.h"

#include <QString>

namespace thetalane {

QString throwQuantityName(ThrowQuantity quantity);          // "Speed"
const char* throwQuantityTerm(ThrowQuantity quantity);      // of the glossary
QString throwQuantityUnit(ThrowQuantity quantity);          // "m/s"
double shownQuantity(ThrowQuantity quantity, double value); // in that unit
double quantityFromShown(ThrowQuantity quantity, double shown);

// What is worth looking at around a present value, in the shown unit.
struct ShownRange {
    double from = 0;
    double to = 1;
    double step = 0.1;
};
ShownRange usualRange(ThrowQuantity quantity, double shownPresent);

} // namespace thetalane
