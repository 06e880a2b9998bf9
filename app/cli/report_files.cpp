// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/report_files.h"

#include "app/language.h"
#include "model/files/file_io.h"
#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>

namespace cradle::cli {

namespace {

struct WorkReportText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

constexpr int printPatience = 120'000; ///< ms
constexpr qint64 mostBytes = 256 * 1024 * 1024;

/// The application beside this program, which knows fonts and formulas; needs no display for that.
/// \param task  what it is to do with what lies in \p folder
std::optional<Error> runCradle(const QString &task, const QString &folder)
{
    const QString cradle = QCoreApplication::applicationDirPath() + QStringLiteral("/cradle");
    if (!QFileInfo(cradle).isExecutable())
        return Error{.message = WorkReportText::tr("the application that prints PDF is not beside "
                                                   "cradle-cli; F.html is right without it"),
                     .file = cradle};
    QProcess process;
    process.start(cradle, {task, folder, QStringLiteral("--language"), currentLanguage()});
    if (process.waitForFinished(printPatience) && process.exitStatus() == QProcess::NormalExit
        && process.exitCode() == 0)
        return std::nullopt;
    process.kill();
    process.waitForFinished();
    return Error{.message = WorkReportText::tr("the report could not be printed: %1")
                                .arg(QString::fromUtf8(process.readAllStandardError()))};
}

} // namespace

Result<QByteArray> printedReport(const LabReport &report)
{
    const QTemporaryDir folder;
    if (const auto error =
            savePage(labReportPage(report, Drawings::Numbered, currentLanguage()), folder.path()))
        return *error;
    if (const auto error = runCradle(QStringLiteral("--print-report"), folder.path()))
        return *error;
    return readFile(folder.filePath(QStringLiteral("report.pdf")), mostBytes);
}

void setFormulas(LabReport &report)
{
    const auto formulas = formulasOf(report);
    const QTemporaryDir folder;
    if (formulas.empty()
        || writeFile(folder.filePath(QStringLiteral("formulas.json")), textOf(formulas))
        || runCradle(QStringLiteral("--set-formulas"), folder.path()))
        return;
    if (const auto set = readFile(folder.filePath(QStringLiteral("set.json")), mostBytes))
        report.formulas = setFormulasFrom(*set);
}

QByteArray htmlOf(const LabReport &report)
{
    return labReportPage(report, Drawings::Inside, currentLanguage()).html.toUtf8();
}

} // namespace cradle::cli
