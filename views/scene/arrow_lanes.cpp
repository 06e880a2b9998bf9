// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/arrow_lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cradle {

namespace {

constexpr double stepAside = 2.0;      ///< px from one try to the next
constexpr double farthestAside = 60.0; ///< px beyond the largest disc
constexpr double discGap = 6.0;        ///< px: half the width of a head and a little
constexpr double crossingCost = 12.0;  ///< px aside that are worth one crossing less
constexpr double alongside = 0.2;      ///< sine of the angle between arrows that look parallel

double distanceTo(const Stretch &stretch, Vec2 place)
{
    const Vec2 way = stretch.to - stretch.from;
    const double squared = lengthSquared(way);
    const double share =
        squared == 0.0 ? 0.0 : std::clamp(dot(place - stretch.from, way) / squared, 0.0, 1.0);
    return length(place - (stretch.from + share * way));
}

bool crosses(const Stretch &x, const Stretch &y)
{
    const auto apart = [](const Stretch &line, const Stretch &other) {
        const Vec2 way = line.to - line.from;
        return cross(way, other.from - line.from) * cross(way, other.to - line.from) >= 0.0;
    };
    return !apart(x, y) && !apart(y, x);
}

/// How near stretches that look parallel come to each other, m.
double gapBeside(const Stretch &x, const Stretch &y)
{
    const Vec2 u = normalized(x.to - x.from);
    const Vec2 v = normalized(y.to - y.from);
    if (std::abs(cross(u, v)) > alongside)
        return std::numeric_limits<double>::infinity();
    return std::min(
        {distanceTo(x, y.from), distanceTo(x, y.to), distanceTo(y, x.from), distanceTo(y, x.to)});
}

} // namespace

ArrowLanes::ArrowLanes(std::vector<Circle> discs, double pixelsPerMetre)
    : m_discs(std::move(discs))
    , m_scale(pixelsPerMetre)
{
}

void ArrowLanes::occupy(const Stretch &stretch, double gap)
{
    m_lanes.push_back({stretch, gap});
}

Stretch ArrowLanes::place(const Circle &circle, Vec2 shaft)
{
    const Vec2 direction = normalized(shaft);
    double reach = farthestAside;
    for (const Circle &disc : m_discs)
        reach = std::max(reach, disc.radius * m_scale + farthestAside);
    const auto aside = [&](double pixels) {
        const double shift = pixels / m_scale;
        const double rim = std::sqrt(std::max(circle.radius * circle.radius - shift * shift, 0.0));
        const Vec2 from = circle.position + rim * direction + shift * perpendicular(direction);
        return Stretch{from, from + shaft};
    };
    Stretch best = aside(0.0);
    double bestCost = std::numeric_limits<double>::infinity();
    for (double pixels = 0.0; pixels <= std::min(reach, bestCost); pixels += stepAside) {
        for (const double side : {pixels, -pixels}) {
            const Stretch stretch = aside(side);
            if (blocked(stretch, circle))
                continue;
            const double cost = pixels + crossingCost * crossings(stretch);
            if (cost < bestCost) {
                bestCost = cost;
                best = stretch;
            }
        }
    }
    occupy(best);
    return best;
}

bool ArrowLanes::blocked(const Stretch &stretch, const Circle &own) const
{
    return std::any_of(m_discs.begin(), m_discs.end(),
                       [&](const Circle &disc) {
                           return disc.position != own.position
                                  && (distanceTo(stretch, disc.position) - disc.radius) * m_scale
                                         < discGap;
                       })
           || std::any_of(m_lanes.begin(), m_lanes.end(), [&](const Lane &lane) {
                  return gapBeside(stretch, lane.stretch) * m_scale < lane.gap;
              });
}

int ArrowLanes::crossings(const Stretch &stretch) const
{
    return static_cast<int>(std::count_if(m_lanes.begin(), m_lanes.end(), [&](const Lane &lane) {
        return crosses(stretch, lane.stretch);
    }));
}

} // namespace cradle
