// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"

#include <QStringList>

/// All that a report says, in as few lines as can be read: for comparison.
namespace cradle {

inline QString toldNumber(const std::optional<double> &value)
{
    return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest)
                 : QStringLiteral("–");
}

inline QString indented(const QString &message)
{
    QString text = message.trimmed();
    text.replace(QStringLiteral("\n\n"), QStringLiteral("\n"));
    return QStringLiteral("  ") + text.replace(QLatin1Char('\n'), QStringLiteral("\n  "));
}

/// Passed checks by name; of a failed one where, what was expected and observed, and its message.
inline void tellCheck(const CheckOutcome &check, QStringList &lines)
{
    QString head = (check.passed ? QStringLiteral("pass ") : QStringLiteral("fail ")) + check.id;
    if (check.checkStopped)
        head += QStringLiteral(", stopped");
    if (!check.passed && check.step >= 0)
        head += QStringLiteral(", step %1").arg(check.step);
    if (check.line > 0)
        head += QStringLiteral(", line %1").arg(check.line);
    if (check.expected || check.observed)
        head += QStringLiteral(", %1 for %2 %3")
                    .arg(toldNumber(check.observed), toldNumber(check.expected), check.unit);
    if (!check.variant.isEmpty())
        head += QStringLiteral(", in %1").arg(check.variant);
    lines.append(head);
    if (!check.message.isEmpty())
        lines.append(indented(check.message));
}

inline void tellFinding(const Finding &finding, QStringList &lines)
{
    QString head = QStringLiteral("finding %1, line %2, in %3")
                       .arg(aspectName(finding.aspect))
                       .arg(finding.line)
                       .arg(finding.check);
    for (const int call : finding.calls)
        head += QStringLiteral(", from %1").arg(call);
    if (!finding.mistake.isEmpty())
        head += QStringLiteral(", mistake ") + finding.mistake;
    lines.append(head);
    lines.append(indented(finding.message));
}

inline QString toldReport(const CheckReport &report)
{
    QStringList lines{(report.passed ? QStringLiteral("passes") : QStringLiteral("fails"))
                      + (report.byProgram ? QString() : QStringLiteral(" by the laws"))};
    if (report.passed)
        lines.append(indented(report.commit));
    if (report.error) {
        lines.append(QStringLiteral("error %1, line %2, step %3")
                         .arg(kindName(report.error->kind))
                         .arg(report.error->line)
                         .arg(report.error->step));
        lines.append(indented(report.error->message));
        for (const ProgramValue &local : report.error->locals)
            lines.append(QStringLiteral("  %1 = %2").arg(local.name, local.value));
    }
    for (const CheckOutcome &check : report.checks)
        tellCheck(check, lines);
    for (const Finding &finding : report.findings)
        tellFinding(finding, lines);
    for (const Remark &remark : report.remarks) {
        lines.append(QStringLiteral("remark ") + remark.id);
        lines.append(indented(remark.message));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

} // namespace cradle
