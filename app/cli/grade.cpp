// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/grade_progress.h"
#include "app/cli/grade_request.h"
#include "app/cli/lab_at_hand.h"

#include "model/file_io.h"
#include "tasks/grading/class_folder.h"
#include "tasks/grading/raw_folder.h"
#include "tasks/grading/student_seed.h"
#include "tasks/lab_reader.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextStream>

#include <csignal>

#include <sys/stat.h>

namespace cradle::cli {

namespace {

struct GradeText {
    Q_DECLARE_TR_FUNCTIONS(Cli)
};

volatile std::sig_atomic_t stopAsked = 0;

/// A first Ctrl+C is noticed by who looks; a second ends the process.
void watchForStop()
{
    struct sigaction action {
    };
    action.sa_handler = [](int) { stopAsked = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND); // who waits is woken
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

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
    progress.remark(GradeText::tr("a secret was made for the scenes of this class: %1; keep it, "
                                  "and publish it to nobody")
                        .arg(kept));
    return secret;
}

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

/// What differs between two versions, for who asked for the one and has the other.
QString differenceOf(const ResultsVersion &there, const ResultsVersion &now)
{
    QStringList parts;
    if (there.labId != now.labId || there.labHash != now.labHash)
        parts.append(GradeText::tr("the lab"));
    if (there.cradle != now.cradle)
        parts.append(QStringLiteral("Cradle"));
    if (there.secretHash != now.secretHash)
        parts.append(GradeText::tr("the secret"));
    return parts.join(QStringLiteral(", "));
}

/// Removes the files of students who are not, or no longer, among those of \p ids.
void removeOthers(const QString &results, Manifest &manifest, const QStringList &ids)
{
    const QSet<QString> wanted(ids.begin(), ids.end());
    std::erase_if(manifest.students, [&](const auto &each) {
        if (wanted.contains(each.first))
            return false;
        for (const char *suffix : {".json", ".html"})
            QFile::remove(results + QStringLiteral("/students/") + each.first
                          + QLatin1String(suffix));
        return true;
    });
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

    ExitCode run(const ClassFolder &found)
    {
        auto journal = ClassJournal::open(m_request.results);
        if (!journal)
            return complainUnwritten(journal.error());
        const auto secret = secretFor(m_request, m_progress);
        if (!secret)
            return complain(secret.error());
        auto workers = startWorkers();
        if (!workers)
            return complainUnwritten(workers.error());
        const Isolation isolation = (*workers)->isolation();
        if (m_request.requireIsolation && !isolation.isWhole())
            return complainUnwritten(
                {GradeText::tr("--require-isolation: this machine has only: %1")
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
        if (const auto error = journal->begin(manifest))
            return complainUnwritten(*error);
        m_progress.start(static_cast<int>(students.size()), isolationText(isolation));
        for (const QString &remark : found.remarks)
            m_progress.remark(remark);
        watchForStop();
        return judge(*journal, found, students, *secret, std::move(*workers));
    }

private:
    Result<std::unique_ptr<Workers>> startWorkers() const
    {
        return Workers::start(m_lab.lab, m_lab.files, m_lab.folder,
                              QCoreApplication::applicationFilePath());
    }

    [[nodiscard]] Manifest manifestOf(const ClassFolder &found, const QByteArray &secret,
                                      const Isolation &isolation) const
    {
        Manifest manifest{.version = {.cradle = QStringLiteral("Cradle ")
                                                + QCoreApplication::applicationVersion(),
                                      .labId = m_lab.lab.id,
                                      .labVersion = m_lab.lab.version,
                                      .labHash = m_lab.lab.hash,
                                      .secretHash = sha256("cradle class secret " + secret)},
                          .shard = m_request.shard,
                          .className =
                              shownName(lastName(QFile::encodeName(m_request.submissions))),
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
                GradeText::tr("%1 holds results of another version (%2); another "
                              "folder is right, or --again to begin anew")
                    .arg(m_request.results, there.version == manifest.version
                                                ? GradeText::tr("the shard")
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
             .stopped = [] { return stopAsked != 0; },
             .startWorkers = [this] { return startWorkers(); }});
        const auto fault = grader.run(students, m_request.jobs, std::move(workers));
        if (fault || stopAsked) {
            m_progress.end(grader.progress(), "stopped");
            if (fault)
                return complainUnwritten(*fault);
            return Stopped;
        }
        if (m_request.shard.count == 1) {
            if (const auto error = writeResults(journal.manifest()))
                return complainUnwritten(*error);
        }
        if (const auto error = journal.finish())
            return complainUnwritten(*error);
        m_progress.end(grader.progress(), "done");
        return verdictOn(journal.manifest());
    }

    std::optional<Error> writeResults(const Manifest &manifest)
    {
        ClassFacts facts{.className = manifest.className,
                         .platform = manifest.platform,
                         .isolation = manifest.isolation,
                         .program = manifest.version.cradle,
                         .late = m_request.late,
                         .missing = manifest.missing,
                         .remarks = manifest.remarks};
        return writeClassResults(m_request.results, m_lab.lab, facts, [this](int done, int total) {
            m_progress.stage("writing", done, total);
        });
    }

    [[nodiscard]] ExitCode verdictOn(const Manifest &manifest) const
    {
        bool graded = true;
        bool passed = true;
        for (const auto &[id, student] : manifest.students) {
            graded = graded && student.notGraded == 0;
            passed = passed && student.notPassed == 0;
        }
        return graded && (passed || m_request.exitZero) ? Done : NotPassed;
    }

    const GradeRequest &m_request;
    const LabAtHand &m_lab;
    GradeProgress m_progress;
};

} // namespace

ExitCode grade(const QStringList &arguments)
{
    const auto parsed = parseGradeRequest(arguments);
    if (const auto *code = std::get_if<ExitCode>(&parsed))
        return *code;
    const auto &request = std::get<GradeRequest>(parsed);
    std::vector<RosterRow> roster;
    if (!request.rosterPath.isEmpty()) {
        auto read = readRoster(request.rosterPath);
        if (!read)
            return complain(read.error());
        roster = std::move(*read);
    }
    const auto lab = readLabAtHand(request.labPath.isEmpty() ? QString::fromLatin1(shippedLab)
                                                             : request.labPath);
    if (!lab)
        return complain(lab.error());
    if (!request.dryRun && isWithin(request.results, request.submissions))
        return complain(GradeText::tr("the results may not go where the submissions are"));
    const auto found = readClassFolder(QFile::encodeName(request.submissions), lab->lab.id, roster);
    if (!found)
        return complain(found.error());
    return Grading(request, *lab).run(*found);
}

} // namespace cradle::cli
