// A vector in the plane.
#pragma once

#include <cmath>

namespace thetalane {

template <class Real> struct Vec2 {
    Real x{};
    Real y{};

    friend constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
    friend constexpr Vec2 operator*(const Vec2& a, const Real& s) { return {a.x * s, a.y * s}; }
    friend constexpr Vec2 operator*(const Real& s, const Vec2& a) { return {a.x * s, a.y * s}; }
    friend constexpr bool operator==(const Vec2& a, const Vec2& b) { return a.x == b.x && a.y == b.y; }
};

using Vec2d = Vec2<double>;

template <class Real> constexpr Real dot(const Vec2<Real>& a, const Vec2<Real>& b) {
    return a.x * b.x + a.y * b.y;
}

// The z component of the vector product.
template <class Real> constexpr Real cross(const Vec2<Real>& a, const Vec2<Real>& b) {
    return a.x * b.y - a.y * b.x;
}

template <class Real> Real norm(const Vec2<Real>& a) {
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y);
}

template <class To, class From> Vec2<To> convert(const Vec2<From>& a) {
    return {static_cast<To>(a.x), static_cast<To>(a.y)};
}

} // namespace thetalane
