// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

namespace {

/// Whether a hit turned the part into the wall round and left the other as large as it was.
bool isMirrored(const WallHit &hit)
{
    const Vec2 n = outwardNormal(hit.wall);
    const double along = dot(hit.came, perpendicular(n));
    return dot(hit.came, n) > 0.0 && dot(hit.left, n) < 0.0
           && std::abs(std::abs(dot(hit.left, perpendicular(n))) - std::abs(along)) < 1e-6;
}

} // namespace

bool WallReach::isElsewhere(const WallHit &hit)
{
    return (hit.turned || (hit.held && !hit.isLeap())) && !hit.isLost && !hit.fits(hit.radius);
}

const WallHit &WallReach::tellingOf(const WallHit &hit) const
{
    const auto at = std::find_if(m_own.middle.begin(), m_own.middle.end(), [&](const auto &h) {
        return h.circle == hit.circle && h.wall == hit.wall;
    });
    const bool isTelling = hit.step == 1 && at != m_own.middle.end() && at->turned && at->step > 1
                           && isMirrored(*at) && !looksAhead(hit.circle);
    return isTelling ? *at : hit;
}

bool WallReach::looksAhead(int circle) const
{
    return std::any_of(
               m_own.hits.begin(), m_own.hits.end(),
               [&](const auto &h) { return h.circle == circle && h.step == 1 && isElsewhere(h); })
           && !secondsAhead(circle).empty();
}

std::vector<const WallHit *> WallReach::secondsAhead(int circle) const
{
    std::vector<const WallHit *> far;
    for (const WallHit &hit : m_own.far) {
        const Vec2 v = hit.stage.preset.circles[static_cast<std::size_t>(circle)].body.velocity;
        const double second = dot(v, outwardNormal(hit.wall)) * 1.0; // m in 1 s
        if (hit.circle != circle)
            continue;
        if (!hit.turned || hit.step == 1 || !hit.fits(hit.radius + second))
            return {};
        far.push_back(&hit);
    }
    return far.size() < 2 ? std::vector<const WallHit *>() : far;
}

int WallReach::shownBy(const std::vector<int> &circles) const
{
    return static_cast<int>(
        std::count_if(m_own.hits.begin(), m_own.hits.end(), [&](const WallHit &hit) {
            return std::find(circles.begin(), circles.end(), hit.circle) != circles.end()
                   && isElsewhere(hit);
        }));
}

std::set<Wall> WallReach::wrongWalls(int circle) const
{
    std::set<Wall> walls;
    for (const WallHit &hit : m_own.hits) {
        if (hit.circle == circle && isElsewhere(hit))
            walls.insert(hit.wall);
    }
    return walls;
}

std::vector<std::set<Wall>> WallReach::wallsOfOneLength(int circle) const
{
    const std::set<Wall> all = wrongWalls(circle);
    if (all.empty())
        return {};
    const auto isKnown = [&](const std::set<Wall> &walls) {
        return fittingLengths(circle, walls).size() == 1;
    };
    if (all.size() == 1 || !fittingLengths(circle, all).empty() || oneDistance(circle, all)
        || std::none_of(all.begin(), all.end(),
                        [&](Wall wall) { return isKnown(std::set<Wall>{wall}); }))
        return {all};
    std::vector<std::set<Wall>> each;
    each.reserve(all.size());
    for (const Wall wall : all)
        each.push_back({wall});
    return each;
}

std::vector<WallLength> WallReach::fittingLengths(int circle, const std::set<Wall> &walls) const
{
    std::vector<WallLength> fitting = wallLengths();
    std::erase_if(fitting, [&](const WallLength &reach) { return !fitsAll(reach, circle, walls); });
    return fitting;
}

bool WallReach::fitsAll(const WallLength &reach, int circle, const std::set<Wall> &walls) const
{
    const auto fits = [&](const WallHit &hit) {
        if (hit.circle != circle || !hit.isAnswered() || !walls.contains(hit.wall))
            return true;
        // Who is held at the rim has not come to where it would be turned.
        const double distance = reach.distance(hit);
        return hit.held && hit.fits(hit.radius) ? distance < hit.reached : hit.fits(distance);
    };
    return std::all_of(m_own.hits.begin(), m_own.hits.end(), fits)
           && std::all_of(m_own.alike.begin(), m_own.alike.end(), fits);
}

std::optional<WallReach::Distance> WallReach::oneDistance(int circle,
                                                          const std::set<Wall> &walls) const
{
    Distance one{{}, 0.0, std::numeric_limits<double>::infinity()};
    for (const auto *hits : {&m_own.hits, &m_own.alike}) {
        for (const WallHit &hit : *hits) {
            if (hit.circle != circle || !walls.contains(hit.wall) || !hit.isAnswered())
                continue;
            one.radii.insert(hit.radius);
            one.nearest = std::max(one.nearest, hit.reached);
            one.farthest = std::min(one.farthest, hit.before + hit.travel);
        }
    }
    if (one.radii.size() < 2 || one.nearest > one.farthest)
        return std::nullopt;
    return one;
}

} // namespace cradle
