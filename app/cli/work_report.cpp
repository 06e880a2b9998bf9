// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/apart.h"
#include "app/cli/report_files.h"
#include "app/cli/spoken.h"
#include "app/cli/subcommand.h"
#include "app/cli/told_in_cells.h"
#include "app/language.h"
#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/hand_in/hand_in.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_list.h"
#include "tasks/reading/lab_reader.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct ReportFileText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr std::chrono::minutes mostTime{10}; ///< of all programs of one student

/// What both subcommands are asked.
struct WorkOptions {
    QCommandLineOption lab{QStringLiteral("lab"),
                           ReportFileText::tr("the lab's folder or NAME.cradle; without it the "
                                              "shipped lab that the work belongs to"),
                           QStringLiteral("LAB")};
    QCommandLineOption seed{QStringLiteral("seed"),
                            ReportFileText::tr("of the scenes; 1 without it"), QStringLiteral("N"),
                            QStringLiteral("1")};
    QCommandLineOption name{QStringLiteral("name"), ReportFileText::tr("of the student"),
                            QStringLiteral("N")};
    QCommandLineOption number{QStringLiteral("id"), ReportFileText::tr("of the student"),
                              QStringLiteral("I")};
    QCommandLineOption note{QStringLiteral("note"), ReportFileText::tr("to the teacher"),
                            QStringLiteral("TEXT")};
    QCommandLineOption output{QStringLiteral("output"), ReportFileText::tr("where to write"),
                              QStringLiteral("FILE")};
    QCommandLineOption language{
        QStringLiteral("language"),
        ReportFileText::tr("of the report, such as en or de; without it that of the system"),
        QStringLiteral("CODE")};
};

/// Speaks the language that was asked for. \return what is wrong with it
std::optional<ExitCode> takeLanguage(const QCommandLineParser &parser, const WorkOptions &options)
{
    const QString asked = parser.value(options.language);
    if (const QString fault = languageFault(asked); !fault.isEmpty())
        return complain(fault);
    setLanguage(asked);
    // Numbers as in the words around them.
    if (QLocale().language() != QLocale(currentLanguage()).language())
        QLocale::setDefault(spokenLocale(currentLanguage()));
    return std::nullopt;
}

/// The lab that was asked for, or that the work names.
Result<Lab> labFor(const QCommandLineParser &parser, const WorkOptions &options,
                   const QString &work)
{
    if (parser.isSet(options.lab))
        return readLabOrArchive(parser.value(options.lab), currentLanguage());
    QString id;
    if (isWorkArchive(work)) {
        const auto files = readWorkArchive(work);
        if (!files)
            return files.error();
        if (const auto manifest = manifestOf(*files))
            id = manifest->labId;
    } else if (const auto info = readWorkspaceInfo(work)) {
        id = info->labId;
    }
    for (const char *shipped : {shippedLab, bouncingBallLab}) {
        auto lab = readLab(QLatin1String(shipped), currentLanguage());
        if (lab && lab->id == id)
            return lab;
    }
    return readLab(QLatin1String(shippedLab), currentLanguage());
}

/// In a process of its own: the work is programs, and anybody may have written them.
ExitCode guarded(const std::function<int()> &work)
{
    const auto done = runApart(work, mostTime);
    if (const int *code = std::get_if<int>(&done))
        return static_cast<ExitCode>(*code);
    QTextStream(stderr) << "cradle-cli: this is a defect of ours: judging the work broke down\n";
    return Defect;
}

int seedOf(const QCommandLineParser &parser, const WorkOptions &options)
{
    return parser.value(options.seed).toInt();
}

ExitCode verdictOn(const LabReport &report)
{
    return report.passedCount() == static_cast<int>(report.steps.size()) ? Done : NotPassed;
}

/// Of the report in the file or folder \p path.
Result<LabReport> reportOn(const QString &path, const Lab &lab, const Sender &sender, qint64 seed)
{
    auto work = readWork(path, lab);
    if (!work)
        return work.error();
    if (!sender.name.isEmpty())
        work->info.student = sender.name;
    if (!sender.number.isEmpty())
        work->info.studentId = sender.number;
    LabReport report = reportFromCells(lab, *work, seed, QDateTime::currentDateTimeUtc());
    setFormulas(report);
    return report;
}

} // namespace

ExitCode report(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(ReportFileText::tr(
        "Writes the report of a student's work: what was asked, what the program does, how it "
        "came about. Every step is judged anew."));
    parser.addPositionalArgument(QStringLiteral("WORKSPACE"),
                                 ReportFileText::tr("the folder, or a FILE.cradle-work"));
    const WorkOptions options;
    parser.addOptions({options.lab, options.seed, options.name, options.number, options.output,
                       options.language});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    if (const auto code = takeLanguage(parser, options))
        return *code;
    const QString output = parser.value(options.output);
    const bool isPdf = output.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
    if (!isPdf && !output.endsWith(QLatin1String(".html"), Qt::CaseInsensitive))
        return complain(ReportFileText::tr("--output F.pdf or --output F.html is right"));
    const QString work = parser.positionalArguments().first();
    return guarded([&]() -> int {
        const auto lab = labFor(parser, options, work);
        if (!lab)
            return complain(lab.error());
        const Sender sender{parser.value(options.name), parser.value(options.number), {}};
        const auto told = reportOn(work, *lab, sender, seedOf(parser, options));
        if (!told)
            return complain(told.error());
        const auto bytes = isPdf ? printedReport(*told) : Result<QByteArray>(htmlOf(*told));
        if (!bytes)
            return complainUnwritten(bytes.error());
        if (const auto error = writeText(output, *bytes))
            return complainUnwritten(*error);
        return verdictOn(*told);
    });
}

ExitCode handIn(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(ReportFileText::tr(
        "Writes a student's work into one file to be handed in: the programs, scenes, notes, the "
        "history and a report. Every step is judged once more."));
    parser.addPositionalArgument(QStringLiteral("WORKSPACE"), ReportFileText::tr("the folder"));
    const WorkOptions options;
    parser.addOptions({options.lab, options.seed, options.name, options.number, options.note,
                       options.output, options.language});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    if (const auto code = takeLanguage(parser, options))
        return *code;
    const QString work = parser.positionalArguments().first();
    const QString output = parser.value(options.output);
    if (!output.endsWith(QLatin1String(workSuffix), Qt::CaseInsensitive))
        return complain(ReportFileText::tr("--output FILE.cradle-work is right"));
    return guarded([&]() -> int {
        const auto lab = labFor(parser, options, work);
        if (!lab)
            return complain(lab.error());
        const qint64 seed = seedOf(parser, options);
        const QDateTime when = QDateTime::currentDateTimeUtc();
        auto gathered = gatherHandIn(
            *lab, work,
            {parser.value(options.name), parser.value(options.number), parser.value(options.note)},
            seed, when, [&](const Lab &ofLab, const StudentWork &told) {
                return reportFromCells(ofLab, told, seed, when);
            });
        if (!gathered)
            return complain(gathered.error());
        setFormulas(gathered->report);
        auto printed = printedReport(gathered->report);
        const QString name = printed ? QStringLiteral("report.pdf") : QStringLiteral("report.html");
        if (!printed) {
            QTextStream(stderr) << printed.error().toString() << Qt::endl;
            printed = htmlOf(gathered->report);
        }
        const auto packed = packHandIn(*gathered, name, *printed);
        if (!packed)
            return complain(packed.error());
        if (const auto error = writeText(output, *packed))
            return complainUnwritten(*error);
        const LabReport &report = gathered->report;
        QTextStream(stdout) << ReportFileText::tr("%1 is written: %2 of %3 steps passed")
                                   .arg(output)
                                   .arg(report.passedCount())
                                   .arg(report.steps.size())
                            << Qt::endl;
        return verdictOn(report);
    });
}

} // namespace cradle::cli
