// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_class.h"
#include "app/cli/grade_results.h"
#include "app/cli/spoken.h"

#include "model/files/json_schema.h"
#include "tasks/grading/class_merge.h"
#include "tasks/grading/student_result_json.h"
#include "tasks/reading/lab_archive.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

namespace cradle::cli {

namespace {

struct MergeText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// The lab that the shards were judged by: what was asked for, or what one of them keeps.
Result<LabAtHand> labOf(const GradeRequest &request, const Manifest &manifest)
{
    QString path = request.labPath;
    for (const QString &folder : request.merged) {
        if (path.isEmpty() && QFileInfo::exists(folder + QLatin1String(keptLab)))
            path = folder + QLatin1String(keptLab);
    }
    if (path.isEmpty())
        return Error{MergeText::tr("none of the folders has the lab; --lab LAB is right")};
    auto lab = readLabAtHand(path, manifest.version.language);
    if (lab && lab->lab.hash != manifest.version.labHash)
        return Error{.message = MergeText::tr("the results were judged by another version of the "
                                              "lab"),
                     .file = path};
    return lab;
}

/// Copies the results of all students that are not there yet.
std::optional<Error> copyStudents(const MergedClass &merged, ClassJournal &journal)
{
    for (const auto &[id, path] : merged.files) {
        const DoneStudent &done = merged.manifest.students.at(id);
        const auto bytes = readFile(path, mostResultBytes);
        if (!bytes)
            return bytes.error();
        if (auto error = journal.keep(id, *bytes, done))
            return error;
    }
    return std::nullopt;
}

} // namespace

ExitCode mergeClass(const GradeRequest &request)
{
    for (const QString &folder : request.merged) {
        if (QFileInfo(folder).canonicalFilePath() == QFileInfo(request.results).canonicalFilePath()
            && !QFileInfo(folder).canonicalFilePath().isEmpty())
            return complain(
                MergeText::tr("the results of all may not go where those of a shard are"));
    }
    const auto merged = mergeResults(request.merged);
    if (!merged)
        return complain(merged.error());
    const QString language = merged->manifest.version.language;
    if (!request.language.isEmpty() && request.language != language)
        return complain(MergeText::tr("--language %1: the results are in the language %2, in which "
                                      "they were judged")
                            .arg(request.language, language));
    speak(language);
    const auto lab = labOf(request, merged->manifest);
    if (!lab)
        return complain(lab.error());
    auto journal = ClassJournal::open(request.results);
    if (!journal)
        return complainUnwritten(journal.error());
    const auto before = readManifest(request.results);
    if (before && *before) {
        Manifest there = **before;
        if (!(there.version == merged->manifest.version) && !request.again)
            return complain(MergeText::tr("%1 holds results of another version; another folder is "
                                          "right, or --again to begin anew")
                                .arg(request.results));
        removeOthers(request.results, there, QStringList(merged->manifest.classIds));
    }
    GradeProgress progress(request.events);
    for (const QString &remark : merged->remarks)
        progress.remark(remark);
    Manifest manifest = merged->manifest;
    manifest.students.clear();
    if (const auto error = exportLab(lab->files, request.results + QLatin1String(keptLab)))
        return complainUnwritten(*error);
    if (const auto error = journal->begin(manifest))
        return complainUnwritten(*error);
    if (const auto error = copyStudents(*merged, *journal))
        return complainUnwritten(*error);
    if (const auto error = writeResults(request, lab->lab, journal->manifest(), progress))
        return complainUnwritten(*error);
    if (const auto error = journal->finish(merged->lacking.isEmpty()))
        return complainUnwritten(*error);
    ClassProgress all{.students = static_cast<int>(manifest.classIds.size()),
                      .done = static_cast<int>(merged->files.size())};
    all.kept = all.done;
    progress.end(all, "done");
    if (const auto unwritten = progress.fault())
        return complainUnwritten(*unwritten);
    return merged->lacking.isEmpty() ? verdictOn(journal->manifest(), request) : NotPassed;
}

} // namespace cradle::cli
