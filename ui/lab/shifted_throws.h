// The same throws with the ball a little to the left: what the scene itself makes of a difference.
#pragma once

#include "ui/lab/lab_plan.h"

namespace thetalane {

// The first body starts so far to the left [m].
Scene shifted(Scene scene, double left);

// A row for each of the plan's shifts: moved throws held against those that were not, all computed by the
// reference, so that what differs is not rounding. Without costs.
StudyResult studyShifts(const LabPlan& plan, const StudyReport& report, std::stop_token stop);

} // namespace thetalane
