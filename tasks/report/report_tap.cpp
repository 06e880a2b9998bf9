// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_formats.h"

#include "model/world/shortest_number.h"
#include "tasks/report/report_text.h"
#include "tasks/text/plain_text.h"

namespace cradle {

namespace {

const QString margin = QStringLiteral("  ");

QString comment(const QString &text)
{
    QString lines;
    for (const QString &line : text.split(QLatin1Char('\n')))
        lines += (QStringLiteral("# ") + line).trimmed() + QLatin1Char('\n');
    return lines;
}

QString commentsOn(const CheckReport &report, const CheckOutcome &check, const QString &program)
{
    QString lines;
    for (const QString &finding : observationsOf(report, check, program))
        lines += comment(wrapped(finding.simplified(), terminalColumns - 2, {}, margin));
    return lines;
}

/// A title in which nothing is taken for a directive.
QString described(const QString &title)
{
    return printable(title)
        .simplified()
        .replace(QLatin1Char('\\'), QLatin1String("\\\\"))
        .replace(QLatin1Char('#'), QLatin1String("\\#"));
}

/// A text in the double quotes of YAML.
QString quoted(const QString &text)
{
    return QLatin1Char('"')
           + printable(text)
                 .replace(QLatin1Char('\\'), QLatin1String("\\\\"))
                 .replace(QLatin1Char('"'), QLatin1String("\\\""))
                 .replace(QLatin1Char('\n'), QLatin1String("\\n"))
                 .replace(QLatin1Char('\t'), QLatin1String("\\t"))
           + QLatin1Char('"');
}

/// The findings for a program to read.
QString yamlOf(const CheckReport &report, const CheckOutcome &check)
{
    QString text = QStringLiteral("  ---\n");
    const auto add = [&](const char *key, const QString &value) {
        text += QStringLiteral("  %1: %2\n").arg(QString::fromLatin1(key), value);
    };
    add("message", quoted(check.message));
    add("severity", wasStopped(report, check) ? QStringLiteral("error") : QStringLiteral("fail"));
    add("id", quoted(check.id));
    if (check.expected)
        add("expected", shortestNumber(*check.expected));
    if (check.observed)
        add("observed", shortestNumber(*check.observed));
    if (!check.unit.isEmpty())
        add("unit", quoted(check.unit));
    if (check.step >= 0)
        add("step", QString::number(check.step));
    if (!check.variant.isEmpty())
        add("scene", quoted(check.variant));
    if (check.line > 0)
        add("line", QString::number(check.line));
    return text + QStringLiteral("  ...\n");
}

} // namespace

QString tapTests(const CheckReport &report, const QString &program, int &number,
                 const QString &prefix)
{
    QString text;
    if (const QString explanation = explanationOf(report, program); !explanation.isEmpty())
        text += comment(explanation);
    for (const CheckOutcome &check : report.checks) {
        text += QStringLiteral("%1 %2 - %3\n")
                    .arg(check.passed ? QStringLiteral("ok") : QStringLiteral("not ok"))
                    .arg(++number)
                    .arg(described(prefix + check.title));
        if (!check.passed)
            text += yamlOf(report, check);
        if (!check.passed || check.forTeacher)
            text += commentsOn(report, check, program);
    }
    for (const Remark &remark : report.remarks)
        text += comment(plainText(remark.message, terminalColumns - 2));
    return text + comment(verdictOf(report));
}

QString tapSkipped(int number, const QString &name, const QString &reason)
{
    return QStringLiteral("ok %1 - %2 # SKIP %3\n")
        .arg(number)
        .arg(described(name), described(reason));
}

QString tapFailed(int number, const QString &name)
{
    return QStringLiteral("not ok %1 - %2\n").arg(number).arg(described(name));
}

QByteArray writeTap(const CheckReport &report, const QString &program)
{
    int number = 0;
    const QString tests = tapTests(report, program, number, {});
    return (QStringLiteral("TAP version 13\n1..%1\n").arg(number) + tests).toUtf8();
}

} // namespace cradle
