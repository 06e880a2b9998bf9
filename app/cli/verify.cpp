// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lab_at_hand.h"
#include "app/cli/subcommand.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/authoring/mutations.h"
#include "tasks/lab_files/step_alone.h"
#include "tasks/proof/lab_verifier.h"
#include "tasks/proof/verified_text.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct VerifyText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

QString summary(const Lab &lab, const std::vector<VerifiedTask> &tasks, qint64 milliseconds)
{
    std::size_t mistakes = 0;
    std::size_t problems = lab.findings.size(); // a step that cannot be read is none below
    for (const VerifiedTask &task : tasks) {
        problems += task.findings.size();
        for (const VerifiedProgram &program : task.programs)
            mistakes += program.role == VerifiedProgram::Role::Mistake ? 1 : 0;
    }
    const QStringList parts{
        VerifyText::tr("%n steps", nullptr, static_cast<int>(tasks.size())),
        VerifyText::tr("%n mistakes", nullptr, static_cast<int>(mistakes)),
        VerifyText::tr("%n problems", nullptr, static_cast<int>(problems)),
        VerifyText::tr("%1 s").arg(static_cast<double>(milliseconds) / 1000.0, 0, 'f', 1)};
    return spokenList(parts) + QLatin1Char('\n');
}

/// Rewrites programs in the lab's folder, and says how many lines that saved.
std::optional<Error> keepAsDifferences(const QString &folder)
{
    const Result<LabFiles> files = readLabFiles(folder);
    if (!files)
        return files.error();
    const LabFiles turned = withDifferences(*files);
    if (auto error = saveLabFiles(turned, *files, folder))
        return error;
    qsizetype programs = 0;
    qsizetype lines = 0;
    for (auto it = files->contents.begin(); it != files->contents.end(); ++it) {
        programs += turned.contents.contains(it.key()) ? 0 : 1;
        lines += it->count('\n');
    }
    for (const QByteArray &content : turned.contents)
        lines -= content.count('\n');
    QTextStream(stderr)
        << VerifyText::tr("%1 programs became differences, %2 lines fewer").arg(programs).arg(lines)
        << Qt::endl;
    return std::nullopt;
}

} // namespace

ExitCode verify(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(VerifyText::tr(
        "Judges a lab itself: starters fail by a check, solutions pass, every known mistake fails "
        "and is recognised, and every check is failed by a mistake. Prints which mistake (row) "
        "fails which check (column, x) and what it is taken for."));
    parser.addPositionalArgument(QStringLiteral("LAB"),
                                 VerifyText::tr("the lab's folder, or NAME.cradle"));
    const QCommandLineOption only(QStringLiteral("task"), VerifyText::tr("this step alone"),
                                  QStringLiteral("L42T5"));
    parser.addOption(only);
    const QCommandLineOption fix(QStringLiteral("fix"),
                                 VerifyText::tr("keep mistakes and remarks as differences from "
                                                "their solution where that is shorter"));
    const QCommandLineOption mutations(
        QStringLiteral("mutations"),
        VerifyText::tr("also ask of every check whether some change of the solution fails by it "
                       "alone; takes minutes"));
    const QCommandLineOption seeds(
        QStringLiteral("seeds"),
        VerifyText::tr("with how many seeds every solution is judged, 1 to 1000"),
        QStringLiteral("N"), QStringLiteral("10"));
    parser.addOptions({fix, mutations, seeds});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    bool isNumber = false;
    const int seedCount = parser.value(seeds).toInt(&isNumber);
    if (!isNumber || seedCount < 1 || seedCount > 1000)
        return complain(VerifyText::tr("--seeds takes a whole number from 1 to 1000, not %1")
                            .arg(parser.value(seeds)));
    if (parser.isSet(fix)) {
        if (const auto error = keepAsDifferences(parser.positionalArguments().first()))
            return complain(*error);
    }
    QElapsedTimer timer;
    timer.start();
    const Result<Lab> lab = readLabOrArchive(parser.positionalArguments().first());
    if (!lab)
        return complain(lab.error());
    for (const Error &finding : lab->findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    if (lab->forStudents)
        return complain(VerifyText::tr("this is an edition for students, without the solutions and "
                                       "mistakes that prove a lab; the whole lab is right"));
    if (parser.isSet(only) && lab->indexOf(parser.value(only)) < 0)
        return complain(noStep(*lab, parser.value(only)));
    std::vector<VerifiedTask> tasks = verifyLab(*lab, parser.value(only), {}, seedCount);
    for (VerifiedTask &task : tasks) {
        if (parser.isSet(mutations))
            dropNeeded(task,
                       suggestMistakes(*lab, lab->tasks[std::size_t(lab->indexOf(task.id))]).alone);
    }
    bool sound = lab->findings.empty();
    QString text;
    for (const VerifiedTask &task : tasks) {
        text += describeVerified(task) + QLatin1Char('\n');
        sound = sound && task.findings.empty();
    }
    for (const QString &step : unlistedSteps(*lab->files))
        text += QStringLiteral("? ")
                + VerifyText::tr("the folder %1 is no step: lab.json does not list it\n").arg(step);
    if (const QString tried = describeTried(*lab); !tried.isEmpty())
        text += VerifyText::tr("Values of students that were tried:\n") + tried + QLatin1Char('\n');
    if (const auto error = writeText({}, (text + summary(*lab, tasks, timer.elapsed())).toUtf8()))
        return complainUnwritten(*error);
    return sound ? Done : NotPassed;
}

} // namespace cradle::cli
