// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/subcommand.h"

#include "tasks/authoring/student_edition.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_reader.h"

#include <QCoreApplication>
#include <QTextStream>

namespace cradle::cli {

namespace {

struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

Result<LabFiles> filesOf(const QString &path)
{
    if (isLabArchive(path))
        return readLabArchive(path);
    std::vector<Error> unread;
    Result<LabFiles> files = readLabFiles(path, &unread);
    if (files && !unread.empty())
        return unread.front();
    return files;
}

} // namespace

ExitCode exportLab(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(ExportText::tr(
        "Writes a lab into one file. For students it leaves out solutions, mistakes, remarks and "
        "files that no step uses; what checks and questions ask for stays."));
    parser.addPositionalArgument(QStringLiteral("LAB"),
                                 ExportText::tr("the lab's folder, or NAME.cradle"));
    const QCommandLineOption students(QStringLiteral("students"),
                                      ExportText::tr("leave out what students shall find"));
    const QCommandLineOption output(QStringLiteral("output"),
                                    ExportText::tr("the file to write; needed"),
                                    QStringLiteral("NAME.cradle"));
    parser.addOptions({students, output});
    if (const auto code = parse(parser, arguments, 1, 1))
        return *code;
    if (!parser.isSet(output))
        return complain(ExportText::tr("--output is missing: the file to write"));
    const Result<LabFiles> files = filesOf(parser.positionalArguments().first());
    if (!files)
        return complain(files.error());
    const Result<Lab> lab = readLab(*files, parser.positionalArguments().first());
    if (!lab)
        return complain(lab.error());
    for (const Error &finding : lab->findings)
        QTextStream(stderr) << finding.toString() << Qt::endl;
    if (!lab->findings.empty())
        return BadInput; // students would not find what cannot be read
    LabFiles written = *files;
    if (parser.isSet(students)) {
        const Result<StudentEdition> edition = studentEdition(*files);
        if (!edition)
            return complain(edition.error());
        written = edition->files;
        QTextStream(stderr) << ExportText::tr("%n file(s) left out", nullptr, edition->left)
                            << Qt::endl;
        if (!edition->unexplained.isEmpty())
            QTextStream(stderr)
                << ExportText::tr("students are told what checks saw, and not which law is wrong, "
                                  "in %1: these checks tell no law")
                       .arg(edition->unexplained.join(QStringLiteral(", ")))
                << Qt::endl;
    }
    if (const auto error = cradle::exportLab(written, parser.value(output)))
        return complainUnwritten(*error);
    return Done;
}

} // namespace cradle::cli
