// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_class.h"
#include "app/cli/grade_results.h"
#include "app/cli/spoken.h"

#include "tasks/grading/class_zip.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/reading/lab_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace cradle::cli {

namespace {

struct GradeText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// Whether \p inner is in the folder \p outer, with links followed.
bool isWithin(const QString &inner, const QString &outer)
{
    QString place = QFileInfo(inner).absoluteFilePath();
    while (!QFileInfo::exists(place) && place.contains(QLatin1Char('/')) && place.size() > 1)
        place = QFileInfo(place).path();
    const QString real = QFileInfo(place).canonicalFilePath() + QLatin1Char('/');
    const QString root = QFileInfo(outer).canonicalFilePath();
    return !root.isEmpty() && real.startsWith(root + QLatin1Char('/'));
}

/// The folder of the class; a zip is unpacked into \p place first.
Result<ClassFolder> classFrom(const GradeRequest &request, const Lab &lab, const QString &place)
{
    std::vector<RosterRow> roster;
    if (!request.rosterPath.isEmpty()) {
        auto read = readRoster(request.rosterPath);
        if (!read)
            return read.error();
        roster = std::move(*read);
    }
    const QByteArray path = QFile::encodeName(request.submissions);
    if (!isClassZip(path))
        return readClassFolder(path, lab.id, roster);
    const auto leftOut = unpackClass(path, place);
    if (!leftOut)
        return leftOut.error();
    auto found = readClassFolder(QFile::encodeName(place), lab.id, roster);
    if (found) {
        for (const QString &name : *leftOut)
            found->remarks.append(GradeText::tr("left out of the zip: %1").arg(name));
    }
    return found;
}

/// Where zips are unpacked while they are judged.
const QString unpackedName = QStringLiteral("/.unpacked-");

/// Those of runs that were killed.
void removeUnpacked(const QString &results)
{
    for (const QString &name : QDir(results).entryList({unpackedName.mid(1) + QLatin1Char('*')},
                                                       QDir::Dirs | QDir::Hidden))
        QDir(results + QLatin1Char('/') + name).removeRecursively();
}

} // namespace

ExitCode grade(const QStringList &arguments)
{
    const auto parsed = parseGradeRequest(arguments);
    if (const auto *code = std::get_if<ExitCode>(&parsed))
        return *code;
    const auto &request = std::get<GradeRequest>(parsed);
    if (!request.merged.isEmpty())
        return mergeClass(request);
    const QString language = request.language.isEmpty() ? QStringLiteral("en") : request.language;
    speak(language);
    const auto lab = readLabAtHand(
        request.labPath.isEmpty() ? QString::fromLatin1(shippedLab) : request.labPath, language);
    if (!lab)
        return complain(lab.error());
    if (request.dryRun) {
        const QTemporaryDir place;
        const auto found = classFrom(request, lab->lab, place.path());
        return found ? tellClass(request, lab->lab, *found) : complain(found.error());
    }
    if (isWithin(request.results, request.submissions))
        return complain(GradeText::tr("the results may not go where the submissions are"));
    if (!QFileInfo::exists(request.submissions))
        return complain(GradeText::tr("there is no folder %1").arg(request.submissions));
    auto journal = ClassJournal::open(request.results);
    if (!journal)
        return complainUnwritten(journal.error());
    removeUnpacked(request.results);
    const QTemporaryDir place(request.results + unpackedName + QStringLiteral("XXXXXX"));
    const auto found = classFrom(request, lab->lab, place.path());
    return found ? gradeClass(request, *lab, *found, *journal) : complain(found.error());
}

} // namespace cradle::cli
