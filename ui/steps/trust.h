// How far a collision can be trusted: how many digits chaos has left of it.
#pragma once

#include "core/engine/engine.h"

#include <memory>
#include <optional>
#include <vector>

namespace thetalane {

// Of one run at a time, found when first asked for and kept.
class Trust {
public:
    // Nothing for a run that does not begin at the start, that steps, or that is too long to be followed
    // between two frames.
    std::optional<int> digitsLeft(const std::shared_ptr<const Run>& run, bool fromTheStart,
                                  std::size_t collision);

private:
    std::shared_ptr<const Run> m_run;
    std::vector<double> m_digits;
};

} // namespace thetalane
