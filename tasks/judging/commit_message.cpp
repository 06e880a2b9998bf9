// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/commit_message.h"

#include "tasks/checks/figures.h"
#include "tasks/checks/integrator_matching.h"
#include "tasks/runs/observation.h"

namespace cradle {

namespace {

/// The lab's commit messages are English, whatever language the student reads.
QString englishNames(const std::vector<Integrator> &integrators)
{
    QStringList found;
    for (const Integrator integrator : integrators)
        found.append(QString::fromLatin1(motion::integratorInEnglish(integrator)));
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
