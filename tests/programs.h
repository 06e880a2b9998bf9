// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <QJsonArray>
#include <QJsonObject>

#include <functional>

/// Programs as students write them, right ones and wrong ones, run without the engine: the checks
/// must judge what happens, not how it came about.
namespace cradle::programs {

using Circles = std::vector<Circle>;
/// Moves all circles by one step of \p dt s.
using Moves = std::function<void(Circles &, double dt)>;

/// A scene of circles with equal radii and densities, in the lab's square.
inline Preset scene(const std::vector<Circle> &bodies, Vec2 gravity = {}, double restitution = 1.0)
{
    Preset preset;
    preset.gravity = gravity;
    preset.restitution = restitution;
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Discrete};
    for (const Circle &body : bodies) {
        PresetCircle circle;
        circle.body = body;
        preset.circles.push_back(circle);
    }
    return preset;
}

/// What \p program does in \p preset, written down step by step.
inline Observation observed(const Preset &preset, double duration, const Moves &program)
{
    Observation o{{QStringLiteral("preset"), preset, duration}, Recording{}};
    World world;
    for (const PresetCircle &circle : preset.circles)
        world.circles.push_back(circle.body);
    o.states.append(world);
    while (world.time < duration) {
        program(world.circles, preset.timestep);
        ++world.step;
        world.time = static_cast<double>(world.step) * preset.timestep;
        o.states.append(world);
    }
    return o;
}

inline CheckSpec check(const char *kind, const std::vector<int> &circles = {0},
                       const QJsonObject &parameters = {})
{
    return {.id = QStringLiteral("c"),
            .title = QStringLiteral("a check"),
            .kind = QLatin1String(kind),
            .circles = circles,
            .parameters = parameters};
}

inline QJsonArray json(Vec2 v)
{
    return {v.x, v.y};
}

/// Symplectic Euler, the reference of the later steps.
inline void fall(Circle &c, Vec2 gravity, double dt)
{
    c.velocity += dt * gravity;
    c.position += dt * c.velocity;
}

/// A fault as text, for messages of tests.
inline QByteArray say(const std::optional<Fault> &fault)
{
    return fault ? fault->message.toUtf8() : QByteArray("no fault");
}

} // namespace cradle::programs

/// The judgement must find nothing wrong.
#define VERIFY_ACCEPTED(judgement)                                                                 \
    do {                                                                                           \
        const std::optional<cradle::Fault> fault_ = (judgement);                                   \
        QVERIFY2(!fault_, cradle::programs::say(fault_).constData());                              \
    } while (false)

/// The judgement must find a fault that can be shown, and say it with this word.
#define VERIFY_REFUSED(judgement, word)                                                            \
    do {                                                                                           \
        const std::optional<cradle::Fault> fault_ = (judgement);                                   \
        QVERIFY2(fault_, "it was accepted");                                                       \
        QVERIFY2(fault_->message.contains(word), cradle::programs::say(fault_).constData());       \
        QVERIFY2(fault_->step >= 0, "no moment to show");                                          \
    } while (false)
