// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/integrator_matching.h"

#include "tasks/checks/figures.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct MatchingText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

} // namespace

bool agrees(Integrator integrator, const Observation &o, int i, qint64 k, Vec2 gravity,
            double tolerance)
{
    const Circle &now = o.circle(i, k);
    const Motion next = advance(integrator, {now.position, now.velocity}, gravity, o.timestep());
    const double error = quickLength(o.circle(i, k + 1).position - next.position);
    return error <= tolerance * (1.0 + quickLength(now.position));
}

std::vector<Integrator> agreeingIntegrators(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    std::vector<Integrator> found;
    std::copy_if(std::begin(allIntegrators), std::end(allIntegrators), std::back_inserter(found),
                 [&](Integrator integrator) { return agrees(integrator, o, i, k, gravity); });
    return found;
}

QString namesOf(const std::vector<Integrator> &integrators)
{
    QStringList names;
    for (const Integrator integrator : integrators)
        names.append(motion::integratorName(integrator));
    return names.join(MatchingText::tr(" or "));
}

std::vector<Integrator> matchingIntegrators(const CheckSpec &check, const Observation &o, int i,
                                            Vec2 gravity)
{
    std::vector<Integrator> left(std::begin(allIntegrators), std::end(allIntegrators));
    for (qint64 k = 0; k < o.steps() && !left.empty(); ++k) {
        if (!motion::isFree(check, o, i, k, gravity))
            continue;
        std::erase_if(left, [&](Integrator integrator) {
            return motion::isKicked(o, i, k, gravity) || !agrees(integrator, o, i, k, gravity);
        });
    }
    return left;
}

} // namespace cradle
