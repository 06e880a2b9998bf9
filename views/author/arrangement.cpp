// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/arrangement.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

namespace cradle {

namespace {

struct ArrangementText {
    Q_DECLARE_TR_FUNCTIONS(Arrangement)
};

constexpr int mostCircles = 100; ///< that checks can look at
constexpr double strikerSpeed = 3.0;

/// The middles of the circles of a rack, its tip at the left.
std::vector<Vec2> rack(int columns, double spacing)
{
    std::vector<Vec2> places;
    const double width = spacing * std::sqrt(0.75);
    for (int column = 0; column < columns; ++column) {
        for (int k = 0; k <= column; ++k)
            places.push_back({width * column, spacing * (0.5 * column - k)});
    }
    return places;
}

std::vector<Vec2> grid(int rows, int columns, double spacing)
{
    std::vector<Vec2> places;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            places.push_back(
                {spacing * (column - 0.5 * (columns - 1)), spacing * (0.5 * (rows - 1) - row)});
    }
    return places;
}

/// Neighbours on it are \p spacing apart; the first is at the right.
std::vector<Vec2> ring(int count, double spacing)
{
    if (count == 1)
        return {Vec2{}};
    std::vector<Vec2> places;
    const double half = std::numbers::pi / count;
    const double size = 0.5 * spacing / std::sin(half);
    for (int i = 0; i < count; ++i)
        places.push_back({size * std::cos(2 * half * i), size * std::sin(2 * half * i)});
    return places;
}

std::vector<Vec2> placesOf(const Arrangement &a)
{
    const double spacing = 2 * a.radius + a.gap;
    switch (a.pattern) {
    case Arrangement::Pattern::Rack:
        return rack(a.rows, spacing);
    case Arrangement::Pattern::Grid:
        return grid(a.rows, a.columns, spacing);
    case Arrangement::Pattern::Ring:
        break;
    }
    return ring(a.rows, spacing);
}

/// To a micrometre: numbers that can be read.
double rounded(double length)
{
    return std::round(length * 1e6) / 1e6 + 0.0;
}

void addCircle(Preset &preset, Vec2 position, Vec2 velocity, double radius, const char *colour)
{
    PresetCircle circle;
    circle.name = QStringLiteral("circle %1").arg(preset.circles.size() + 1);
    circle.colour = QLatin1String(colour);
    circle.body.position = {rounded(position.x), rounded(position.y)};
    circle.body.velocity = velocity;
    circle.body.radius = radius;
    preset.circles.push_back(circle);
}

} // namespace

QString nameOf(Arrangement::Pattern pattern)
{
    switch (pattern) {
    case Arrangement::Pattern::Rack:
        return ArrangementText::tr("Rack");
    case Arrangement::Pattern::Grid:
        return ArrangementText::tr("Grid");
    case Arrangement::Pattern::Ring:
        break;
    }
    return ArrangementText::tr("Ring");
}

int countOf(const Arrangement &a)
{
    const int striker = a.hasStriker ? 1 : 0;
    switch (a.pattern) {
    case Arrangement::Pattern::Rack:
        return striker + a.rows * (a.rows + 1) / 2;
    case Arrangement::Pattern::Grid:
        return striker + a.rows * a.columns;
    case Arrangement::Pattern::Ring:
        break;
    }
    return striker + a.rows;
}

Result<Preset> presetOf(const Arrangement &a)
{
    if (countOf(a) > mostCircles)
        return Error{.message = ArrangementText::tr("%1 circles are too many: at most %2 are right")
                                    .arg(countOf(a))
                                    .arg(mostCircles)};
    Preset preset;
    preset.name = nameOf(a.pattern);
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    const double room = preset.halfWidth - a.radius;
    // The striker has a way of its own, of at least two radii.
    const double striker = -room + a.radius;
    if (a.hasStriker)
        addCircle(preset, {striker, 0.0}, {strikerSpeed, 0.0}, a.radius, "#1e90ff");
    for (const Vec2 place : placesOf(a)) {
        const bool fits = std::abs(place.x) <= room && std::abs(place.y) <= room;
        if (!fits || (a.hasStriker && place.x - striker < 4 * a.radius))
            return Error{.message = ArrangementText::tr(
                             "They do not fit into the square: fewer or smaller ones are right")};
        addCircle(preset, place, {}, a.radius, "#e03131");
    }
    return preset;
}

} // namespace cradle
