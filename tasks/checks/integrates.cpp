// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/files/preset_json.h"
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/figures.h"
#include "tasks/checks/free_flight.h"
#include "tasks/checks/integrator_matching.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/substeps.h"
#include "tasks/checks/wall_turn.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace cradle::kinds {

namespace {

struct IntegratorText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

std::vector<Integrator> wantedIntegrators(const CheckSpec &check)
{
    std::vector<Integrator> wanted;
    for (const QJsonValue &name : valueOf(check, QStringLiteral("integrators")).toArray()) {
        if (const auto integrator = integratorFromName(name.toString()))
            wanted.push_back(*integrator);
    }
    return wanted;
}

Fault wrongAcceleration(const Observation &o, int i, qint64 k, Vec2 gravity)
{
    const Vec2 change = o.circle(i, k + 1).velocity - o.circle(i, k).velocity;
    const Vec2 observed = change / o.timestep();
    const bool x = std::abs(observed.x - gravity.x) > std::abs(observed.y - gravity.y);
    return {.message = IntegratorText::tr("At step %1 the velocity of circle %2 changed by %3 m/s, "
                                          "an acceleration of %4 m/s²; %5 m/s² is right here")
                           .arg(QString::number(k + 1), QString::number(i + 1),
                                motion::figure(change), motion::figureBeside(observed, gravity),
                                motion::figureBeside(gravity, observed)),
            .expected = x ? gravity.x : gravity.y,
            .observed = x ? observed.x : observed.y,
            .unit = QStringLiteral("m/s²"),
            .step = k + 1,
            .circle = i};
}

/// What is wrong in a step that none of the \p wanted makes: told beside the one that comes
/// nearest.
Fault wrongPlace(const Observation &o, int i, qint64 k, Vec2 gravity,
                 const std::vector<Integrator> &wanted)
{
    const Circle &now = o.circle(i, k);
    const Vec2 observed = o.circle(i, k + 1).position - now.position;
    const auto way = [&](Integrator integrator) {
        return advance(integrator, {now.position, now.velocity}, gravity, o.timestep()).position
               - now.position;
    };
    const Integrator nearest =
        *std::min_element(wanted.begin(), wanted.end(), [&](Integrator a, Integrator b) {
            return quickLength(way(a) - observed) < quickLength(way(b) - observed);
        });
    const std::vector<Integrator> instead = agreeingIntegrators(o, i, k, gravity);
    if (std::find(instead.begin(), instead.end(), nearest) != instead.end())
        return {.message =
                    IntegratorText::tr("At step %1 circle %2 moves by %3, and in steps before "
                                       "by another method; one for all steps is right")
                        .arg(QString::number(k + 1), QString::number(i + 1), namesOf(instead)),
                .step = k + 1,
                .circle = i};
    const Vec2 right = way(nearest);
    const bool x = std::abs(observed.x - right.x) > std::abs(observed.y - right.y);
    QString message =
        (wanted.size() == 1
             ? IntegratorText::tr("At step %1 circle %2 moved by %3 m; by %4 it moves by %5 m")
             : IntegratorText::tr("At step %1 circle %2 moved by %3 m, as by no integrator that "
                                  "this check allows; the nearest of them, %4, moves it by %5 m"))
            .arg(QString::number(k + 1), QString::number(i + 1),
                 motion::figureBeside(observed, right), motion::integratorName(nearest),
                 motion::figureBeside(right, observed));
    if (gravity == Vec2{}) {
        message =
            IntegratorText::tr("At step %1 circle %2 moved by %3 m; its velocity times the "
                               "timestep is %4 m")
                .arg(QString::number(k + 1), QString::number(i + 1),
                     motion::figureBeside(observed, right), motion::figureBeside(right, observed));
    }
    if (!instead.empty())
        message += IntegratorText::tr(". In this step %1 does so").arg(namesOf(instead));
    return {.message = message,
            .expected = x ? right.x : right.y,
            .observed = x ? observed.x : observed.y,
            .unit = QStringLiteral("m"),
            .step = k + 1,
            .circle = i};
}

} // namespace

std::optional<Fault> integrates(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    const std::vector<Integrator> wanted = wantedIntegrators(check);
    const double tolerance = motion::toleranceOf(check);
    const bool isAnyMethod = !check.parameters.contains(QStringLiteral("integrators"));
    for (const int i : check.circles) {
        std::vector<Integrator> left = wanted;
        // Where no method is asked for, one in smaller steps is as good.
        bool isSubstepped = isAnyMethod;
        Substeps substeps;
        qint64 seen = 0;
        for (qint64 k = 0; k < o.steps(); ++k) {
            if (!motion::isFree(check, o, i, k, gravity))
                continue;
            ++seen;
            if (motion::isKicked(o, i, k, gravity, tolerance)) {
                const auto turned = turnBeforeWall(o, i, k, gravity);
                return turned ? turned : wrongAcceleration(o, i, k, gravity);
            }
            std::erase_if(left, [&](Integrator integrator) {
                return !agrees(integrator, o, i, k, gravity, tolerance);
            });
            isSubstepped = isSubstepped && substeps.take(o, i, k, gravity, tolerance);
            if (left.empty() && !isSubstepped)
                return wrongPlace(o, i, k, gravity, wanted);
        }
        if (auto fault = tooLittleFlight(check, o, i, seen, gravity))
            return fault;
    }
    return std::nullopt;
}

std::optional<Fault> sameIntegrator(const CheckSpec &check, const Observation &o)
{
    const Vec2 gravity = motion::gravityOf(check, o);
    std::vector<Integrator> first;
    for (const int i : check.circles) {
        if (auto fault = tooLittleFlight(check, o, i, freeSteps(check, o, i, gravity), gravity))
            return fault;
        const std::vector<Integrator> own = matchingIntegrators(check, o, i, gravity);
        if (own.empty()) {
            return Fault{.message = IntegratorText::tr("None of the four integrators makes all "
                                                       "steps of circle %1 under gravity %2 m/s²")
                                        .arg(QString::number(i + 1), motion::figure(gravity)),
                         .step = 1};
        }
        if (first.empty())
            first = own;
        if (own != first) {
            return Fault{.message = IntegratorText::tr("Circle %1 moves by %2 and circle %3 by %4; "
                                                       "the same for both is right")
                                        .arg(QString::number(check.circles.front() + 1),
                                             namesOf(first), QString::number(i + 1), namesOf(own)),
                         .step = 1};
        }
    }
    return std::nullopt;
}

} // namespace cradle::kinds
