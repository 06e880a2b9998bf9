// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/parameter_makers.h"
#include "tasks/runs/scene_spec.h"

#include <QCoreApplication>
#include <QJsonArray>

namespace cradle {

namespace {

using namespace parameters;
using Type = ParameterInfo::Type;

struct SceneText {
    Q_DECLARE_TR_FUNCTIONS(CheckKinds)
};

ParameterInfo duration(double standard)
{
    return usually(inUnit(make("duration", Type::Number, SceneText::tr("Duration"),
                               SceneText::tr("How long every scene runs")),
                          "s", {1e-3, 600.0}),
                   standard);
}

ParameterInfo timesteps()
{
    return inUnit(make("timesteps", Type::Numbers, SceneText::tr("Timesteps"),
                       SceneText::tr("The scenes take turns with these; 1/60 s if left out, in the "
                                     "student's own scene its own")),
                  "s", {1e-6, 0.1});
}

/// What holds where a scene leaves something out.
const SceneSpec &standard()
{
    static const SceneSpec spec;
    return spec;
}

QJsonArray asJson(Vec2 pair)
{
    return {pair.x, pair.y};
}

ParameterInfo range(const char *name, const QString &label, const char *unit, Bounds bounds,
                    Vec2 usual)
{
    return usually(inUnit(make(name, Type::Range, label,
                               SceneText::tr("Drawn between the least and the most")),
                          unit, bounds),
                   asJson(usual));
}

ParameterInfo speeds(double most)
{
    return range("speeds", SceneText::tr("Speeds"), "m/s", {0.0, most}, standard().speeds);
}

ParameterInfo angles()
{
    return usually(inUnit(make("angles", Type::Range, SceneText::tr("Angles"),
                               SceneText::tr("From the x axis; the scenes divide them evenly")),
                          "°", {-360.0, 360.0}),
                   asJson(standard().angles));
}

/// What all scenes share that the application makes up.
std::vector<ParameterInfo> drawn(std::vector<ParameterInfo> own)
{
    std::vector<ParameterInfo> all{
        usually(inUnit(make("count", Type::Count, SceneText::tr("Scenes"),
                            SceneText::tr("How many scenes are drawn")),
                       "", {1.0, 200.0}),
                standard().count),
        duration(standard().duration), timesteps()};
    for (ParameterInfo &info : own)
        all.push_back(std::move(info));
    all.push_back(range("radii", SceneText::tr("Radii"), "m", {0.01, 1.0}, standard().radii));
    all.push_back(range("densities", SceneText::tr("Densities"), "1000 kg/m³", {1e-3, 1e3},
                        standard().densities));
    all.push_back(usually(inUnit(make("gravity", Type::Vector, SceneText::tr("Gravity"),
                                      SceneText::tr("None if left out")),
                                 "m/s²", {-1000.0, 1000.0}),
                          asJson(standard().gravity)));
    all.push_back(
        usually(inUnit(make("restitutions", Type::Numbers, SceneText::tr("Restitutions e"),
                            SceneText::tr("The scenes take turns with these")),
                       "", {0.0, 1.0}),
                QJsonArray{standard().restitutions.front()}));
    all.push_back(inUnit(make("seed", Type::Count, SceneText::tr("Seed"),
                              SceneText::tr("The same scenes in every check; drawn anew with the "
                                            "seed of the check if left out")),
                         "", {0.0, 1e9}));
    return all;
}

KindInfo scene(const char *name, const QString &title, const QString &purpose, int circles,
               std::vector<ParameterInfo> parameters)
{
    return {QLatin1String(name), title, purpose, circles, std::move(parameters)};
}

} // namespace

std::vector<KindInfo> sceneKinds()
{
    return {
        scene("own", SceneText::tr("The student's own scene"),
              SceneText::tr("With each of the timesteps"), 1,
              {duration(SceneSpec::ownDuration), timesteps()}),
        scene("flight", SceneText::tr("Throws"),
              SceneText::tr("The circles thrown together from the middle, in any direction"), 1,
              drawn({speeds(20.0), angles()})),
        scene("directions", SceneText::tr("Shots in all directions"),
              SceneText::tr("Each of the circles at the walls, all round, while the others move on "
                            "where nothing meets them"),
              1, drawn({speeds(20.0), angles()})),
        scene(
            "corners", SceneText::tr("Shots at the corners"),
            SceneText::tr("Each of the circles straight at the corners and just beside them, while "
                          "the others move on where nothing meets them"),
            1, drawn({speeds(20.0)})),
        scene("encounters", SceneText::tr("Encounters"),
              SceneText::tr("Circles 1 and 2 thrown so that they meet, from all angles"), 2,
              drawn({speeds(3.0), angles(),
                     usually(inUnit(make("offset", Type::Number, SceneText::tr("Off centre"),
                                         SceneText::tr("How far off centre they meet at most, in "
                                                       "r₁ + r₂")),
                                    "", {0.0, 0.95}),
                             standard().offset),
                     usually(make("both_move", Type::Flag, SceneText::tr("Both move"),
                                  SceneText::tr("Also one after the other, or one of them at rest; "
                                                "else circle 2 rests before the hit")),
                             standard().bothMove),
                     usually(
                         make("again", Type::Flag, SceneText::tr("Again at once"),
                              SceneText::tr(
                                  "Some, between equal circles, are in front of a wall that sends "
                                  "circle 2 back to a second hit, with another line of centres; "
                                  "in two more the heavier circle meets the other twice on one "
                                  "line, which a wall sends back")),
                         standard().again)})),
        scene("parting", SceneText::tr("Circles that part"),
              SceneText::tr("Circles 1 and 2 overlap, as after a hit that was told late, and move "
                            "apart already; ask for 0 hits"),
              2, drawn({speeds(3.0), angles()})),
        scene("slow", SceneText::tr("Slow hits"),
              SceneText::tr("The circles come slowly to the floor and to the ceiling, sooner or "
                            "later in a step: what leaves a wall more slowly than it came is "
                            "easily turned twice. Some are let go at rest, just above the floor"),
              1, drawn({})),
        scene(
            "drop", SceneText::tr("Drops"),
            SceneText::tr("The circles fall onto the floor; in the last scene, where e is 1, from "
                          "so low that they bounce often"),
            1,
            drawn({usually(inUnit(make("sideways", Type::Range, SceneText::tr("Sideways"),
                                       SceneText::tr("Speed to the right, drawn between the least "
                                                     "and the most")),
                                  "m/s", {-3.0, 3.0}),
                           asJson(standard().sideways))})),
    };
}

} // namespace cradle
