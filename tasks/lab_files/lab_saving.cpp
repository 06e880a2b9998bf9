// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/lab_files/lab_files.h"

#include "model/files/file_io.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>

namespace cradle {

namespace {

struct LabSavingText {
    Q_DECLARE_TR_FUNCTIONS(LabFiles)
};

const QString indexFile = QStringLiteral("lab.json");

/// Whether the file is there with exactly this content.
bool holds(const QString &path, const QByteArray &content)
{
    QFile file(path);
    // The size tells first: what is there may be of any size.
    return QFileInfo(path).isFile() && file.size() == content.size()
           && file.open(QIODevice::ReadOnly) && file.readAll() == content;
}

/// Whether the file is as \p files says: there with that content, or not there.
bool isAsIn(const LabFiles &files, const QString &folder, const QString &path)
{
    const QString full = folder + QLatin1Char('/') + path;
    const auto found = files.contents.find(path);
    return found == files.contents.end() ? !QFileInfo::exists(full) : holds(full, *found);
}

std::optional<Error> writeInside(const QString &folder, const QString &path,
                                 const QByteArray &content)
{
    const QString full = folder + QLatin1Char('/') + path;
    const QString parent = QFileInfo(full).path();
    if (auto error = makeFolder(parent))
        return error;
    // A link in between must not lead out of the lab.
    const QString root = QFileInfo(folder).canonicalFilePath() + QLatin1Char('/');
    const QFileInfo target(full);
    const QString place = target.isSymLink()
                              ? target.canonicalFilePath()
                              : QFileInfo(parent).canonicalFilePath() + QLatin1Char('/');
    if (!place.startsWith(root))
        return Error{.message = LabSavingText::tr("a link here leads out of the lab; a file or "
                                                  "folder of its own is right"),
                     .file = full};
    return cradle::writeFile(full, content);
}

std::optional<Error> removeFile(const QString &folder, const QString &path)
{
    QFile file(folder + QLatin1Char('/') + path);
    if (file.exists() && !file.remove())
        return Error{.message = file.errorString(), .file = file.fileName()};
    // Folders that became empty go, too; rmdir() refuses all others.
    for (QString below = path.section(QLatin1Char('/'), 0, -2); !below.isEmpty();
         below = below.section(QLatin1Char('/'), 0, -2)) {
        if (!QDir(folder).rmdir(below))
            break;
    }
    return std::nullopt;
}

/// Paths that are none, or that only some file systems tell apart.
std::optional<Error> faultOfPaths(const LabFiles &files, const QString &folder)
{
    QSet<QString> lower;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        QString fault = faultOfLabPath(it.key());
        if (fault.isEmpty() && lower.contains(it.key().toLower()))
            fault = LabSavingText::tr("another file has this name but for capital letters; a name "
                                      "of its own is right");
        if (!fault.isEmpty())
            return Error{.message = fault, .file = folder + QLatin1Char('/') + it.key()};
        lower.insert(it.key().toLower());
    }
    return std::nullopt;
}

/// The paths on disk that are neither what was read nor what is to be written.
QStringList conflictsOf(const LabFiles &files, const LabFiles &asOnDisk, const QString &folder)
{
    QStringList conflicts;
    QStringList paths = asOnDisk.contents.keys() + files.contents.keys();
    paths.sort();
    paths.removeDuplicates();
    for (const QString &path : std::as_const(paths)) {
        if (!isAsIn(asOnDisk, folder, path) && !isAsIn(files, folder, path))
            conflicts.append(path);
    }
    return conflicts;
}

} // namespace

QStringList changedOnDisk(const LabFiles &asOnDisk, const QString &folder)
{
    QStringList changed;
    const Result<LabFiles> now = readLabFiles(folder);
    QStringList paths = asOnDisk.contents.keys();
    if (now)
        paths += now->contents.keys();
    paths.sort();
    paths.removeDuplicates();
    for (const QString &path : std::as_const(paths)) {
        const bool same = now && asOnDisk.contents.contains(path) == now->contents.contains(path)
                          && asOnDisk.contents.value(path) == now->contents.value(path);
        if (!same)
            changed.append(path);
    }
    return changed;
}

LabFiles withTheirs(const LabFiles &mine, const LabFiles &asOnDisk, const LabFiles &theirs)
{
    LabFiles merged = mine;
    for (const QString &path : asOnDisk.contents.keys()) {
        if (!theirs.contents.contains(path))
            merged.contents.remove(path);
    }
    for (auto it = theirs.contents.begin(); it != theirs.contents.end(); ++it) {
        const auto old = asOnDisk.contents.find(it.key());
        if (old == asOnDisk.contents.end() || *old != *it)
            merged.contents.insert(it.key(), *it);
    }
    return merged;
}

std::optional<Error> saveLabFiles(const LabFiles &files, const LabFiles &asOnDisk,
                                  const QString &folder, OnConflict onConflict)
{
    if (const auto fault = faultOfPaths(files, folder))
        return fault;
    if (onConflict == OnConflict::Refuse) {
        const QStringList conflicts = conflictsOf(files, asOnDisk, folder);
        if (!conflicts.isEmpty())
            return Error{.message = LabSavingText::tr("another program changed %1 since the lab "
                                                      "was read")
                                        .arg(conflicts.join(QStringLiteral(", "))),
                         .file = folder};
    }
    const auto write = [&](const QString &path) -> std::optional<Error> {
        if (isAsIn(files, folder, path))
            return std::nullopt;
        return writeInside(folder, path, files.contents.value(path));
    };
    if (auto error = makeFolder(folder))
        return error;
    for (auto it = files.contents.begin(); it != files.contents.end(); ++it) {
        if (it.key() == indexFile)
            continue;
        if (auto error = write(it.key()))
            return error;
    }
    if (files.contents.contains(indexFile)) {
        if (auto error = write(indexFile))
            return error;
    }
    for (auto it = asOnDisk.contents.begin(); it != asOnDisk.contents.end(); ++it) {
        if (files.contents.contains(it.key()))
            continue;
        if (auto error = removeFile(folder, it.key()))
            return error;
    }
    return std::nullopt;
}

} // namespace cradle
