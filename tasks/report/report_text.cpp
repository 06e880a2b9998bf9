// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_text.h"

#include "tasks/text/plain_text.h"
#include "tasks/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct ReportText {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

/// Local variables that are told with an error.
constexpr std::size_t mostLocals = 6;

const QString leftMargin = QStringLiteral("  ");
/// Below the title of a check.
const QString indent = QStringLiteral("        ");

QString nameOf(const QString &program)
{
    return program.isEmpty() ? QStringLiteral("lab.lua") : program;
}

/// Puts \p text, of any lines, behind \p before.
QString behind(const QString &before, const QString &text)
{
    QStringList lines;
    for (const QString &line : text.split(QLatin1Char('\n')))
        lines.append(line.isEmpty() ? QString() : before + line);
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

/// Whether the check is where the program stopped.
bool tellsError(const CheckReport &report, const CheckOutcome &check)
{
    return report.error && !check.passed && check.message == report.error->message;
}

QString localsOf(const ProgramError &error)
{
    QStringList values;
    for (const ProgramValue &local : error.locals) {
        if (static_cast<std::size_t>(values.size()) == mostLocals)
            break;
        values.append(QStringLiteral("%1 = %2").arg(local.name, local.value));
    }
    return values.join(QStringLiteral(", "));
}

QString describe(const ProgramError &error, const QString &program)
{
    QStringList parts{
        wrapped(placedMessage(error, program).simplified(), terminalColumns - 2, {}, leftMargin)};
    if (error.step > 0)
        parts.append(ReportText::tr("in step %1, at %2 s")
                         .arg(error.step)
                         .arg(quantityText(error.time, 'g', 4)));
    if (!error.locals.empty())
        parts.append(wrapped(printable(ReportText::tr("with %1").arg(localsOf(error))).simplified(),
                             terminalColumns - 2, {}, leftMargin));
    return parts.join(QLatin1Char('\n'));
}

QString describe(const CheckReport &report, const CheckOutcome &check, const QString &program)
{
    const bool stopped = wasStopped(report, check);
    const QString mark = check.passed ? QStringLiteral("  ok    ")
                         : stopped    ? QStringLiteral("  error ")
                                      : QStringLiteral("  FAIL  ");
    QString text = wrapped(printable(check.title).simplified(), terminalColumns, mark, indent)
                   + QLatin1Char('\n');
    if (check.passed && !check.forTeacher)
        return text;
    QStringList findings = observationsOf(report, check, program);
    // It stands above all checks.
    if (tellsError(report, check))
        findings.removeFirst();
    for (const QString &finding : findings)
        text += wrapped(finding.simplified(), terminalColumns, indent, indent) + QLatin1Char('\n');
    return text;
}

} // namespace

QString describeReport(const CheckReport &report, const QString &program)
{
    QString text;
    if (report.error)
        text = behind(leftMargin, describe(*report.error, program)) + QLatin1Char('\n');
    for (const Finding &finding : report.findings) {
        text += behind(leftMargin, plainText(finding.message, terminalColumns - 2));
        if (finding.line > 0)
            text += wrapped(ReportText::tr("Look at %1:%2").arg(nameOf(program)).arg(finding.line),
                            terminalColumns, leftMargin, leftMargin)
                    + QLatin1Char('\n');
        text += QLatin1Char('\n');
    }
    for (const CheckOutcome &check : report.checks)
        text += describe(report, check, program);
    for (const Remark &remark : report.remarks)
        text +=
            QLatin1Char('\n') + behind(leftMargin, plainText(remark.message, terminalColumns - 2));
    text += QLatin1Char('\n') + verdictOf(report) + QLatin1Char('\n');
    if (report.passed)
        text += (report.byProgram ? ReportText::tr("The program moved the circles.")
                                  : ReportText::tr("The laws of the scene moved the circles."))
                + QLatin1Char('\n');
    if (report.passed && !report.commit.isEmpty())
        text += wrapped(ReportText::tr("Commit message: %1").arg(report.commit), terminalColumns,
                        {}, leftMargin)
                + QLatin1Char('\n');
    return text;
}

QString kindName(ProgramError::Kind kind)
{
    switch (kind) {
    case ProgramError::Kind::Syntax:
        return QStringLiteral("syntax");
    case ProgramError::Kind::Time:
        return QStringLiteral("time");
    case ProgramError::Kind::Memory:
        return QStringLiteral("memory");
    case ProgramError::Kind::Machine:
        return QStringLiteral("machine");
    case ProgramError::Kind::Runtime:
        break;
    }
    return QStringLiteral("runtime");
}

std::optional<ProgramError::Kind> kindFromName(const QString &name)
{
    using Kind = ProgramError::Kind;
    for (const Kind kind : {Kind::Syntax, Kind::Runtime, Kind::Time, Kind::Memory, Kind::Machine}) {
        if (kindName(kind) == name)
            return kind;
    }
    return std::nullopt;
}

QString placedMessage(const ProgramError &error, const QString &program)
{
    return Error{.message = printable(error.message), .file = nameOf(program), .line = error.line}
        .toString();
}

bool wasStopped(const CheckReport &report, const CheckOutcome &check)
{
    // Without a scene nothing was judged; else it is the scene where the program stopped.
    return report.error && !check.passed && !check.question
           && (check.variant.isEmpty() || tellsError(report, check));
}

QStringList observationsOf(const CheckReport &report, const CheckOutcome &check,
                           const QString &program)
{
    QStringList findings{printable(tellsError(report, check) ? placedMessage(*report.error, program)
                                                             : check.message)};
    if (!check.variant.isEmpty() && check.variant != QLatin1String("preset"))
        findings.append(ReportText::tr("in the scene: %1").arg(check.variant));
    if (check.line > 0)
        findings.append(ReportText::tr("last assigned in that step by %1:%2")
                            .arg(nameOf(program))
                            .arg(check.line));
    return findings;
}

QStringList mistakesOf(const CheckReport &report)
{
    QStringList names;
    for (const Finding &finding : report.findings) {
        if (!finding.mistake.isEmpty())
            names.append(finding.mistake);
    }
    return names;
}

QString explanationOf(const CheckReport &report, const QString &program)
{
    if (report.error)
        return placedMessage(*report.error, program);
    QStringList parts;
    for (const Finding &finding : report.findings)
        parts.append(plainText(finding.message, terminalColumns));
    return parts.join(QLatin1Char('\n'));
}

QString feedbackOn(const CheckReport &report, std::size_t index, const QString &program)
{
    const CheckOutcome &check = report.checks[index];
    if (check.forTeacher && check.passed)
        return printable(check.message);
    if (check.passed)
        return {};
    // What stopped the program explains no check that failed before.
    const auto isExplained = [&](const CheckOutcome &c) {
        return !c.passed && !c.question && (!report.error || wasStopped(report, c));
    };
    const bool first =
        isExplained(check)
        && std::none_of(report.checks.begin(),
                        report.checks.begin() + static_cast<std::ptrdiff_t>(index), isExplained);
    const QString explanation = explanationOf(report, program);
    QStringList findings = observationsOf(report, check, program);
    if (first && !explanation.isEmpty() && !tellsError(report, check))
        findings.prepend(explanation + QLatin1Char('\n'));
    return findings.join(QLatin1Char('\n'));
}

int passedCount(const CheckReport &report)
{
    return static_cast<int>(std::count_if(report.checks.begin(), report.checks.end(),
                                          [](const CheckOutcome &check) { return check.passed; }));
}

bool hasQuestions(const CheckReport &report)
{
    return std::any_of(report.checks.begin(), report.checks.end(),
                       [](const CheckOutcome &check) { return check.question; });
}

bool isScored(const CheckReport &report)
{
    return std::any_of(report.checks.begin(), report.checks.end(),
                       [](const CheckOutcome &check) { return check.points != 1.0; });
}

double scoreOf(const CheckReport &report)
{
    double sum = 0.0;
    for (const CheckOutcome &check : report.checks)
        sum += check.passed ? check.points : 0.0;
    return sum;
}

double fullScoreOf(const CheckReport &report)
{
    double sum = 0.0;
    for (const CheckOutcome &check : report.checks)
        sum += check.points;
    return sum;
}

QString verdictOf(const CheckReport &report)
{
    if (report.passed)
        return ReportText::tr("%1 passed").arg(report.taskId);
    if (report.error)
        return (report.error->step > 0 ? ReportText::tr("%1 did not pass: the program stopped")
                : report.error->kind == ProgramError::Kind::Syntax
                    ? ReportText::tr("%1 did not pass: the program does not load")
                    : ReportText::tr("%1 did not pass: the program stopped before its first step"))
            .arg(report.taskId);
    const auto all = static_cast<int>(report.checks.size());
    const QString words =
        hasQuestions(report) ? ReportText::tr("%1 did not pass: %2 of %3 checks and answers failed")
                             : ReportText::tr("%1 did not pass: %2 of %3 checks failed");
    const QString verdict = words.arg(report.taskId).arg(all - passedCount(report)).arg(all);
    return isScored(report) ? ReportText::tr("%1 (%2 of %3 points)")
                                  .arg(verdict)
                                  .arg(scoreOf(report))
                                  .arg(fullScoreOf(report))
                            : verdict;
}

} // namespace cradle
