// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_parameters.h"

#include "model/files/preset_json.h"

#include <QCoreApplication>
#include <QJsonArray>

namespace cradle::parameters {

namespace {

using Type = ParameterInfo::Type;

struct ParameterText {
    Q_DECLARE_TR_FUNCTIONS(CheckKinds)
};

} // namespace

ParameterInfo gravity()
{
    return inUnit(make("gravity", Type::Vector, ParameterText::tr("Gravity"),
                       ParameterText::tr("What is right; that of the scene if left out")),
                  "m/s²", {-farthest, farthest});
}

ParameterInfo collisions()
{
    return usually(make("collisions", Type::Flag, ParameterText::tr("Circles collide"),
                        ParameterText::tr("Leave out the moments at which circles may touch")),
                   false);
}

ParameterInfo restitution()
{
    return inUnit(make("restitution", Type::Number, ParameterText::tr("Restitution e"),
                       ParameterText::tr("What is right; that of the scene if left out")),
                  "", {0.0, 1.0});
}

ParameterInfo hits()
{
    return usually(
        inUnit(make("hits", Type::Count, ParameterText::tr("Hits at least"),
                    ParameterText::tr("How often walls must turn the circles round, together, "
                                      "in every scene")),
               "", {0.0, 1000.0}),
        1);
}

ParameterInfo visits()
{
    return usually(inUnit(make("visits", Type::Count, ParameterText::tr("Visits at least"),
                               ParameterText::tr("How often each circle must come to a wall")),
                          "", {0.0, 1000.0}),
                   1);
}

ParameterInfo freeFlight()
{
    return inUnit(
        make("free", Type::Number, ParameterText::tr("Free at least"),
             ParameterText::tr("How long each circle must be free of walls and circles; a "
                               "tenth of the duration if left out")),
        "s", {0.0, 600.0});
}

ParameterInfo contacts()
{
    return usually(inUnit(make("contacts", Type::Count, ParameterText::tr("Hits at least"),
                               ParameterText::tr("How many hits there must be")),
                          "", {0.0, 1000.0}),
                   1);
}

ParameterInfo integrators()
{
    const QStringList names = allIntegratorNames();
    return usually(outOf(make("integrators", Type::Choices, ParameterText::tr("Integrators"),
                              ParameterText::tr("Any of these is right")),
                         names),
                   QJsonArray::fromStringList(names));
}

ParameterInfo laws()
{
    return usually(
        outOf(make("laws", Type::Choices, ParameterText::tr("Laws"),
                   ParameterText::tr(
                       "Any of these is right: both stop; they swap their velocities; they "
                       "swap the parts along the line of centres; the impulse of masses "
                       "and e")),
              allCircleLawNames().mid(1)), // no law is none that answers a hit
        QJsonArray{toName(CircleLaw::Impulse)});
}

ParameterInfo tolerance(double standard, const char *unit)
{
    return usually(inUnit(make("tolerance", Type::Number, ParameterText::tr("Tolerance"),
                               ParameterText::tr("How far off is still right")),
                          unit, {0.0, farthest}),
                   standard);
}

ParameterInfo share(double standard, const QString &help)
{
    ParameterInfo info =
        usually(make("tolerance", Type::Number, ParameterText::tr("Tolerance"), help), standard);
    return inUnit(info, "", {0.0, 1.0});
}

ParameterInfo list(const char *name, const QString &label, const char *unit)
{
    return inUnit(make(name, Type::Vectors, label,
                       ParameterText::tr("One for each of the circles; not looked at if left out")),
                  unit, {-farthest, farthest});
}

ParameterInfo vector(const char *name, const QString &label, const char *unit)
{
    return inUnit(make(name, Type::Vector, label, ParameterText::tr("Not looked at if left out")),
                  unit, {-farthest, farthest});
}

ParameterInfo positive(const char *name, const QString &label, const char *unit)
{
    return inUnit(make(name, Type::Number, label, ParameterText::tr("Not looked at if left out")),
                  unit, {1e-6, farthest});
}

} // namespace cradle::parameters
