// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/hand_in/hand_in.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/lab_files/lab_files.h"
#include "tasks/text/plain_text.h"
#include "tasks/workspace/history.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

namespace cradle {

namespace {

struct HandInText {
    Q_DECLARE_TR_FUNCTIONS(HandIn)
};

const QString infoFile = QStringLiteral("cradle.json");
const QString bundleFile = QStringLiteral("history.bundle");
const QString historyFile = QStringLiteral("history.json");
const QString noteFile = QStringLiteral("note-to-teacher.txt");
constexpr qint64 mostNoteBytes = 1024 * 1024;
constexpr qsizetype longestNote = 300; ///< letters, in one line

/// Versions and bundle of the repository in \p folder, if there is one.
void addHistory(WorkFiles &files, const StudentWork &work, const QString &folder)
{
    std::vector<KeptProgram> all;
    for (const auto &[id, step] : work.steps)
        all.insert(all.end(), step.versions.begin(), step.versions.end());
    if (!all.empty())
        files.insert(historyFile, historyText(all));
    const auto history = History::openExisting(folder);
    if (!history || (*history)->isEmpty())
        return;
    // A bundle that is too large is left out: the versions are there without it.
    const auto bundle = (*history)->bundle();
    if (bundle && bundle->size() <= limits::labFileBytes)
        files.insert(bundleFile, *bundle);
}

std::optional<Error> writeAll(const WorkFiles &files, const QString &folder)
{
    for (auto it = files.begin(); it != files.end(); ++it) {
        const QString path = folder + QLatin1Char('/') + it.key();
        if (auto error = makeFolder(QFileInfo(path).path()))
            return error;
        if (auto error = writeFile(path, *it))
            return error;
    }
    return std::nullopt;
}

/// The story of the file as a repository, of which git's own files are made here.
std::optional<Error> replay(const WorkFiles &files, const WorkManifest &manifest,
                            const QString &folder)
{
    const auto history = History::makeDerivable(folder);
    if (!history)
        return history.error();
    std::vector<KeptProgram> programs = historyFrom(files.value(historyFile));
    for (auto kept = programs.rbegin(); kept != programs.rend(); ++kept) {
        const Version &version = kept->version;
        // What is no name of a step would be another reference.
        if (!faultOfLabPath(version.taskId).isEmpty() || version.taskId.contains(QLatin1Char('/')))
            continue;
        if (auto error = (*history)->keep(version.taskId, kept->text.toUtf8(), version.note,
                                          manifest.student, version.when))
            return error;
    }
    return (*history)->commit(QStringLiteral("Handed in\n"), manifest.student);
}

} // namespace

Result<HandIn> gatherHandIn(const Lab &lab, const QString &folder, const Sender &sender,
                            qint64 seed, const QDateTime &when,
                            const std::function<void(int, int)> &progress,
                            const std::atomic_bool *cancelled)
{
    return gatherHandIn(lab, folder, sender, seed, when,
                        [&](const Lab &ofLab, const StudentWork &work) {
                            return makeLabReport(ofLab, work, seed, when, progress, cancelled);
                        });
}

Result<HandIn> gatherHandIn(const Lab &lab, const QString &folder, const Sender &sender,
                            qint64 seed, const QDateTime &when, const ReportMaker &makeReport)
{
    const auto files = readWorkFiles(folder);
    if (!files)
        return files.error();
    auto work = readWork(folder, lab);
    if (!work)
        return work.error();
    if (!sender.number.isEmpty())
        work->info.studentId = sender.number;
    work->info.labId = lab.id;
    work->info.labVersion = lab.version;
    work->info.labHash = lab.hash;
    HandIn handIn{.files = *files, .report = makeReport(lab, *work)};
    handIn.files.insert(infoFile, textOf(work->info));
    addHistory(handIn.files, *work, folder);
    handIn.manifest = {.labId = lab.id,
                       .labVersion = lab.version,
                       .labHash = lab.hash,
                       .student = work->info.student,
                       .studentId = work->info.studentId,
                       .when = when,
                       .seed = seed};
    for (const StepReport &step : handIn.report.steps)
        handIn.manifest.steps.push_back({step.id, nameOf(step.verdict)});
    nameSender(handIn, sender);
    return handIn;
}

void nameSender(HandIn &handIn, const Sender &sender)
{
    auto info = workspaceInfoFrom(handIn.files.value(infoFile), infoFile);
    if (!info)
        info = WorkspaceInfo{};
    if (!sender.name.isEmpty())
        info->student = sender.name;
    if (!sender.number.isEmpty())
        info->studentId = sender.number;
    handIn.files.insert(infoFile, textOf(*info));
    handIn.manifest.student = handIn.report.student = info->student;
    handIn.manifest.studentId = handIn.report.studentId = info->studentId;
    if (sender.note.trimmed().isEmpty())
        return;
    handIn.report.noteToTeacher = sender.note;
    handIn.files.insert(noteFile, sender.note.toUtf8());
}

Result<QByteArray> packHandIn(const HandIn &handIn, const QString &reportName,
                              const QByteArray &report)
{
    WorkFiles files = handIn.files;
    files.insert(reportName, report);
    return packWork(files, handIn.manifest);
}

Result<QString> openHandIn(const QString &path, const QString &place)
{
    const auto archive = readFile(path, limits::labBytes);
    if (!archive)
        return archive.error();
    const auto files = unpackWork(*archive, path);
    if (!files)
        return files.error();
    const auto manifest = manifestOf(*files);
    if (!manifest)
        return manifest.error();
    const QByteArray hash = QCryptographicHash::hash(*archive, QCryptographicHash::Sha256);
    const QString folder = place + QLatin1Char('/') + QString::fromLatin1(hash.toHex().left(32));
    if (QFileInfo(folder).isDir())
        return folder; // opened before
    if (auto error = makeFolder(place))
        return *error;
    QTemporaryDir unfinished(place + QStringLiteral("/.unpacked-XXXXXX"));
    const QString inside = unfinished.filePath(QStringLiteral("work"));
    if (auto error = writeAll(*files, inside))
        return *error;
    if (auto error = replay(*files, *manifest, inside))
        return *error;
    if (!QDir().rename(inside, folder))
        return Error{.message = HandInText::tr("the work cannot be put there"), .file = folder};
    return folder;
}

QString noteToTeacher(const QString &folder)
{
    const auto note = readFile(folder + QLatin1Char('/') + noteFile, mostNoteBytes);
    const QString text = printable(QString::fromUtf8(note ? *note : QByteArray())).simplified();
    return text.size() <= longestNote ? text : text.left(longestNote) + QStringLiteral("…");
}

} // namespace cradle
