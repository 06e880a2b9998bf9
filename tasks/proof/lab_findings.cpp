// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_findings.h"

#include "tasks/proof/other_values.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct VerifyText {
    Q_DECLARE_TR_FUNCTIONS(LabVerifier)
};

using Role = VerifiedProgram::Role;

bool isFailedBy(const CheckReport &report, const QString &check)
{
    return std::any_of(report.checks.begin(), report.checks.end(), [&](const CheckOutcome &c) {
        return c.id == check && !c.passed && !c.checkStopped;
    });
}

/// The check that stopped with an error of its own; nullptr if none did.
const CheckOutcome *firstStop(const CheckReport &report)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [](const CheckOutcome &check) { return check.checkStopped; });
    return found == report.checks.end() ? nullptr : &*found;
}

QString stopText(const CheckOutcome &stopped)
{
    return VerifyText::tr("is not judged by the check %1: %2").arg(stopped.id, stopped.message);
}

const CheckOutcome *firstFailure(const CheckReport &report)
{
    const auto found = std::find_if(report.checks.begin(), report.checks.end(),
                                    [](const CheckOutcome &check) { return !check.passed; });
    return found == report.checks.end() ? nullptr : &*found;
}

using Kind = LabFinding::Kind;

/// What is wrong with one report of a program; it fills in \p finding.
/// \return false if all is as it should be
bool findProblem(const VerifiedProgram &program, const CheckReport &report, LabFinding &finding)
{
    const auto say = [&](Kind kind, const QString &message) {
        finding.kind = kind;
        finding.message = message;
        return true;
    };
    const CheckOutcome *failure = firstFailure(report);
    const QString how =
        failure ? QStringLiteral("%1: %2").arg(failure->id, failure->message) : QString();
    finding.check = failure ? failure->id : QString();
    if (const CheckOutcome *stopped = firstStop(report)) {
        finding.check = stopped->id;
        return say(Kind::CheckStops, stopText(*stopped));
    }
    if (report.error)
        return say(Kind::ProgramErrs, VerifyText::tr("stops with an error at line %1: %2")
                                          .arg(report.error->line)
                                          .arg(report.error->message));
    switch (program.role) {
    case Role::Starter:
        return report.passed
               && say(Kind::StarterPasses,
                      VerifyText::tr("passes; a starter should fail by a check"));
    case Role::Solution:
        return !report.passed
               && say(Kind::SolutionFails,
                      VerifyText::tr("fails with seed %1 by %2").arg(report.seed).arg(how));
    case Role::Mistake:
        if (report.passed)
            return say(Kind::MistakePasses,
                       VerifyText::tr("passes; a mistake should fail by a check"));
        // A measured law names it, but not in the words that it brings.
        if (!report.diagnosis() || report.diagnosis()->mistake.isEmpty())
            return say(Kind::MistakeNotRecognised, VerifyText::tr("is not recognised"));
        return report.diagnosis()->mistake != program.name
               && say(Kind::MistakeTakenForAnother,
                      VerifyText::tr("is taken for %1").arg(report.diagnosis()->mistake));
    case Role::Remark:
        break;
    }
    if (!report.passed)
        return say(Kind::RemarkFails,
                   VerifyText::tr("fails by %1; work that gets a remark passes").arg(how));
    const bool seen = std::any_of(report.remarks.begin(), report.remarks.end(),
                                  [&](const Remark &remark) { return remark.id == program.name; });
    return !seen && say(Kind::RemarkNotRecognised, VerifyText::tr("is not recognised"));
}

/// Whether \p report fails by \p check and no other.
bool isFailedAlone(const CheckReport &report, const QString &check)
{
    return std::all_of(report.checks.begin(), report.checks.end(), [&](const CheckOutcome &c) {
        return (c.passed || c.checkStopped) == (c.id != check);
    });
}

bool asksTheSame(const CheckSpec &a, const CheckSpec &b)
{
    return a.kind == b.kind && a.circles == b.circles && a.parameters == b.parameters
           && a.scene == b.scene && a.source == b.source;
}

/// Checks that fail whatever fails by \p check: one if there is such a one, else as few as it
/// takes, the one that sees most of it first.
QStringList repeatedBy(const VerifiedTask &verified, const QString &check)
{
    std::vector<const CheckReport *> rest;
    for (const VerifiedProgram &p : verified.programs) {
        if (p.role == Role::Mistake && isFailedBy(p.reports.front(), check))
            rest.push_back(&p.reports.front());
    }
    QStringList others;
    while (!rest.empty()) {
        QString best;
        std::ptrdiff_t most = 0;
        for (const QString &other : verified.checks) {
            const auto seen = std::count_if(rest.begin(), rest.end(), [&](const CheckReport *r) {
                return isFailedBy(*r, other);
            });
            if (other != check && seen > most) {
                most = seen;
                best = other;
            }
        }
        if (most == 0)
            break;
        others.append(best);
        std::erase_if(rest, [&](const CheckReport *r) { return isFailedBy(*r, best); });
    }
    return others;
}

/// Checks that could be left out: nothing would be judged otherwise.
std::vector<LabFinding> idleChecks(const Task &task, const VerifiedTask &verified)
{
    std::vector<LabFinding> found;
    for (auto check = task.checks.begin(); check != task.checks.end(); ++check) {
        const auto twin = std::find_if(task.checks.begin(), check, [&](const CheckSpec &other) {
            return asksTheSame(other, *check);
        });
        const auto seenBy = [&](bool (*sees)(const CheckReport &, const QString &)) {
            return std::any_of(
                verified.programs.begin(), verified.programs.end(), [&](const VerifiedProgram &p) {
                    return p.role == Role::Mistake && sees(p.reports.front(), check->id);
                });
        };
        LabFinding finding{.task = task.id, .check = check->id};
        if (twin != check) {
            finding.kind = Kind::CheckIsDuplicate;
            finding.message =
                VerifyText::tr("the check %1 asks for the same as %2").arg(check->id, twin->id);
        } else if (seenBy(isFailedBy) && !seenBy(isFailedAlone)) {
            finding.kind = Kind::CheckNeverAlone;
            finding.message =
                VerifyText::tr("no mistake fails by the check %1 alone: it repeats %2")
                    .arg(check->id, repeatedBy(verified, check->id).join(QStringLiteral(", ")));
        } else {
            continue;
        }
        found.push_back(finding);
    }
    return found;
}

/// Questions for a number that nobody can write down: it has no end, and nothing beside it is
/// right.
void addEndless(const Task &task, VerifiedTask &verified)
{
    constexpr int writable = 6; // digits
    for (const Question &question : task.questions) {
        const bool isWritten =
            QString::number(question.number, 'g', writable).toDouble() == question.number;
        if (question.kind == Question::Kind::Number && question.tolerance == 0.0 && !isWritten)
            verified.warnings.push_back(
                {.kind = Kind::QuestionEndless,
                 .task = task.id,
                 .message = VerifyText::tr("the question %1 asks for %2, and its tolerance is 0: "
                                           "nobody answers it rightly")
                                .arg(question.id, QString::number(question.number, 'g', 9))});
    }
}

} // namespace

void findProblems(const Lab &lab, const Task &task, const std::vector<Error> &gaps,
                  VerifiedTask &verified)
{
    for (const VerifiedProgram &program : verified.programs) {
        for (const CheckReport &report : program.reports) {
            LabFinding finding{.task = task.id, .program = programPath(program)};
            finding.seed = report.seed;
            if (findProblem(program, report, finding)) {
                finding.message = finding.program + QLatin1Char(' ') + finding.message;
                verified.findings.push_back(finding);
                break;
            }
        }
    }
    for (const KnownScript &mistake : task.mistakes) {
        const std::vector<OtherValue> others = otherValues(mistake.source, task.solution);
        if (others.empty())
            continue;
        const QString program = QStringLiteral("mistakes/") + mistake.name;
        verified.findings.push_back(
            {.kind = Kind::MistakeDiffersInMore,
             .task = task.id,
             .program = program,
             .message = VerifyText::tr("%1 differs in more than its mistake: it has “%2” where the "
                                       "solution has “%3”")
                            .arg(program, others.front().here, others.front().solution)});
    }
    if (task.solution.isEmpty())
        verified.findings.push_back({.kind = Kind::NoSolution,
                                     .task = task.id,
                                     .message = VerifyText::tr("there is no solution.lua")});
    for (const QString &check : verified.checks) {
        const bool caught = std::any_of(
            verified.programs.begin(), verified.programs.end(), [&](const VerifiedProgram &p) {
                return p.role == Role::Mistake && isFailedBy(p.reports.front(), check);
            });
        if (!caught)
            verified.findings.push_back(
                {.kind = Kind::CheckNeverFails,
                 .task = task.id,
                 .check = check,
                 .message = VerifyText::tr("no mistake fails the check %1").arg(check)});
    }
    verified.warnings = idleChecks(task, verified);
    addEndless(task, verified);
    const QString step = task.folder.mid(lab.folder.size() + 1) + QLatin1Char('/');
    for (const Error &gap : gaps) {
        if (gap.file.startsWith(step))
            verified.warnings.push_back({.kind = Kind::TextUnfinished,
                                         .task = task.id,
                                         .message = QStringLiteral("%1: %2").arg(
                                             gap.file.section(QLatin1Char('/'), -1), gap.message)});
    }
}

std::optional<LabFinding> stoppedCheck(const Task &task, const VerifiedProgram &program,
                                       const CheckReport &report)
{
    const CheckOutcome *stopped = firstStop(report);
    if (!stopped)
        return std::nullopt;
    const QString path = programPath(program);
    return LabFinding{.kind = Kind::CheckStops,
                      .task = task.id,
                      .program = path,
                      .check = stopped->id,
                      .seed = report.seed,
                      .message = path + QLatin1Char(' ') + stopText(*stopped)};
}

LabFinding tooTight(const Task &task, const CheckSpec &check, const TightTolerance &tight)
{
    const auto figure = [&](double value) {
        return QString::number(value, 'g', 3)
               + (tight.unit.isEmpty() ? QString() : QLatin1Char(' ') + tight.unit);
    };
    return {.kind = Kind::ToleranceTooTight,
            .task = task.id,
            .program = QStringLiteral("solution"),
            .check = check.id,
            .message =
                VerifyText::tr("the check %1 allows %2, and the solution itself is off by %3 "
                               "(%4): other right programs may fail; at least %5 is right")
                    .arg(check.id, figure(tight.allowed), figure(tight.needed), tight.variant,
                         figure(toleranceMargin * tight.needed))};
}

} // namespace cradle
