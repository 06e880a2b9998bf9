// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/start_words.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace cradle {

namespace {

struct StartText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

std::optional<Vec2> askedGravity(const CheckSpec &check)
{
    const QJsonArray list = check.parameters.value(QStringLiteral("gravity")).toArray();
    if (list.size() != 2
        || check.scene.value(QStringLiteral("kind")).toString(QStringLiteral("own"))
               != QLatin1String("own"))
        return std::nullopt;
    return Vec2{list[0].toDouble(), list[1].toDouble()};
}

bool failed(const CheckSpec &check, const std::vector<CheckOutcome> &checks)
{
    return std::any_of(checks.begin(), checks.end(), [&](const CheckOutcome &outcome) {
        return outcome.id == check.id && !outcome.passed;
    });
}

/// A number of the scene that is not as the checks have it.
std::optional<Deviation> wrongGravity(const Task &task, const Preset &start,
                                      const std::vector<CheckOutcome> &checks)
{
    for (const CheckSpec &check : task.checks) {
        const auto asked = askedGravity(check);
        if (!asked || *asked == start.gravity || !failed(check, checks))
            continue;
        return Deviation{Aspect::Start,
                         StartText::tr("Gravity is %1 m/s², not %2\n\nSo it is when the run "
                                       "begins. Look at what `on_load` assigns to `gravity`.")
                             .arg(brief(start.gravity), brief(*asked)),
                         {}};
    }
    return std::nullopt;
}

} // namespace

std::vector<Deviation> startDeviations(const Task &task, const Submission &submission,
                                       const std::vector<CheckOutcome> &checks)
{
    std::vector<Deviation> deviations;
    for (const CheckSpec &check : task.checks) {
        if (check.kind != QLatin1String("start"))
            continue;
        for (const CheckOutcome &outcome : checks) {
            if (outcome.id != check.id || outcome.passed)
                continue;
            deviations.push_back(
                {Aspect::Start,
                 outcome.message
                     + StartText::tr("\n\nLook at what `on_load` sets, and for which circle."),
                 {}});
        }
    }
    const Stage own{submission.preset, false};
    const Probe probe(submission.program(), own);
    if (probe.runs()) {
        if (auto gravity = wrongGravity(task, probe.start(), checks))
            deviations.push_back(*gravity);
    }
    return deviations;
}

} // namespace cradle
