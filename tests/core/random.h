// Seeded random numbers, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace thetalane::testing {

// std::mt19937_64 is the same everywhere; the standard distributions are not.
class Random {
public:
    explicit Random(std::uint64_t seed)
        : m_bits(seed) {}
    double unit() { return double(m_bits() >> 11) * 0x1p-53; }
    double in(double low, double high) { return low + (high - low) * unit(); }
    double logUniform(double low, double high) { return low * std::exp(unit() * std::log(high / low)); }
    int below(int n) { return int(m_bits() % std::uint64_t(n)); }
    std::uint64_t bits() { return m_bits(); }

private:
    std::mt19937_64 m_bits;
};

} // namespace thetalane::testing
