// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/preset.h"

#include "model/world/shortest_number.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <numeric>

namespace cradle {

namespace {

struct PresetText {
    Q_DECLARE_TR_FUNCTIONS(Preset)
};

Error fault(const QString &pointer, const QString &message)
{
    return {.message = message, .pointer = pointer};
}

/// Refuses what is not in [low, high]; NaN is in no range.
std::optional<Error> outOfRange(double value, double low, double high, const QString &pointer,
                                const char *unit)
{
    if (value >= low && value <= high)
        return std::nullopt;
    const QString bound =
        (shortestNumber(high) + QLatin1Char(' ') + QString::fromUtf8(unit)).trimmed();
    return fault(pointer, PresetText::tr("%1 is out of range; a number from %2 to %3 is right")
                              .arg(shortestNumber(value), shortestNumber(low), bound));
}

std::optional<Error> outOfRange(Vec2 value, double bound, const QString &pointer, const char *unit)
{
    if (auto error = outOfRange(value.x, -bound, bound, pointer + QStringLiteral("/0"), unit))
        return error;
    return outOfRange(value.y, -bound, bound, pointer + QStringLiteral("/1"), unit);
}

std::optional<Error> faultOfName(const QString &name, const QString &pointer)
{
    if (name.size() <= limits::maxName)
        return std::nullopt;
    return fault(pointer, PresetText::tr("the name is too long; at most %1 characters are right")
                              .arg(limits::maxName));
}

std::optional<Error> faultOfColour(const QString &colour, const QString &pointer)
{
    static const QRegularExpression form(QStringLiteral("^#[0-9a-fA-F]{6}$"));
    if (form.match(colour).hasMatch())
        return std::nullopt;
    return fault(
        pointer,
        PresetText::tr("\"%1\" is no colour; one like #1e90ff is right").arg(colour.left(60)));
}

std::optional<Error> faultOfCircle(const PresetCircle &circle, const QString &place)
{
    const Circle &body = circle.body;
    const auto at = [&](const char *key) { return place + QLatin1String(key); };
    if (auto e = faultOfName(circle.name, at("/name")))
        return e;
    if (auto e = faultOfColour(circle.colour, at("/colour")))
        return e;
    if (auto e = outOfRange(body.position, limits::maxLength, at("/position"), "m"))
        return e;
    if (auto e = outOfRange(body.velocity, limits::maxSpeed, at("/velocity"), "m/s"))
        return e;
    if (auto e = outOfRange(body.radius, limits::minLength, limits::maxLength, at("/radius"), "m"))
        return e;
    return outOfRange(body.density, limits::minDensity, limits::maxDensity, at("/density"),
                      "· 1000 kg/m³");
}

QString circlePlace(std::size_t index)
{
    return QStringLiteral("/circles/%1").arg(index);
}

std::optional<Error> faultOfWalls(const Preset &preset)
{
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        const Circle &c = preset.circles[i].body;
        const double room = preset.halfWidth - c.radius;
        const double slack = limits::overlapTolerance * c.radius;
        if (std::abs(c.position.x) > room + slack || std::abs(c.position.y) > room + slack) {
            const QString range = room < 0.0
                                      ? PresetText::tr("it is wider than the square")
                                      : PresetText::tr("x and y from %1 to %2 m are right")
                                            .arg(shortestNumber(-room), shortestNumber(room));
            return fault(circlePlace(i) + QStringLiteral("/position"),
                         PresetText::tr("circle %1 at (%2, %3) m is not inside the square, whose "
                                        "walls reflect; %4")
                             .arg(QString::number(i + 1), shortestNumber(c.position.x),
                                  shortestNumber(c.position.y), range));
        }
    }
    return std::nullopt;
}

/// The first overlapping pair, found along x so that a crowd costs little.
std::optional<Error> faultOfOverlap(const Preset &preset)
{
    const auto &circles = preset.circles;
    std::vector<std::size_t> order(circles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto left = [&](std::size_t i) {
        return circles[i].body.position.x - circles[i].body.radius;
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const Circle &a = circles[order[k]].body;
        for (std::size_t l = k + 1; l < order.size(); ++l) {
            const Circle &b = circles[order[l]].body;
            if (left(order[l]) > a.position.x + a.radius)
                break;
            const double sum = a.radius + b.radius;
            const double distance = length(b.position - a.position);
            if (distance < sum * (1.0 - limits::overlapTolerance)) {
                const auto [i, j] = std::minmax(order[k], order[l]);
                return fault(circlePlace(j) + QStringLiteral("/position"),
                             PresetText::tr("circles %1 and %2 overlap: their centres are %3 m "
                                            "apart; at least r₁ + r₂ = %4 m is right")
                                 .arg(QString::number(i + 1), QString::number(j + 1),
                                      shortestNumber(distance), shortestNumber(sum)));
            }
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Error> findFault(const Preset &preset)
{
    if (auto e = faultOfName(preset.name, QStringLiteral("/name")))
        return e;
    if (auto e = outOfRange(preset.halfWidth, limits::minLength, limits::maxLength,
                            QStringLiteral("/square/half_width"), "m"))
        return e;
    if (auto e =
            outOfRange(preset.gravity, limits::maxAcceleration, QStringLiteral("/gravity"), "m/s²"))
        return e;
    if (auto e = outOfRange(preset.restitution, 0.0, 1.0, QStringLiteral("/restitution"), ""))
        return e;
    if (auto e = outOfRange(preset.timestep, limits::minTimestep, limits::maxTimestep,
                            QStringLiteral("/timestep"), "s"))
        return e;
    if (preset.circles.size() > std::size_t{limits::maxCircles})
        return fault(QStringLiteral("/circles"),
                     PresetText::tr("at most %1 circles are right").arg(limits::maxCircles));
    for (std::size_t i = 0; i < preset.circles.size(); ++i) {
        if (auto e = faultOfCircle(preset.circles[i], circlePlace(i)))
            return e;
    }
    if (preset.laws.walls != WallLaw::None) {
        if (auto e = faultOfWalls(preset))
            return e;
    }
    if (preset.laws.circles != CircleLaw::None)
        return faultOfOverlap(preset);
    return std::nullopt;
}

} // namespace cradle
