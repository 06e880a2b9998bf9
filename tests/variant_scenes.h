// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/variant.h"

#include "tests/programs.h"
#include "tests/scenes.h"

namespace cradle::programs {

/// Two circles, a fill, odd values everywhere: nothing of it may show where it is pinned.
inline Preset odd()
{
    Preset preset = scene({{.position = {1.0, 1.0}, .velocity = {3.0, 0.0}, .radius = 0.3},
                           {.position = {-1.0, 1.0}},
                           {.position = {-3.0, -3.0}}},
                          {1.0, -2.0}, 0.3);
    preset.halfWidth = 5.0;
    preset.timestep = 1.0 / 100.0;
    preset.circles[0].integrator = Integrator::Verlet;
    preset.circles[1].integrator = Integrator::SymplecticEuler;
    return preset;
}

/// A check of circles 1 and 2 in twelve scenes of \p kind, with a range for everything.
inline CheckSpec spec(const QString &kind)
{
    CheckSpec made = check("collides", {0, 1});
    made.scene = {{QStringLiteral("kind"), kind},
                  {QStringLiteral("count"), 12},
                  {QStringLiteral("duration"), 1.5},
                  {QStringLiteral("gravity"), json({0.0, -9.81})},
                  {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0, 1.0 / 120.0}},
                  {QStringLiteral("restitutions"), QJsonArray{0.0, 0.5, 1.0}},
                  {QStringLiteral("speeds"), QJsonArray{1.0, 4.0}},
                  {QStringLiteral("radii"), QJsonArray{0.1, 0.4}},
                  {QStringLiteral("densities"), QJsonArray{1.0, 10.0}},
                  {QStringLiteral("offset"), 0.9},
                  {QStringLiteral("both_move"), true}};
    return made;
}

} // namespace cradle::programs
