// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace cradle {

/// A vector in the plane; a plain value. Components carry the unit of what it measures.
struct Vec2 {
    double x = 0.0;
    double y = 0.0;

    constexpr Vec2 &operator+=(Vec2 v)
    {
        x += v.x;
        y += v.y;
        return *this;
    }
    constexpr Vec2 &operator-=(Vec2 v)
    {
        x -= v.x;
        y -= v.y;
        return *this;
    }
    friend constexpr bool operator==(const Vec2 &, const Vec2 &) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b)
{
    return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(Vec2 a, Vec2 b)
{
    return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(Vec2 v)
{
    return {-v.x, -v.y};
}
constexpr Vec2 operator*(double s, Vec2 v)
{
    return {s * v.x, s * v.y};
}
constexpr Vec2 operator*(Vec2 v, double s)
{
    return s * v;
}
constexpr Vec2 operator/(Vec2 v, double s)
{
    return {v.x / s, v.y / s};
}

/// a·b = a.x b.x + a.y b.y
constexpr double dot(Vec2 a, Vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

/// The signed area of the parallelogram of a and b: a.x b.y − a.y b.x
constexpr double cross(Vec2 a, Vec2 b)
{
    return a.x * b.y - a.y * b.x;
}

/// |v|², without the root
constexpr double lengthSquared(Vec2 v)
{
    return dot(v, v);
}

/// |v|, without overflow on the way
inline double length(Vec2 v)
{
    return std::hypot(v.x, v.y);
}

/// length(), the last digit perhaps another, in a quarter of the time: for what is compared with a
/// tolerance.
inline double quickLength(Vec2 v)
{
    constexpr double most = 1e300;
    const double squared = lengthSquared(v);
    return squared < most && squared > 1.0 / most ? std::sqrt(squared) : length(v);
}

/// v turned left by a quarter
constexpr Vec2 perpendicular(Vec2 v)
{
    return {-v.y, v.x};
}

/// v/|v|; the zero vector stays zero
inline Vec2 normalized(Vec2 v)
{
    const double l = length(v);
    return l > 0.0 ? v / l : Vec2{};
}

inline bool isFinite(Vec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

} // namespace cradle
