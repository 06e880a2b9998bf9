// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_class.h"

#include "app/cli/grade_progress.h"
#include "app/cli/grade_results.h"
#include "app/cli/stop_signal.h"

#include "model/files/file_io.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/grading/student_seed.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/text/spoken_locale.h"

#include <QCoreApplication>
#include <QFile>

#include <sys/stat.h>

namespace cradle::cli {

namespace {

struct ClassText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

/// The class's secret: that of the option, or the one that is kept with the results.
Result<QByteArray> secretFor(const GradeRequest &request, GradeProgress &progress)
{
    if (!request.secretPath.isEmpty())
        return readSecret(request.secretPath);
    const QString kept = request.results + QStringLiteral("/secret.txt");
    if (QFile::exists(kept))
        return readSecret(kept);
    const QByteArray secret = newSecret();
    const mode_t before = umask(077);
    const auto error = writeFile(kept, secret + '\n');
    umask(before);
    if (error)
        return *error;
    progress.remark(ClassText::tr("a secret was made for the scenes of this class: %1; keep it, "
                                  "and publish it to nobody")
                        .arg(kept));
    return secret;
}

/// What differs between two versions, for who asked for the one and has the other.
QString differenceOf(const ResultsVersion &there, const ResultsVersion &now)
{
    QStringList parts;
    if (there.labId != now.labId || there.labHash != now.labHash)
        parts.append(ClassText::tr("the lab"));
    if (there.cradle != now.cradle)
        parts.append(QStringLiteral("Cradle"));
    if (there.secretHash != now.secretHash)
        parts.append(ClassText::tr("the secret"));
    if (there.language != now.language)
        parts.append(ClassText::tr("the language"));
    return spokenList(parts);
}

/// Grades the class that was asked for.
class Grading
{
public:
    Grading(const GradeRequest &request, const LabAtHand &lab)
        : m_request(request)
        , m_lab(lab)
        , m_progress(request.events)
    {
    }

    ExitCode run(const ClassFolder &found, ClassJournal &journal)
    {
        const auto secret = secretFor(m_request, m_progress);
        if (!secret)
            return complain(secret.error());
        auto workers = startWorkers();
        if (!workers)
            return complainUnwritten(workers.error());
        const Isolation isolation = (*workers)->isolation();
        if (m_request.requireIsolation && !isolation.isWhole())
            return complainUnwritten(
                {ClassText::tr("--require-isolation: this machine has only: %1")
                     .arg(isolationText(isolation))});
        Manifest manifest = manifestOf(found, *secret, isolation);
        if (const auto code = takeOver(manifest))
            return *code;
        const std::vector<FoundStudent> students =
            shardOf(found.students, m_request.shard.index, m_request.shard.count);
        QStringList ids;
        for (const FoundStudent &student : students)
            ids.append(student.id);
        removeOthers(m_request.results, manifest, ids);
        if (const auto error = exportLab(m_lab.files, m_request.results + QLatin1String(keptLab)))
            return complainUnwritten(*error);
        if (const auto error = journal.begin(manifest))
            return complainUnwritten(*error);
        m_progress.start(static_cast<int>(students.size()), isolationText(isolation));
        for (const QString &remark : found.remarks)
            m_progress.remark(remark);
        watchForStop();
        return judge(journal, found, students, *secret, std::move(*workers));
    }

private:
    Result<std::unique_ptr<Workers>> startWorkers() const
    {
        return Workers::start(m_lab.lab, m_lab.files, m_lab.folder, m_lab.language,
                              QCoreApplication::applicationFilePath());
    }

    /// That of the folder, or of the zip.
    [[nodiscard]] QString className() const
    {
        const QString name = shownName(lastName(QFile::encodeName(m_request.submissions)));
        return name.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive) ? name.chopped(4) : name;
    }

    [[nodiscard]] Manifest manifestOf(const ClassFolder &found, const QByteArray &secret,
                                      const Isolation &isolation) const
    {
        Manifest manifest{.version = {.cradle = QStringLiteral("Cradle ")
                                                + QCoreApplication::applicationVersion(),
                                      .labId = m_lab.lab.id,
                                      .labVersion = m_lab.lab.version,
                                      .labHash = m_lab.lab.hash,
                                      .secretHash = sha256("cradle class secret " + secret),
                                      .language = m_lab.language},
                          .shard = m_request.shard,
                          .className = className(),
                          .isolation = isolationText(isolation),
                          .missing = found.missing,
                          .remarks = found.remarks};
        for (const FoundStudent &student : found.students)
            manifest.classIds.append(student.id);
        return manifest;
    }

    /// Takes over what a run before has done, if it is of the same version.
    std::optional<ExitCode> takeOver(Manifest &manifest) const
    {
        auto before = readManifest(m_request.results);
        if (!before)
            return complain(before.error());
        if (!*before)
            return std::nullopt;
        Manifest &there = **before;
        if (there.version == manifest.version && there.shard == manifest.shard) {
            manifest.students = std::move(there.students);
            return std::nullopt;
        }
        if (!m_request.again)
            return complain(
                ClassText::tr("%1 holds results of another version (%2); another "
                              "folder is right, or --again to begin anew")
                    .arg(m_request.results, there.version == manifest.version
                                                ? ClassText::tr("the shard")
                                                : differenceOf(there.version, manifest.version)));
        removeOthers(m_request.results, there, {});
        return std::nullopt;
    }

    ExitCode judge(ClassJournal &journal, const ClassFolder &found,
                   const std::vector<FoundStudent> &students, const QByteArray &secret,
                   std::unique_ptr<Workers> workers)
    {
        ClassGrader grader(
            m_lab.lab, found.root, secret, journal,
            {.done = [this](const ClassProgress &progress,
                            const StudentResult &student) { m_progress.tell(progress, student); },
             .idle = [this](const ClassProgress &progress) { m_progress.show(progress); },
             .stopped = stopAsked,
             .startWorkers = [this] { return startWorkers(); }});
        const auto fault = grader.run(students, m_request.jobs, std::move(workers));
        if (fault || stopAsked()) {
            m_progress.end(grader.progress(), "stopped");
            if (fault)
                return complainUnwritten(*fault);
            return Stopped;
        }
        if (m_request.shard.count == 1) {
            if (const auto error =
                    writeResults(m_request, m_lab.lab, journal.manifest(), m_progress))
                return complainUnwritten(*error);
        }
        if (const auto error = journal.finish(true))
            return complainUnwritten(*error);
        m_progress.end(grader.progress(), "done");
        if (const auto unwritten = m_progress.fault())
            return complainUnwritten(*unwritten);
        return verdictOn(journal.manifest(), m_request);
    }

    const GradeRequest &m_request;
    const LabAtHand &m_lab;
    GradeProgress m_progress;
};

} // namespace

ExitCode gradeClass(const GradeRequest &request, const LabAtHand &lab, const ClassFolder &found,
                    ClassJournal &journal)
{
    return Grading(request, lab).run(found, journal);
}

} // namespace cradle::cli
