// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/verified_text.h"

#include "model/world/shortest_number.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/values/value_ranges.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct VerifiedText {
    Q_DECLARE_TR_FUNCTIONS(LabVerifier)
};

using Role = VerifiedProgram::Role;

/// "x . x": which checks failed.
QString rowOf(const VerifiedTask &task, const CheckReport &report)
{
    QStringList marks;
    for (const QString &check : task.checks) {
        const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                        [&](const CheckOutcome &each) { return each.id == check; });
        const bool right = found == report.checks.end() || found->passed;
        const bool stopped = found != report.checks.end() && found->checkStopped;
        marks.append(stopped ? QStringLiteral("!")
                     : right ? QStringLiteral(".")
                             : QStringLiteral("x"));
    }
    return marks.join(QStringLiteral("  "));
}

} // namespace

QString wrongEnough(const VerifiedTask &task, qsizetype index)
{
    const auto at = static_cast<std::size_t>(index);
    const bool measured = at < task.sensitivity.size() && task.sensitivity[at];
    return measured ? describe(*task.sensitivity[at]) : QString();
}

QString describeVerified(const VerifiedTask &task)
{
    QString text = QStringLiteral("%1  %2\n").arg(task.id, task.title);
    text += QStringLiteral("  %1 %2\n")
                .arg(QString(), 59)
                .arg(VerifiedText::tr("fails what is turned, too fast, adrift by"));
    for (qsizetype i = 0; i < task.checks.size(); ++i)
        text += QStringLiteral("  %1 %2  %3\n")
                    .arg(i + 1, 36)
                    .arg(task.checks[i], -22)
                    .arg(wrongEnough(task, i));
    for (const VerifiedProgram &program : task.programs) {
        const CheckReport &report = program.reports.front();
        QString note;
        if (program.role == Role::Mistake)
            note = report.diagnosis() ? report.diagnosis()->mistake : QStringLiteral("-");
        else if (program.role == Role::Solution)
            note = VerifiedText::tr("with %1 seeds").arg(program.reports.size());
        else if (program.role == Role::Remark)
            note = report.remarks.empty() ? QStringLiteral("-") : report.remarks.front().id;
        text += QStringLiteral("  %1 %2   %3\n")
                    .arg(programPath(program), -36)
                    .arg(rowOf(task, report), note);
    }
    for (const LabFinding &finding : task.findings)
        text += QStringLiteral("  ! %1\n").arg(finding.message);
    for (const LabFinding &warning : task.warnings)
        text += QStringLiteral("  ? %1\n").arg(warning.message);
    return text;
}

QString describeTried(const Lab &lab)
{
    QString text;
    if (!lab.drawsValues)
        return text;
    for (const TriedRange &range : triedRanges(*lab.files, studentsTried(lab)))
        text += VerifiedText::tr("%1: %2 of %3 values, %4 to %5", "of a range")
                    .arg(range.step.isEmpty() ? range.name
                                              : QStringLiteral("%1 %2").arg(range.step, range.name))
                    .arg(range.tried)
                    .arg(range.count)
                    .arg(shortestNumber(range.least), shortestNumber(range.most))
                + QLatin1Char('\n');
    return text;
}

} // namespace cradle
