// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/apart.h"
#include "app/cli/subcommand.h"

#include "model/preset_json.h"
#include "tasks/authoring/lab_archive.h"
#include "tasks/checker.h"
#include "tasks/lab_list.h"
#include "tasks/program_text.h"
#include "tasks/report_formats.h"
#include "tasks/report_text.h"

#include <QCoreApplication>
#include <QTextStream>

#include <cstdio>
#include <unistd.h>

namespace cradle::cli {

namespace {

/// Of the process that judges; it stops by itself long before, where it can look at the clock.
constexpr std::chrono::seconds mostTime{90};

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

QStringList idsOf(const Lab &lab)
{
    QStringList ids;
    for (const Task &task : lab.tasks)
        ids.append(task.id);
    return ids;
}

Result<Submission> readSubmission(const Task &task, const QString &program, const QString &preset)
{
    Submission submission(task.preset);
    if (!preset.isEmpty()) {
        const Result<Preset> read = readPreset(preset);
        if (!read)
            return read.error();
        submission.preset = *read;
    }
    if (!program.isEmpty()) {
        const Result<QString> text = readProgram(program);
        if (!text)
            return text.error();
        submission.script = *text;
    }
    return submission;
}

/// Whether who reads the report reads its errors there.
bool isShown(ReportFormat format, const QString &output)
{
    return format == ReportFormat::Text && output.isEmpty() && isatty(fileno(stdout)) == 1;
}

/// Nothing is written where there is nothing to say of the program.
ExitCode noVerdict(const ProgramError &error)
{
    QTextStream(stderr) << "cradle-cli: " << error.message << Qt::endl;
    return Defect;
}

} // namespace

ExitCode check(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(CheckText::tr(
        "Judges a program, or with --preset alone the engine's laws, for one step: by what "
        "they do. A program that does not load or that stops does not pass; why is also "
        "on standard error, as FILE:LINE: message."));
    parser.addPositionalArgument(QStringLiteral("TASK"), CheckText::tr("the step, like L42T5"));
    parser.addPositionalArgument(QStringLiteral("SCRIPT.lua"),
                                 CheckText::tr("the program to judge"),
                                 QStringLiteral("[SCRIPT.lua]"));
    const QCommandLineOption preset(QStringLiteral("preset"),
                                    CheckText::tr("the scene; without it that of the step"),
                                    QStringLiteral("P.json"));
    const QCommandLineOption labDir(
        QStringLiteral("lab"),
        CheckText::tr("the lab's folder or NAME.cradle; without it the shipped lab"),
        QStringLiteral("LAB"));
    const QCommandLineOption seed(QStringLiteral("seed"),
                                  CheckText::tr("of the scenes; 1 without it"), QStringLiteral("N"),
                                  QStringLiteral("1"));
    const QString formatNames = reportFormatNames().join(QStringLiteral(", "));
    const QCommandLineOption formatName(
        QStringLiteral("format"), CheckText::tr("one of %1; text without it").arg(formatNames),
        QStringLiteral("NAME"), QStringLiteral("text"));
    const QCommandLineOption output(QStringLiteral("output"),
                                    CheckText::tr("where to write; without it the terminal"),
                                    QStringLiteral("FILE"));
    const QCommandLineOption exitZero(QStringLiteral("exit-zero"),
                                      CheckText::tr("exit with 0 also if it did not pass"));
    parser.addOptions({preset, labDir, seed, formatName, output, exitZero});
    if (const auto code = parse(parser, arguments, 1, 2))
        return *code;
    const QString program = parser.positionalArguments().value(1);
    if (program.isEmpty() && !parser.isSet(preset))
        return complain(CheckText::tr("SCRIPT.lua or --preset P.json is missing: what is to be "
                                      "judged?"));
    const auto format = reportFormatFromName(parser.value(formatName));
    if (!format)
        return complain(CheckText::tr("unknown format %1; one of %2 is right")
                            .arg(parser.value(formatName), formatNames));
    bool isNumber = false;
    const qint64 seedValue = parser.value(seed).toLongLong(&isNumber);
    if (!isNumber)
        return complain(CheckText::tr("--seed %1 is not a whole number").arg(parser.value(seed)));

    const QString id = parser.positionalArguments().first();
    const Result<Lab> lab =
        readLabOrArchive(parser.isSet(labDir) ? parser.value(labDir) : shippedLabWith(id));
    if (!lab)
        return complain(lab.error());
    for (const Error &finding : lab->findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    const int index = lab->indexOf(id);
    if (index < 0)
        return complain(CheckText::tr("the lab has no step %1; it has %2")
                            .arg(id, idsOf(*lab).join(QStringLiteral(", "))));
    const Task &task = lab->tasks[static_cast<std::size_t>(index)];
    const Result<Submission> submission = readSubmission(task, program, parser.value(preset));
    if (!submission)
        return complain(submission.error());
    const auto tell = [&](const CheckReport &report) -> ExitCode {
        if (report.error && report.error->kind == ProgramError::Kind::Machine)
            return noVerdict(*report.error);
        if (report.error && !isShown(*format, parser.value(output)))
            QTextStream(stderr) << placedMessage(*report.error, program) << Qt::endl;
        const QByteArray text = writeReport(report, *format, program);
        if (const auto error = writeText(parser.value(output), text))
            return complainUnwritten(*error);
        return report.passed || parser.isSet(exitZero) ? Done : NotPassed;
    };
    const auto judge = [&] { return tell(*judgeTask(*lab, task, *submission, seedValue)); };
    if (program.isEmpty())
        return judge();
    const auto judged = runApart(judge, mostTime);
    if (const int *code = std::get_if<int>(&judged))
        return static_cast<ExitCode>(*code);
    if (const auto *crash = std::get_if<Crashed>(&judged)) {
        QTextStream(stderr) << "cradle-cli: this is a defect of ours: the judgement broke down by "
                               "signal "
                            << crash->signal << Qt::endl;
        return Defect;
    }
    return noVerdict(stoppedByMachine(mostTime.count()));
}

} // namespace cradle::cli
