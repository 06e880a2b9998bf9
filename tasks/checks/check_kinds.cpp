// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"

#include "tasks/checks/check_parameters.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>
#include <QJsonObject>

#include <algorithm>
#include <map>

namespace cradle {

namespace {

using namespace parameters;
using Type = ParameterInfo::Type;

struct KindText {
    Q_DECLARE_TR_FUNCTIONS(CheckKinds)
};

/// Of places and velocities that a lab states, m and m/s: six digits behind the point.
constexpr double stated = 1e-6;
/// The share of momentum and energy that may be missing: a thousand roundings of a double.
constexpr double keptShare = 1e-9;
/// How high a circle may still hop, m: other correct ways to handle the wall lose a little less
/// than going back does. Measured: mirroring the overshoot hops to 34 mm with e = 0.9 for ever; a
/// wall that takes nothing, to metres.
constexpr double lowestHop = 0.06;
/// Of the first height. A hit is told up to one step late: at 6 m/s and 1/60 s that is 0.1 m of 2
/// m.
constexpr double heightShare = 0.05;

KindInfo kind(const char *name, const QString &title, const QString &purpose, int circles,
              std::vector<ParameterInfo> parameters)
{
    return {QLatin1String(name), title, purpose, circles, std::move(parameters)};
}

/// How circles begin, and how they move where nothing meets them.
std::vector<KindInfo> motionKinds()
{
    return {
        kind("start", KindText::tr("Starts with these values"),
             KindText::tr("The values that a circle starts with"), 1,
             {vector("position", KindText::tr("Position"), "m"),
              vector("velocity", KindText::tr("Velocity"), "m/s"),
              positive("radius", KindText::tr("Radius"), "m"),
              positive("density", KindText::tr("Density"), "1000 kg/m³"),
              inUnit(make("count", Type::Count, KindText::tr("How many circles there are"),
                          KindText::tr("Not looked at if left out")),
                     "", {1.0, 100.0}),
              tolerance(motion::samePosition, "")}),
        kind("integrates", KindText::tr("Moves by an integrator"),
             KindText::tr("Every step far from walls is one of the named integrators under the "
                          "named gravity"),
             1,
             {integrators(), gravity(), collisions(), freeFlight(),
              tolerance(motion::samePosition, "m")}),
        kind("closed_form", KindText::tr("Follows x₀ + v₀t + ½gt²"),
             KindText::tr("Up to the first bounce it is where the formula says"), 1,
             {gravity(), collisions(), freeFlight(), tolerance(motion::samePosition, "m")}),
        kind("together", KindText::tr("Stay together"),
             KindText::tr("Two circles are in the same place with the same velocity at every step"),
             2, {tolerance(motion::samePosition, "m")}),
        kind("same_integrator", KindText::tr("Use the same integrator"),
             KindText::tr("Two circles follow one and the same integrator, whichever it is"), 2,
             {gravity(), collisions(), freeFlight()}),
        kind(
            "ends_at", KindText::tr("Is there at a moment"),
            KindText::tr("Positions and velocities at a moment; between two steps, on the straight "
                         "line between them"),
            1,
            {inUnit(make("time", Type::Number, KindText::tr("Moment"),
                         KindText::tr("Seconds from the start; the end if left out")),
                    "s", {0.0, 600.0}),
             list("positions", KindText::tr("Positions"), "m"),
             list("velocities", KindText::tr("Velocities"), "m/s"), tolerance(stated, "")}),
    };
}

/// Walls and floor.
std::vector<KindInfo> wallKinds()
{
    return {
        kind("bounces", KindText::tr("Walls reflect with e"),
             KindText::tr(
                 "At a wall v_n' = −e v_n; the part along the wall stays; at the rim and in "
                 "time"),
             1,
             {restitution(), gravity(), collisions(), hits(),
              tolerance(motion::sameVelocity, "m/s")}),
        kind("stays_inside", KindText::tr("Stays inside"),
             KindText::tr("Never further beyond a wall than the way of one step and the tolerance"),
             1, {gravity(), visits(), tolerance(0.0, "m")}),
        kind("bounce_heights", KindText::tr("Bounces to the heights e²ⁿ h₀"),
             KindText::tr("After the n-th bounce it rises to e²ⁿ times the height it came from"), 1,
             {restitution(),
              usually(inUnit(make("bounces", Type::Count, KindText::tr("Bounces"),
                                  KindText::tr("How many are looked at; those lower than the "
                                               "tolerance are not")),
                             "", {1.0, 100.0}),
                      3),
              share(heightShare, KindText::tr("How far off is still right, as a share of the first "
                                              "height")),
              gravity()}),
        kind("settles", KindText::tr("Comes to rest"),
             KindText::tr("At the end it lies on the floor as still as its integrator allows"), 1,
             {gravity(), collisions(), tolerance(lowestHop, "m")}),
    };
}

/// What circles 1 and 2 do to each other.
std::vector<KindInfo> pairKinds()
{
    return {
        kind(
            "collides", KindText::tr("Collide by a law"),
            KindText::tr("Circles 1 and 2 answer every contact, in time, by one of the named laws: "
                         "stop, exchange velocities, exchange normal parts, impulse with e"),
            2,
            {laws(), restitution(), contacts(), gravity(), tolerance(motion::sameVelocity, "m/s")}),
        kind("touches", KindText::tr("Hit when the gap closes"),
             KindText::tr("Circles 1 and 2 answer every contact when their rims meet, neither "
                          "earlier nor later, in whatever way"),
             2, {contacts(), gravity(), tolerance(motion::samePosition, "m")}),
        kind("rebounds", KindText::tr("Part with e times the speed"),
             KindText::tr("In every hit of circles 1 and 2 their relative speed along the line of "
                          "centres becomes e times what it was"),
             2, {restitution(), contacts(), gravity(), tolerance(motion::sameVelocity, "m/s")}),
        kind("conserves", KindText::tr("Keep momentum and energy"),
             KindText::tr("Every hit of circles 1 and 2 keeps the momentum and, if asked, the "
                          "kinetic energy"),
             2,
             {usually(make("energy", Type::Flag, KindText::tr("Kinetic energy, too"),
                           KindText::tr("Else only the momentum is looked at")),
                      false),
              gravity(), share(keptShare, KindText::tr("What share may be missing"))}),
        kind("after_contact", KindText::tr("Leave the first hit with"),
             KindText::tr("The velocities of circles 1 and 2 after their first hit"), 2,
             {needed(inUnit(make("velocities", Type::Vectors, KindText::tr("Velocities"),
                                 KindText::tr("One for each of the two circles")),
                            "m/s", {-farthest, farthest})),
              tolerance(stated, "m/s"), gravity()}),
        kind("loses_energy", KindText::tr("Lose energy"),
             KindText::tr("The first hit of circles 1 and 2 takes kinetic energy"), 2, {gravity()}),
        kind("passes_through", KindText::tr("Pass through each other"),
             KindText::tr("Circles 1 and 2 cross without changing"), 2, {gravity()}),
    };
}

KindInfo scriptKind()
{
    return kind(
        "script", KindText::tr("Your own, in Lua"),
        KindText::tr("The function check(run) of a file looks at the whole run and says what "
                     "is wrong with it"),
        1,
        {needed(make("script", Type::Script, KindText::tr("File"),
                     KindText::tr("In the folder checks of the step, such as "
                                  "heights.lua")))});
}

} // namespace

std::vector<KindInfo> checkKinds()
{
    std::vector<KindInfo> kinds = motionKinds();
    for (KindInfo &kind : wallKinds())
        kinds.push_back(std::move(kind));
    for (KindInfo &kind : pairKinds())
        kinds.push_back(std::move(kind));
    kinds.push_back(scriptKind());
    return kinds;
}

const KindInfo *findKind(const std::vector<KindInfo> &kinds, const QString &name)
{
    const auto found = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const KindInfo &kind) { return kind.name == name; });
    return found == kinds.end() ? nullptr : &*found;
}

QJsonValue valueOf(const CheckSpec &check, const QString &parameter)
{
    // Of every kind, by name; no language is in them.
    static const auto standards = [] {
        std::map<QString, QJsonObject> byKind;
        for (const KindInfo &kind : checkKinds()) {
            for (const ParameterInfo &info : kind.parameters)
                byKind[kind.name].insert(info.name, info.standard);
        }
        return byKind;
    }();
    if (const QJsonValue own = check.parameters.value(parameter); !own.isUndefined())
        return own;
    const auto kind = standards.find(check.kind);
    return kind == standards.end() ? QJsonValue(QJsonValue::Undefined)
                                   : kind->second.value(parameter);
}

const ParameterInfo *findParameter(const KindInfo &kind, const QString &name)
{
    const auto found = std::find_if(kind.parameters.begin(), kind.parameters.end(),
                                    [&](const ParameterInfo &p) { return p.name == name; });
    return found == kind.parameters.end() ? nullptr : &*found;
}

} // namespace cradle
