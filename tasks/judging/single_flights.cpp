// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_reading.h"

#include "tasks/judging/flight_scenes.h"

#include <algorithm>
#include <cmath>

namespace cradle {

using namespace flights;

std::optional<Flight::Step> measureHeavierFall(const QString *program, const Ground &ground,
                                               Vec2 gravity, double h, std::size_t i)
{
    Preset preset = flightPreset(ground, gravity, h, Scene::Rest);
    // The others stay as they are: its fall may hang on their masses, too.
    preset.circles[i].body.radius *= 1.25;
    preset.circles[i].body.density *= 1.5;
    return secondStep(fly(program, preset), i);
}

std::optional<Flight::Step> measureWhileOthersRest(const QString *program, const Ground &ground,
                                                   Vec2 gravity, double h, std::size_t i)
{
    return secondStep(fly(program, flightPreset(ground, gravity, h, Scene::Apart, i)), i);
}

std::optional<Flight::Step> measureWithRestitution(const QString *program, const Ground &ground,
                                                   Vec2 gravity, double h, std::size_t i,
                                                   double restitution)
{
    Preset preset = flightPreset(ground, gravity, h, Scene::First);
    preset.restitution = restitution;
    return secondStep(fly(program, preset), i);
}

std::optional<Flight::Step> measureSlowStart(const QString *program, const Ground &ground,
                                             double slower, double h, std::size_t i)
{
    Preset preset = flightPreset(ground, {}, h, Scene::First);
    for (auto &each : preset.circles)
        each.body.velocity = slower * each.body.velocity;
    Probe probe(program, {preset, true});
    const Circle &start = preset.circles[i].body;
    if (!probe.runs() || !probe.step())
        return std::nullopt;
    const Circle &now = probe.circle(static_cast<int>(i));
    return Flight::Step{start.velocity, now.position - start.position,
                        now.velocity - start.velocity};
}

std::vector<Flight::Step> measureFirstSteps(const QString *program, const Ground &ground,
                                            Vec2 gravity, double h, std::size_t i, FirstSteps which,
                                            int count)
{
    const Preset preset = flightPreset(ground, gravity, h, Scene::First);
    Probe probe(program, {preset, true});
    const auto isFreeAt = [&](const Circle &c, Vec2 place) {
        return std::max(std::abs(place.x), std::abs(place.y)) < preset.halfWidth - 2.0 * c.radius;
    };
    std::vector<Flight::Step> steps;
    // Who is put back at a wall was there: where the steps before would bring it counts, too.
    const auto isFree = [&](const Circle &before, const Circle &now) {
        const Vec2 turn = steps.empty() ? Vec2{} : steps.back().turn;
        const Vec2 way = steps.empty() ? Vec2{} : steps.back().way;
        const Vec2 more = steps.size() < 2 ? Vec2{} : way - steps[steps.size() - 2].way;
        return isFreeAt(before, before.position) && isFreeAt(before, now.position)
               && isFreeAt(before, before.position + h * before.velocity)
               && isFreeAt(before, before.position + h * (before.velocity + turn))
               && isFreeAt(before, before.position + way + more);
    };
    while (probe.runs() && static_cast<int>(steps.size()) < count) {
        if (which == FirstSteps::Repeated) {
            World again = probe.world();
            for (std::size_t k = 0; k < again.circles.size(); ++k)
                again.circles[k] = preset.circles[k].body;
            probe.place(again);
        }
        const Circle before = probe.circle(static_cast<int>(i));
        if (!probe.step())
            break;
        const Circle &now = probe.circle(static_cast<int>(i));
        if (!isFree(before, now))
            break;
        steps.push_back(
            {before.velocity, now.position - before.position, now.velocity - before.velocity});
    }
    return steps;
}

Stage flightStage(const Ground &ground, Vec2 gravity, double h, Flight::Speed speed)
{
    const Scene scene = speed == Flight::Speed::Fast   ? Scene::Fast
                        : speed == Flight::Speed::Slow ? Scene::Slow
                                                       : Scene::First;
    return {flightPreset(ground, gravity, h, scene), true};
}

} // namespace cradle
