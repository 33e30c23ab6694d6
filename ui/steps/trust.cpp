#include "ui/steps/trust.h"

#include "core/study/digits_left.h"

namespace thetalane {

std::optional<int> Trust::digitsLeft(const std::shared_ptr<const Run>& run, bool fromTheStart,
                                     std::size_t collision) {
    constexpr std::size_t mostSteps = 100'000; // a body at a collision; some 10 ms
    const std::size_t steps = run->timeline.collisions().size() * run->scene.bodies.size();
    if (!fromTheStart || run->settings.kind != EngineKind::Event || steps > mostSteps)
        return std::nullopt;
    if (m_run != run) {
        m_run = run;
        m_digits = thetalane::digitsLeft(*run);
    }
    if (collision >= m_digits.size())
        return std::nullopt;
    return int(m_digits[collision]); // whole digits: what is begun is not right
}

} // namespace thetalane
