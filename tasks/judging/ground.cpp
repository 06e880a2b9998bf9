// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/ground.h"

#include "model/files/preset_json.h"
#include "tasks/judging/asked_laws.h"
#include "tasks/runs/scene_spec.h"
#include "tasks/script/student_script.h"

#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

/// Three timesteps tell every power of it from every other; more only cost time.
constexpr std::size_t mostTimesteps = 3;
constexpr std::size_t mostGravities = 2;

template <class Value>
void addOnce(std::vector<Value> &all, const Value &value, std::size_t most = 100)
{
    if (all.size() < most && std::find(all.begin(), all.end(), value) == all.end())
        all.push_back(value);
}

/// The gravity of the step's own scene: what the reference makes of it.
Vec2 ownGravity(const Task &task)
{
    Preset scene = task.preset;
    if (!task.solution.isEmpty()) {
        StudentScript reference(task.solution, {.pinned = false, .quiet = true, .locked = {}});
        if (!reference.begin(scene))
            return scene.gravity;
    }
    if (task.forStudents)
        return askedLaws(task).scene.gravity;
    return task.solutionScene ? task.solutionScene->gravity : task.preset.gravity;
}

std::vector<double> sharesOf(const CheckSpec &check)
{
    if (check.kind == QLatin1String("closed_form"))
        return {0.5};
    std::vector<double> shares;
    for (const QJsonValue &name : check.parameters.value(QStringLiteral("integrators")).toArray()) {
        if (const auto integrator = integratorFromName(name.toString()))
            addOnce(shares, pathCurvature(*integrator));
    }
    return shares;
}

void includeFlights(Ground &ground, const CheckSpec &check)
{
    ground.sameIntegrator |= isOneOf(check.kind, {"same_integrator", "together"});
    const std::vector<double> shares = sharesOf(check);
    for (const int circle : check.circles) {
        const auto index = static_cast<std::size_t>(circle);
        ground.flights.resize(std::max(ground.flights.size(), index + 1));
        Ground::Flight &flight = ground.flights[index];
        flight.asked = true;
        if (!shares.empty())
            flight.shares = shares;
    }
}

void includeWalls(Ground &ground, const CheckSpec &check, const SceneSpec &scene, Vec2 own)
{
    if (!isOneOf(check.kind, {"bounces", "bounce_heights", "stays_inside", "settles"}))
        return;
    const bool first = ground.walls.circles.empty();
    for (const int circle : check.circles)
        addOnce(ground.walls.circles, circle);
    const bool isOwn = scene.kind == QLatin1String("own");
    // Hits are seen most clearly without gravity.
    if (first || (!isOwn && scene.gravity == Vec2{}))
        ground.walls.gravity = isOwn ? own : scene.gravity;
    if (isOwn)
        return;
    for (const double e : scene.restitutions)
        addOnce(ground.walls.restitutions, e);
    ground.walls.radii.include(scene.radii.x);
    ground.walls.radii.include(scene.radii.y);
}

void includePair(Ground &ground, const CheckSpec &check, const SceneSpec &scene)
{
    if (!isOneOf(check.kind, {"collides", "rebounds", "touches", "conserves", "after_contact",
                              "loses_energy", "passes_through"}))
        return;
    Ground::Pair &pair = ground.pair;
    pair.asked = true;
    if (scene.kind != QLatin1String("encounters"))
        return;
    pair.oblique |= scene.offset > 0.0;
    pair.bothMove |= scene.bothMove;
    for (const double e : scene.restitutions)
        addOnce(pair.restitutions, e);
    pair.radii.include(scene.radii.x);
    pair.radii.include(scene.radii.y);
    pair.densities.include(scene.densities.x);
    pair.densities.include(scene.densities.y);
    // Of several laws that are allowed each may have another use for masses.
    pair.masses |= check.parameters.value(QStringLiteral("laws")).toArray().size() < 2;
}

/// Nowhere near a wall or another, and at no place that a program could know: four in the middle,
/// the first two not opposite each other about the origin, and those of a crowd above and below.
Vec2 placeOf(std::size_t circle)
{
    static constexpr Vec2 central[] = {{-1.37, 0.83}, {1.21, -0.24}, {2.93, 1.58}, {-1.52, -1.71}};
    static constexpr double rows[] = {3.17, -3.23, 2.51, -2.57};
    constexpr std::size_t perRow = 8;
    if (circle < std::size(central))
        return central[circle];
    const std::size_t i = circle - std::size(central);
    return {-3.07 + 0.89 * static_cast<double>(i % perRow), rows[(i / perRow) % std::size(rows)]};
}

} // namespace

void Ground::Range::include(double value)
{
    low = std::min(low, value);
    high = std::max(high, value);
}

Ground::Ground(const Task &task, const Preset &preset)
    : own(preset)
{
    const Vec2 g = ownGravity(task);
    addOnce(gravities, g);
    for (const CheckSpec &check : task.checks) {
        const SceneSpec scene(check, own.timestep);
        if (scene.kind != QLatin1String("own"))
            addOnce(gravities, scene.gravity, mostGravities);
        for (const double timestep : scene.timesteps)
            addOnce(timesteps, timestep, mostTimesteps);
        includeFlights(*this, check);
        includeWalls(*this, check, scene, g);
        includePair(*this, check, scene);
    }
    if (pair.asked)
        flights.resize(std::max<std::size_t>(flights.size(), 2));
    for (Flight &flight : flights) {
        if (!flight.shares.empty())
            continue;
        flight.shares = {0.0, 0.5, 1.0};
        flight.isAnyMethod = !sameIntegrator;
    }
    if (walls.restitutions.empty())
        walls.restitutions = {1.0};
    if (pair.restitutions.empty())
        pair.restitutions = {1.0};
}

Preset Ground::stage() const
{
    Preset preset = own;
    preset.fill.reset();
    preset.halfWidth = 4.0;
    preset.gravity = {};
    preset.restitution = 1.0;
    preset.timestep = timesteps.empty() ? own.timestep : timesteps.front();
    preset.circles.resize(std::max(flights.size(), std::size_t{1}));
    for (std::size_t i = 0; i < preset.circles.size(); ++i)
        preset.circles[i].body = {.position = placeOf(i)};
    return preset;
}

} // namespace cradle
