// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/commit_message.h"

#include "tasks/checks/integrator_matching.h"
#include "tasks/runs/observation.h"

#include <map>

namespace cradle {

namespace {

/// The lab's commit messages are English, whatever language the student reads.
QString englishNames(const std::vector<Integrator> &integrators)
{
    static const std::map<Integrator, QString> names{
        {Integrator::Euler, QStringLiteral("Euler")},
        {Integrator::SymplecticEuler, QStringLiteral("symplectic Euler")},
        {Integrator::Verlet, QStringLiteral("velocity Verlet")},
        {Integrator::RungeKutta4, QStringLiteral("Runge-Kutta 4")}};
    QStringList found;
    for (const Integrator integrator : integrators)
        found.append(names.at(integrator));
    return found.join(QStringLiteral(" or "));
}

} // namespace

QString commitOf(const Task &task, const Submission &submission)
{
    QString commit = task.id + QLatin1Char(' ') + task.commit;
    const QString wanted = QStringLiteral("{integrator}");
    if (!commit.contains(wanted) || submission.preset.circles.empty())
        return commit;
    const Observation run =
        observe({QStringLiteral("preset"), submission.preset, 2.0}, submission.program());
    return commit.replace(
        wanted, englishNames(matchingIntegrators({}, run, 0, run.variant.preset.gravity)));
}

} // namespace cradle
