// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/scene_spec.h"

#include <QJsonArray>

namespace cradle {

namespace {

std::vector<double> numbers(const QJsonValue &list, std::vector<double> fallback)
{
    if (!list.isArray())
        return fallback;
    std::vector<double> result;
    for (const QJsonValue &value : list.toArray())
        result.push_back(value.toDouble());
    return result;
}

} // namespace

SceneSpec::SceneSpec(const CheckSpec &check, double ownTimestep)
    : kind(check.scene.value(QStringLiteral("kind")).toString(QStringLiteral("own")))
    , circles(check.circles)
{
    const auto value = [&](const char *key) { return check.scene.value(QLatin1String(key)); };
    const bool own = kind == QLatin1String("own");
    count = value("count").toInt(count);
    duration = value("duration").toDouble(own ? 10.0 : 2.0);
    timesteps = numbers(value("timesteps"), {own ? ownTimestep : 1.0 / 60.0});
    restitutions = numbers(value("restitutions"), {1.0});
    const auto g = numbers(value("gravity"), {0.0, 0.0});
    gravity = {g[0], g[1]};
    const auto pair = [&](const char *key, Vec2 fallback) {
        const auto list = numbers(value(key), {fallback.x, fallback.y});
        return Vec2{list[0], list[1]};
    };
    speeds = pair("speeds", {1.0, 3.0});
    sideways = pair("sideways", {0.0, 0.0});
    angles = pair("angles", {0.0, 360.0});
    radii = pair("radii", {0.2, 0.2});
    densities = pair("densities", {7.8, 7.8});
    offset = value("offset").toDouble(0.0);
    bothMove = value("both_move").toBool(false);
    again = value("again").toBool(false);
}

} // namespace cradle
