// The study of extremes in words, and by the names its CSV has in every language.
#pragma once

#include "core/study/extremes.h"

#include <QString>

namespace thetalane {

QString rowTitle(ExtremeRow row);
QString caseTitle(const ExtremeResult& result); // with its value
QString measureTitle(ExtremeMeasure measure);

// row, case, asked, exact, got, error, bound, within: a line of its own each.
QString extremesCsv(const std::vector<ExtremeResult>& results);

} // namespace thetalane
