// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/collision_detection.h"

#include <algorithm>
#include <array>

namespace cradle {

namespace {

/// A polynomial Σ c[k] s^k of degree 4 at most.
struct Polynomial {
    std::array<double, 5> c{};
    int degree = 4;

    [[nodiscard]] double at(double s) const
    {
        double value = 0.0;
        for (int k = degree; k >= 0; --k)
            value = value * s + c[static_cast<std::size_t>(k)];
        return value;
    }
    [[nodiscard]] Polynomial derivative() const
    {
        Polynomial d;
        d.degree = degree - 1;
        for (int k = 1; k <= degree; ++k)
            d.c[static_cast<std::size_t>(k - 1)] = k * c[static_cast<std::size_t>(k)];
        return d;
    }
};

/// The root of \p p, which has the slope \p slope, between low and high, where its signs differ:
/// Newton's steps, and halvings where they would leave the bracket.
double rootBetween(const Polynomial &p, const Polynomial &slope, double low, double high)
{
    const bool lowIsPositive = p.at(low) > 0.0;
    double s = 0.5 * (low + high);
    // Halvings alone end at neighbouring doubles after 200, whatever the interval.
    for (int i = 0; i < 200; ++i) {
        const double value = p.at(s);
        ((value > 0.0) == lowIsPositive ? low : high) = s;
        double next = s - value / slope.at(s);
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (next == s || next <= low || next >= high)
            break;
        s = next;
    }
    return s;
}

/// The ends of [0, end] and all places between where \p p changes sign, in order: between the
/// places where its derivative changes sign p is monotonic, so each is found.
struct Marks {
    std::array<double, 6> s{};
    std::size_t count = 0;

    void add(double value) { s[count++] = value; }
};

Marks signChanges(const Polynomial &p, double end)
{
    Marks marks;
    marks.add(0.0);
    if (p.degree > 0) {
        const Polynomial slope = p.derivative();
        const Marks turns = signChanges(slope, end);
        for (std::size_t i = 1; i < turns.count; ++i) {
            if ((p.at(turns.s[i - 1]) > 0.0) != (p.at(turns.s[i]) > 0.0))
                marks.add(rootBetween(p, slope, turns.s[i - 1], turns.s[i]));
        }
    }
    marks.add(end);
    return marks;
}

} // namespace

bool overlap(const Circle &a, const Circle &b)
{
    const double sum = a.radius + b.radius;
    return lengthSquared(b.position - a.position) < sum * sum;
}

std::optional<double> timeToLine(double gap, double speed, double curve, double end)
{
    gap = std::max(gap, 0.0);
    if (speed <= 0.0 && curve <= 0.0)
        return std::nullopt;
    const double discriminant = speed * speed + 4.0 * curve * gap;
    if (discriminant < 0.0)
        return std::nullopt;
    const double root = std::sqrt(discriminant);
    // Of the two equal forms of the root the one without cancellation.
    const double s = speed >= 0.0 ? (gap > 0.0 ? 2.0 * gap / (speed + root) : 0.0)
                                  : (root - speed) / (2.0 * curve);
    return s <= end ? std::optional(s) : std::nullopt;
}

std::optional<double> timeToDistance(const Path &a, const Path &b, double distance, double end)
{
    const Vec2 d = b.position - a.position;
    const Vec2 v = b.velocity - a.velocity;
    const Vec2 k = b.curve - a.curve;
    // Rounding may leave two that touch a hair too near: from there they may not come nearer.
    const double gap = std::max(0.0, lengthSquared(d) - distance * distance);
    const double approach = -dot(d, v);
    if (gap == 0.0 && approach > 0.0)
        return 0.0;

    if (k == Vec2{}) {
        if (approach <= 0.0)
            return std::nullopt;
        const double discriminant = approach * approach - lengthSquared(v) * gap;
        if (discriminant < 0.0)
            return std::nullopt;
        const double s = gap / (approach + std::sqrt(discriminant));
        return s <= end ? std::optional(s) : std::nullopt;
    }

    // Too far apart to come that near, whatever the direction.
    const double travel = end * (std::sqrt(lengthSquared(v)) + end * std::sqrt(lengthSquared(k)));
    if (gap > travel * (travel + 2.0 * distance))
        return std::nullopt;
    const Polynomial f{{gap, -2.0 * approach, lengthSquared(v) + 2.0 * dot(d, k), 2.0 * dot(v, k),
                        lengthSquared(k)}};
    const Marks marks = signChanges(f, end);
    for (std::size_t i = 1; i + 1 < marks.count; ++i) {
        // Just past a sign change f is negative only where the centres come nearer.
        const double next = 0.5 * (marks.s[i] + marks.s[i + 1]);
        if (next > marks.s[i] && f.at(next) < 0.0)
            return marks.s[i];
    }
    // Touching now, and curving into each other at once.
    if (gap == 0.0 && f.at(0.5 * marks.s[1]) < 0.0)
        return 0.0;
    return std::nullopt;
}

} // namespace cradle
