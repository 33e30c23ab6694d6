// What is said of a prediction: what went wrong, and the rule of the score.
#pragma once

#include "core/collision/prediction.h"
#include "core/timeline/timeline.h"

#include <QString>

namespace thetalane {

// One sentence, with the names of the bodies and the numbers.
QString diagnosisText(const Scene& scene, const Collision& collision, const Diagnosis& diagnosis);

QString scoreRule();                    // how the score comes about
QString praise(const Verdict& verdict); // "All right!", "Nearly"

} // namespace thetalane
