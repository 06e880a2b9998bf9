// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/proof/lab_verifier.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/proof/lab_findings.h"
#include "tasks/proof/lab_round.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/values/value_ranges.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle {

namespace {

struct VerifierText {
    Q_DECLARE_TR_FUNCTIONS(LabVerifier)
};

constexpr int fewestStudents = 10; ///< whose values are tried, where the lab draws some
constexpr int mostStudents = 24;

/// Whether \p known tells of the same, with other values perhaps.
bool isTold(const std::vector<LabFinding> &known, const LabFinding &finding)
{
    return std::any_of(known.begin(), known.end(), [&](const LabFinding &each) {
        return each.kind == finding.kind && each.program == finding.program
               && each.check == finding.check;
    });
}

/// Adds \p finding, which shows with the values of \p student, unless it is told already.
void addDrawn(VerifiedTask &task, LabFinding finding, const QString &student)
{
    if (isTold(task.findings, finding))
        return;
    finding.message =
        VerifierText::tr("with the values of the student %1: %2").arg(student, finding.message);
    task.findings.push_back(finding);
}

/// Adds what of the values of \p student is no number where one is needed.
void addValueFaults(const Lab &lab, const Lab &own, const QString &student,
                    std::vector<VerifiedTask> &result)
{
    for (const Error &fault : own.findings) {
        if (std::find(lab.findings.begin(), lab.findings.end(), fault) != lab.findings.end())
            continue;
        const auto owner = std::find_if(result.begin(), result.end(), [&](const VerifiedTask &t) {
            const Task &task = lab.tasks[static_cast<std::size_t>(lab.indexOf(t.id))];
            return fault.file.startsWith(task.folder + QLatin1Char('/'));
        });
        VerifiedTask &task = owner == result.end() ? result.front() : *owner;
        const QString file = fault.file.mid(lab.folder.size() + 1);
        addDrawn(task,
                 {.kind = LabFinding::Kind::ValueFails,
                  .task = task.id,
                  .message = QStringLiteral("%1: %2").arg(file, fault.message)},
                 student);
    }
}

/// The languages of the lab and of Cradle that \p lab was not read in.
QStringList otherLanguages(const Lab &lab)
{
    QStringList languages;
    if (lab.files)
        languages = languagesOf(*lab.files);
    languages +=
        {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("fr"), QStringLiteral("ar")};
    languages.removeDuplicates();
    languages.removeAll(lab.readIn);
    return lab.files ? languages : QStringList();
}

/// Adds what checks in Lua stop with where a student reads another language than the lab's own:
/// they may answer in the student's.
void addSpokenStops(const Lab &lab, const QString &language, const JudgeHooks &hooks,
                    std::vector<VerifiedTask> &result)
{
    const Result<Lab> spoken = readLab(*lab.files, lab.folder, language);
    if (!spoken)
        return;
    for (VerifiedTask &verified : result) {
        const int index = spoken->indexOf(verified.id);
        if (index < 0)
            continue;
        const Task &task = spoken->tasks[static_cast<std::size_t>(index)];
        if (std::none_of(task.checks.begin(), task.checks.end(),
                         [](const CheckSpec &check) { return !check.source.isEmpty(); }))
            continue;
        for (const Candidate &candidate : candidatesOf(task)) {
            SubmissionRuns runs(candidate.submission);
            const auto report = judgeTask(*spoken, task, runs, 1, hooks);
            if (!report)
                return; // cancelled
            const VerifiedProgram program{candidate.role, candidate.name, {}};
            auto finding = stoppedCheck(task, program, *report);
            if (!finding || isTold(verified.findings, *finding))
                continue;
            finding->message =
                VerifierText::tr("in the language %1: %2").arg(language, finding->message);
            verified.findings.push_back(*finding);
        }
    }
}

/// Hooks for one of several rounds, whose progress is a part of the whole.
JudgeHooks partOf(const JudgeHooks &hooks, int round, int rounds)
{
    JudgeHooks part = hooks;
    if (rounds == 1 || !hooks.progress)
        return part;
    part.progress = [&hooks, round, rounds](int done, int total) {
        constexpr int share = 1000;
        hooks.progress(round * share + share * done / std::max(total, 1), rounds * share);
    };
    return part;
}

} // namespace

QStringList studentsTried(const Lab &lab)
{
    return lab.drawsValues ? studentsToTry(*lab.files, fewestStudents, mostStudents)
                           : QStringList();
}

std::vector<VerifiedTask> verifyLab(const Lab &lab, const QString &only, const JudgeHooks &hooks,
                                    int seeds)
{
    const QStringList students = studentsTried(lab);
    const int rounds = 1 + static_cast<int>(students.size());
    std::vector<VerifiedTask> result = verifyOne(lab, only, partOf(hooks, 0, rounds), seeds);
    for (int i = 1; i < rounds && !result.empty(); ++i) {
        const QString &student = students[i - 1];
        const Lab own = forStudent(lab, student);
        const auto drawn = verifyOne(own, only, partOf(hooks, i, rounds), std::min(seeds, 5));
        if (hooks.cancelled && hooks.cancelled())
            return {};
        addValueFaults(lab, own, student, result);
        for (const VerifiedTask &task : drawn) {
            const auto known = std::find_if(result.begin(), result.end(),
                                            [&](const auto &each) { return each.id == task.id; });
            for (const LabFinding &finding : task.findings) {
                if (known != result.end())
                    addDrawn(*known, finding, student);
            }
        }
    }
    const JudgeHooks quiet{.cancelled = hooks.cancelled, .provesLines = false};
    for (const QString &language : otherLanguages(lab))
        addSpokenStops(lab, language, quiet, result);
    if (hooks.cancelled && hooks.cancelled())
        return {};
    return result;
}

} // namespace cradle
