// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reading/lab_archive.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/reading/lab_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace cradle {

namespace {

struct ArchiveText {
    Q_DECLARE_TR_FUNCTIONS(LabArchive)
};

constexpr int mostNames = 1000; ///< of one lab, with numbers

/// The archive's name without its end; that of the lab where no folder can be called so.
QString folderName(const QString &path, const QString &labId)
{
    const QString name = QFileInfo(path).completeBaseName();
    if (faultOfLabPath(name).isEmpty())
        return name;
    return faultOfLabPath(labId).isEmpty() ? labId : QStringLiteral("lab");
}

bool holdsTheSame(const QString &folder, const LabFiles &files)
{
    const Result<LabFiles> there = readLabFiles(folder);
    return there && *there == files;
}

} // namespace

std::optional<Error> exportLab(const LabFiles &files, const QString &path)
{
    const Result<QByteArray> archive = packLab(files);
    if (!archive)
        return archive.error();
    return writeFile(path, *archive);
}

Result<LabFiles> readLabArchive(const QString &path)
{
    const Result<QByteArray> archive = readFile(path, limits::labBytes);
    return archive ? unpackLab(*archive, path) : Result<LabFiles>(archive.error());
}

bool isLabArchive(const QString &path)
{
    return path.endsWith(QLatin1String(archiveSuffix), Qt::CaseInsensitive)
           && !QFileInfo(path).isDir();
}

Result<Lab> readLabOrArchive(const QString &path, const QString &language)
{
    if (!isLabArchive(path))
        return readLab(path, language);
    const Result<LabFiles> files = readLabArchive(path);
    return files ? readLab(*files, path, language) : Result<Lab>(files.error());
}

QString userLabsFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)
           + QStringLiteral("/labs");
}

std::optional<OlderLab> olderThan(const QString &path, const QString &labs)
{
    const Result<LabFiles> files = readLabArchive(path);
    if (!files)
        return std::nullopt;
    const Result<Lab> lab = readLab(*files, path);
    if (!lab)
        return std::nullopt;
    std::optional<OlderLab> older;
    for (const ListedLab &each : labsIn(labs, lab->language)) {
        if (each.id != lab->id)
            continue;
        if (holdsTheSame(each.folder, *files))
            return std::nullopt;
        if (!older)
            older = OlderLab{each, lab->version};
    }
    return older;
}

Result<QString> importLab(const QString &path, const QString &labs, const QString &replaced)
{
    const Result<LabFiles> files = readLabArchive(path);
    if (!files)
        return files.error();
    const Result<Lab> lab = readLab(*files, path);
    if (!lab)
        return lab.error();
    if (const auto error = makeFolder(labs))
        return *error;
    // The dot keeps what is not whole from being taken for a lab.
    QTemporaryDir unfinished(labs + QStringLiteral("/.import-XXXXXX"));
    if (!unfinished.isValid())
        return Error{.message = unfinished.errorString(), .file = labs};
    const QString inside = unfinished.filePath(QStringLiteral("lab"));
    if (const auto error = saveLabFiles(*files, {}, inside))
        return *error;
    if (!replaced.isEmpty()) {
        // What gives way goes with the unfinished folder, and comes back if anything fails.
        const QString old = unfinished.filePath(QStringLiteral("old"));
        if (QDir().rename(replaced, old)) {
            if (QDir().rename(inside, replaced))
                return replaced;
            QDir().rename(old, replaced);
        }
        return Error{.message = ArchiveText::tr("the lab cannot be put there"), .file = replaced};
    }
    const QString name = folderName(path, lab->id);
    for (int number = 1; number < mostNames; ++number) {
        const QString folder =
            labs + QLatin1Char('/')
            + (number == 1 ? name : QStringLiteral("%1-%2").arg(name).arg(number));
        if (holdsTheSame(folder, *files) || QDir().rename(inside, folder))
            return folder;
        if (!QFileInfo::exists(folder))
            break; // the name was free, so something else is wrong
    }
    return Error{.message = ArchiveText::tr("the lab cannot be put there"), .file = labs};
}

} // namespace cradle
