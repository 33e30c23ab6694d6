// What the errors of many cases come to, for one method.
#pragma once

#include "core/study/compare_runs.h"
#include "core/study/study.h"

#include <vector>

namespace thetalane {

// Without any errors the result says so: it stays as it is, with no cases.
void sumUp(MethodResult& result, const std::vector<CaseError>& errors);

} // namespace thetalane
