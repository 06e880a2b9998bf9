// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_wall.h"

#include "tasks/judging/likeness.h"
#include "tasks/judging/wall_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

double middleOf(const std::vector<double> &restitutions)
{
    return *std::min_element(restitutions.begin(), restitutions.end(), [](double a, double b) {
        return std::abs(a - 0.6) < std::abs(b - 0.6);
    });
}

bool WallHit::fits(double distance) const
{
    return reached - 1e-9 <= distance && distance <= before + travel + 1e-9;
}

AnswerGap answerGap(const WallHit &own, const WallHit &right)
{
    constexpr double slack = 1e-3;
    const Vec2 asked = own.stage.preset.timestep * own.stage.preset.gravity;
    const auto blurAlong = [&](Vec2 direction, double share) {
        const double fall =
            std::max(std::abs(dot(direction, asked)), std::abs(dot(direction, own.came - own.was)));
        return (slack + 1.1 * fall / std::abs(dot(direction, own.came))) * (1.0 + std::abs(share));
    };
    const Vec2 n = outwardNormal(own.wall);
    return {.off = {std::abs(own.back - right.back), std::abs(own.along - right.along)},
            .blur = {blurAlong(n, right.back), blurAlong(perpendicular(n), right.along)}};
}

MeasuredWalls::MeasuredWalls(const QString *program, const Ground &ground,
                             const MeasuredFlight &flight)
{
    const WallRange range(program, ground, flight);
    std::vector<double> all = ground.walls.restitutions;
    std::sort(all.begin(), all.end());
    for (const int circle : ground.walls.circles) {
        if (!range.isKnown(circle))
            continue;
        judged.push_back(circle);
        blur = range.blur();
        for (const Wall wall : allWalls) {
            for (int place = 0; place < 2; ++place)
                hits.push_back(range.shoot(circle, wall, all.back(), place, false));
        }
        std::vector<double> others;
        std::copy_if(all.begin(), all.end(), std::back_inserter(others),
                     [&](double e) { return e != all.back(); });
        for (std::size_t i = 0; !others.empty() && i < 4; ++i)
            hits.push_back(range.shoot(circle, allWalls[i], middleOf(others), 0, false));
        for (const double e : others) {
            if (e != middleOf(others))
                hits.push_back(range.shoot(circle, Wall::Right, e, 1, false));
        }
        for (const Wall wall : allWalls) {
            const bool isOff = std::any_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
                return hit.circle == circle && hit.wall == wall && hit.turned
                       && std::abs(hit.back - hit.restitution) > 2.0 * blur;
            });
            if (!isOff)
                continue;
            denser.push_back(range.shootDenser(circle, wall, middleOf(all)));
            slanted.push_back(range.shootSlanted(circle, wall, middleOf(all)));
            if (!others.empty())
                slower.push_back(range.shootSlower(circle, wall, middleOf(others)));
        }
        findLost(circle);
        for (const Wall wall : allWalls) {
            const bool isOpen = std::none_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
                return hit.circle == circle && hit.wall == wall && hit.isAnswered();
            });
            if (const auto found = isOpen ? range.lend(circle, wall, all.back()) : std::nullopt)
                lent.push_back(*found);
        }
        for (const Wall wall : {Wall::Right, Wall::Bottom, Wall::Left, Wall::Top})
            slow.push_back(range.creep(circle, wall, middleOf(all)));
        for (const Wall wall : {Wall::Right, Wall::Top, Wall::Left, Wall::Bottom})
            corners.push_back(range.shoot(circle, wall, all.back(), 0, true));
        const bool isElsewhere = std::any_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
            return hit.circle == circle && hit.isAnswered() && !hit.fits(hit.radius);
        });
        for (const Wall wall : allWalls) {
            for (const bool large : {true, false}) {
                if (isElsewhere && ground.walls.radii.isVaried())
                    alike.push_back(range.shootAmongAlike(circle, wall, all.back(), large));
            }
        }
        const bool turnsAtOnce = std::any_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
            return hit.circle == circle && hit.turned && hit.step == 1;
        });
        for (const Wall wall : allWalls) {
            const bool isAtOnce = std::any_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
                return hit.circle == circle && hit.wall == wall && hit.turned && hit.step == 1;
            });
            if (isAtOnce)
                middle.push_back(range.comeFromMiddle(circle, wall, all.back()));
        }
        for (const double speed : {0.9, 0.45}) {
            if (turnsAtOnce)
                far.push_back(range.comeFromFar(circle, speed));
        }
        if (!range.canDrop(circle))
            continue;
        for (const double height : {0.0113, 0.0247, 0.0391})
            drops.push_back(range.drop(circle, all.back(), height));
        for (const double speed : {0.2, 0.5, 0.8, 1.1, 1.4})
            drops.push_back(range.lob(circle, all.back(), speed));
        if (all.size() > 1)
            drops.push_back(range.drop(circle, *std::min_element(all.begin(), all.end()), 0.0247));
    }
}

MeasuredWalls::Between MeasuredWalls::between(int circle, Wall wall, double radii) const
{
    Between place{-std::numeric_limits<double>::infinity(),
                  std::numeric_limits<double>::infinity()};
    for (const WallHit &hit : hits) {
        if (hit.circle != circle || hit.wall != wall || !(hit.turned || hit.held))
            continue;
        place.from = std::max(place.from, hit.reached - radii * hit.radius);
        place.to = std::min(place.to, hit.before + hit.travel - radii * hit.radius);
    }
    return place;
}

bool MeasuredWalls::hasOnePlace(int circle, Wall wall) const
{
    // Where one place would do for all, of the centre or of the rim, there the wall turns circles.
    return between(circle, wall, 0.0).isOnePlace() || between(circle, wall, 1.0).isOnePlace();
}

double MeasuredWalls::placeOf(int circle, Wall wall, double radius) const
{
    if (turnsAtRim(circle, wall))
        return radius;
    for (const double radii : {1.0, 0.0}) {
        const Between place = between(circle, wall, radii);
        if (place.isOnePlace() && std::isfinite(place.from))
            return std::min(place.from + radii * radius, radius);
    }
    return radius;
}

bool MeasuredWalls::turnsAtRim(int circle, Wall wall) const
{
    return std::all_of(hits.begin(), hits.end(), [&](const WallHit &hit) {
        return hit.circle != circle || hit.wall != wall || !hit.turned || hit.fits(hit.radius);
    });
}

namespace {

/// Whether it came from the middle, flew a while and was turned there.
bool isFarTurn(const WallHit &hit)
{
    return hit.turned && hit.step > 1 && hit.back > 0.0;
}

} // namespace

bool MeasuredWalls::turnsFarAt(int circle, Wall wall, double distance) const
{
    return std::any_of(middle.begin(), middle.end(), [&](const WallHit &hit) {
        return hit.circle == circle && hit.wall == wall && isFarTurn(hit) && distance < hit.before;
    });
}

double MeasuredWalls::freeRoom() const
{
    double room = std::numeric_limits<double>::infinity();
    for (const WallHit &hit : middle) {
        if (isFarTurn(hit))
            room = std::min(room, hit.stage.preset.halfWidth - hit.before);
    }
    return room;
}

void MeasuredWalls::findLost(int circle)
{
    for (WallHit &hit : hits) {
        if (hit.circle == circle)
            hit.isLost = (hit.turned || hit.held) && hit.isFar() && !hasOnePlace(circle, hit.wall);
    }
}

bool MeasuredWalls::isLike(const MeasuredWalls &other) const
{
    if (hits.size() != other.hits.size() || drops.size() != other.drops.size())
        return false;
    // Who stands still for that step is not who loses a part of its way.
    const auto isOtherAlike = [](const WallHit &a, const WallHit &b) {
        const Vec2 one = a.otherWas.position - a.otherFree.position;
        const Vec2 two = b.otherWas.position - b.otherFree.position;
        return !a.disturbs || length(one - two) <= 0.2 * std::max(length(one), length(two));
    };
    const auto hitAlike = [&](const WallHit &a, const WallHit &b) {
        if (a.missed || b.missed)
            return a.missed == b.missed;
        if (a.turned != b.turned || a.held != b.held || a.disturbs != b.disturbs
            || a.isLeap() != b.isLeap() || !isOtherAlike(a, b)
            || a.near.has_value() != b.near.has_value()
            || a.unchanged.has_value() != b.unchanged.has_value())
            return false;
        if (!a.turned)
            return true;
        return isAlike(a.back, b.back, blur) && isAlike(a.along, b.along, blur)
               && a.stays == b.stays && (a.again > 0) == (b.again > 0)
               && a.reached <= b.before + b.travel && b.reached <= a.before + a.travel;
    };
    const auto dropAlike = [](const Drop &a, const Drop &b) {
        return (a.again > 0) == (b.again > 0) && std::abs(a.depth - b.depth) < 0.02;
    };
    return std::equal(hits.begin(), hits.end(), other.hits.begin(), hitAlike)
           && std::equal(corners.begin(), corners.end(), other.corners.begin(), other.corners.end(),
                         hitAlike)
           && std::equal(slow.begin(), slow.end(), other.slow.begin(), other.slow.end(),
                         [](const WallHit &a, const WallHit &b) { return a.turned == b.turned; })
           && std::equal(drops.begin(), drops.end(), other.drops.begin(), dropAlike);
}

} // namespace cradle
