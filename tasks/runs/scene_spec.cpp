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
    : circles(check.circles)
{
    const auto value = [&](const char *key) { return check.scene.value(QLatin1String(key)); };
    const auto take = [&](const char *key, Vec2 &pair) {
        const auto list = numbers(value(key), {pair.x, pair.y});
        pair = {list[0], list[1]};
    };
    kind = value("kind").toString(kind);
    if (isOwn()) {
        duration = ownDuration;
        timesteps = {ownTimestep};
    }
    count = value("count").toInt(count);
    duration = value("duration").toDouble(duration);
    timesteps = numbers(value("timesteps"), timesteps);
    restitutions = numbers(value("restitutions"), restitutions);
    take("gravity", gravity);
    take("speeds", speeds);
    take("sideways", sideways);
    take("angles", angles);
    take("radii", radii);
    take("densities", densities);
    offset = value("offset").toDouble(offset);
    bothMove = value("both_move").toBool(bothMove);
    again = value("again").toBool(again);
}

bool showsOwnScene(const CheckSpec &check)
{
    return SceneSpec(check, 1.0).isOwn();
}

} // namespace cradle
