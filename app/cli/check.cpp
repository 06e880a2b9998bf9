// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/judged_apart.h"
#include "app/cli/lab_at_hand.h"
#include "app/cli/spoken.h"
#include "app/cli/subcommand.h"
#include "app/language.h"

#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/questions/answers.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/report/report_formats.h"
#include "tasks/report/report_json.h"
#include "tasks/report/report_text.h"
#include "tasks/script/program_text.h"
#include "tasks/script/script_limits.h"
#include "tasks/values/values_of_file.h"
#include "tasks/workspace/workspace_info.h"

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace cradle::cli {

namespace {

struct CheckText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// The answers to the step's questions: those of the file for the step, or all of it.
Result<QByteArray> readAnswers(const Task &task, const QString &path)
{
    const auto bytes = readFile(path, limits::sourceBytes);
    if (!bytes)
        return bytes.error();
    const QJsonDocument json = QJsonDocument::fromJson(*bytes);
    if (!json.isObject())
        return Error{.message = CheckText::tr("an object with an answer for each id of a question "
                                              "is right"),
                     .file = path};
    const QJsonObject all = json.object();
    const bool ofLab = all.value(task.id).isObject();
    return answersText({{task.id, ofLab ? all.value(task.id).toObject() : all}});
}

/// What is to be judged, as bytes; a scene that is none is refused. Files of a lab have the values
/// of \p student.
Result<WorkFiles> readFiles(const Task &task, const QString &program, const QString &preset,
                            const QString &answers, const QString &student)
{
    WorkFiles files;
    if (!answers.isEmpty()) {
        const auto bytes = readAnswers(task, answers);
        if (!bytes)
            return bytes.error();
        files.insert(QStringLiteral("answers.json"), *bytes);
    }
    if (!preset.isEmpty()) {
        const auto scene = presetWithValues(preset, student);
        if (!scene)
            return scene.error();
        files.insert(QStringLiteral("presets/%1.json").arg(task.id), writePreset(*scene));
    }
    if (!program.isEmpty()) {
        const auto bytes = readProgramBytes(program);
        if (!bytes)
            return bytes.error();
        const auto own = withValuesOfItsStep(program, *bytes, student);
        if (!own)
            return own.error();
        files.insert(QStringLiteral("steps/%1.lua").arg(task.id), *own);
    }
    return files;
}

/// Whether who reads the report reads its errors there.
bool isShown(ReportFormat format, const QString &output)
{
    return format == ReportFormat::Text && output.isEmpty() && isatty(fileno(stdout)) == 1;
}

QByteArray writtenReport(const CheckReport &report, ReportFormat format, const QString &program,
                         const Task &task, const Isolation &isolation)
{
    if (format != ReportFormat::Json)
        return writeReport(report, format, program, &task);
    QJsonObject json = reportObject(report);
    json.insert(QStringLiteral("format"), 1);
    json.insert(QStringLiteral("elapsed_ms"), report.elapsedMs);
    json.insert(QStringLiteral("isolation"), isolationText(isolation));
    return QJsonDocument(json).toJson();
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
                                 CheckText::tr("the program to judge; - is standard input"),
                                 QStringLiteral("[SCRIPT.lua]"));
    const QCommandLineOption preset(QStringLiteral("preset"),
                                    CheckText::tr("the scene; without it that of the step"),
                                    QStringLiteral("P.json"));
    const QCommandLineOption answers(
        QStringLiteral("answers"),
        CheckText::tr("the answers to the step's questions: {\"ID\": ANSWER}"),
        QStringLiteral("A.json"));
    const QCommandLineOption student(
        QStringLiteral("student"),
        CheckText::tr("number of the student for whom the lab draws its values"),
        QStringLiteral("NUMBER"));
    const QCommandLineOption labDir(
        QStringLiteral("lab"),
        CheckText::tr("the lab's folder or NAME.cradle; without it the shipped lab"),
        QStringLiteral("LAB"));
    const QCommandLineOption seed(QStringLiteral("seed"),
                                  CheckText::tr("of the scenes; 1 without it"), QStringLiteral("N"),
                                  QStringLiteral("1"));
    const QCommandLineOption language(
        QStringLiteral("language"),
        CheckText::tr("of what the student is told, such as en or de; en without it"),
        QStringLiteral("CODE"));
    const QString formatNames = reportFormatNames().join(QStringLiteral(", "));
    const QCommandLineOption formatName(
        QStringLiteral("format"), CheckText::tr("one of %1; text without it").arg(formatNames),
        QStringLiteral("NAME"), QStringLiteral("text"));
    const QCommandLineOption output(QStringLiteral("output"),
                                    CheckText::tr("where to write; without it the terminal"),
                                    QStringLiteral("FILE"));
    const QCommandLineOption requireIsolation(
        QStringLiteral("require-isolation"),
        CheckText::tr("judge only where rlimits, seccomp and namespaces are to be had"));
    const QCommandLineOption exitZero(QStringLiteral("exit-zero"),
                                      CheckText::tr("exit with 0 also if it did not pass"));
    parser.addOptions({preset, answers, student, labDir, seed, language, formatName, output,
                       requireIsolation, exitZero});
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

    if (const QString fault = languageFault(parser.value(language)); !fault.isEmpty())
        return complain(fault);
    speak(parser.value(language));

    ServerProcess begun = beginApart(currentLanguage());
    const QString id = parser.positionalArguments().first();
    const auto lab = readLabAtHand(parser.isSet(labDir) ? parser.value(labDir) : shippedLabWith(id),
                                   currentLanguage(), id);
    if (!lab)
        return complain(lab.error());
    const int index = lab->lab.indexOf(id);
    if (index < 0)
        return complain(noStep(lab->lab, id));
    const Task &task = lab->lab.tasks[static_cast<std::size_t>(index)];
    auto files = readFiles(task, program, parser.value(preset), parser.value(answers),
                           parser.value(student));
    if (!files)
        return complain(files.error());
    if (parser.isSet(student)) {
        // What is no number for this student is told; the values of others may be right.
        for (const Error &fault : forStudent(lab->lab, parser.value(student)).findings) {
            const auto &told = lab->lab.findings;
            if (std::find(told.begin(), told.end(), fault) == told.end())
                QTextStream(stderr) << fault.toString() << Qt::endl;
        }
        WorkspaceInfo info;
        info.studentId = parser.value(student);
        files->insert(QStringLiteral("cradle.json"), textOf(info));
    }
    const auto judged =
        judgeApart(*lab, {.seed = seedValue, .steps = {task.id}, .files = *files, .moments = false},
                   parser.isSet(requireIsolation), std::move(begun));
    if (!judged)
        return complainUnwritten(judged.error());
    const CheckReport &report = judged->report;
    if (report.error && !isShown(*format, parser.value(output)))
        QTextStream(stderr) << placedMessage(*report.error, program) << Qt::endl;
    const QByteArray text = writtenReport(report, *format, program, task, judged->isolation);
    if (const auto error = writeText(parser.value(output), text))
        return complainUnwritten(*error);
    return report.passed || parser.isSet(exitZero) ? Done : NotPassed;
}

} // namespace cradle::cli
