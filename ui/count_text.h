// Whole numbers as people read them: 3, 1234, 12,345, 3,000,000.
#pragma once

#include <QString>

#include <cstdint>

namespace thetalane {

QString countText(std::int64_t count); // not negative

} // namespace thetalane
