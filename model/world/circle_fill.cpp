// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/preset.h"
#include "model/world/random.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct FillText {
    Q_DECLARE_TR_FUNCTIONS(Preset)
};

/// Above this share of the area random places are too hard to find; a lattice is taken.
constexpr double crowdedFraction = 0.35;

/// Places at random, each tried against those before it by a grid of cells at least 2r wide, and
/// not many more of them than circles: small circles in a large square need few.
std::vector<Vec2> randomPlaces(const CircleFill &fill, double room, Random &random)
{
    const double enough = std::ceil(std::sqrt(static_cast<double>(fill.count)));
    const auto columns =
        static_cast<std::size_t>(std::max(1.0, std::min(room / fill.radius, enough)));
    const double cell = 2.0 * room / static_cast<double>(columns);
    std::vector<std::vector<Vec2>> grid(columns * columns);
    const auto column = [&](double x) {
        return std::min(columns - 1, static_cast<std::size_t>((x + room) / cell));
    };
    const auto isFree = [&](Vec2 p) {
        const std::size_t cx = column(p.x);
        const std::size_t cy = column(p.y);
        for (std::size_t y = cy > 0 ? cy - 1 : 0; y <= std::min(cy + 1, columns - 1); ++y) {
            for (std::size_t x = cx > 0 ? cx - 1 : 0; x <= std::min(cx + 1, columns - 1); ++x) {
                for (Vec2 q : grid[y * columns + x]) {
                    if (lengthSquared(p - q) <= 4.0 * fill.radius * fill.radius)
                        return false;
                }
            }
        }
        return true;
    };
    std::vector<Vec2> places;
    const auto wanted = static_cast<std::size_t>(fill.count);
    for (std::size_t tries = 0; places.size() < wanted && tries < 1000 * wanted; ++tries) {
        const Vec2 p{room * (2.0 * random.uniform() - 1.0), room * (2.0 * random.uniform() - 1.0)};
        if (isFree(p)) {
            grid[column(p.y) * columns + column(p.x)].push_back(p);
            places.push_back(p);
        }
    }
    return places;
}

/// Random sites of a square lattice that fills the square.
std::vector<Vec2> latticePlaces(const CircleFill &fill, double halfWidth, Random &random)
{
    const auto n = static_cast<std::size_t>(halfWidth / fill.radius);
    const double pitch = 2.0 * halfWidth / static_cast<double>(std::max<std::size_t>(n, 1));
    std::vector<Vec2> sites;
    for (std::size_t i = 0; i < n * n; ++i) {
        const std::size_t row = i / n;
        sites.push_back({-halfWidth + (static_cast<double>(i % n) + 0.5) * pitch,
                         -halfWidth + (static_cast<double>(row) + 0.5) * pitch});
    }
    for (std::size_t i = sites.size(); i > 1; --i)
        std::swap(sites[i - 1], sites[random.below(i)]);
    sites.resize(std::min(sites.size(), static_cast<std::size_t>(fill.count)));
    return sites;
}

/// Gaussian velocities with their mean taken out and the rms set.
void setVelocities(std::vector<PresetCircle> &circles, double rmsSpeed, Random &random)
{
    Vec2 mean{};
    for (PresetCircle &c : circles) {
        c.body.velocity = random.gaussian();
        mean += c.body.velocity / static_cast<double>(circles.size());
    }
    double sum = 0.0;
    for (PresetCircle &c : circles) {
        if (circles.size() > 1)
            c.body.velocity -= mean;
        sum += lengthSquared(c.body.velocity);
    }
    const double rms = std::sqrt(sum / static_cast<double>(circles.size()));
    for (PresetCircle &c : circles)
        c.body.velocity = (rms > 0.0 ? rmsSpeed / rms : 0.0) * c.body.velocity;
}

} // namespace

Result<std::vector<PresetCircle>> makeCircles(const CircleFill &fill, double halfWidth)
{
    Random random(fill.seed);
    const double share =
        std::numbers::pi * fill.radius * fill.radius * fill.count / (4.0 * halfWidth * halfWidth);
    std::vector<Vec2> places;
    if (share < crowdedFraction && fill.radius < halfWidth)
        places = randomPlaces(fill, halfWidth - fill.radius, random);
    if (places.size() < static_cast<std::size_t>(fill.count))
        places = latticePlaces(fill, halfWidth, random);
    if (places.size() < static_cast<std::size_t>(fill.count)) {
        return Error{.message = FillText::tr("%1 circles of radius %2 m do not fit into the "
                                             "square; at most %3 are right")
                                    .arg(fill.count)
                                    .arg(fill.radius)
                                    .arg(places.size()),
                     .pointer = QStringLiteral("/circles/fill/count")};
    }
    std::vector<PresetCircle> circles;
    circles.reserve(places.size());
    for (Vec2 place : places) {
        PresetCircle circle;
        circle.name = QStringLiteral("circle %1").arg(circles.size() + 1);
        circle.body = {.position = place, .radius = fill.radius, .density = fill.density};
        circles.push_back(circle);
    }
    setVelocities(circles, fill.rmsSpeed, random);
    return circles;
}

} // namespace cradle
