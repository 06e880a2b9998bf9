// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/grading/class_folder.h"
#include "tasks/grading/class_journal.h"
#include "tasks/grading/workers.h"

#include <functional>
#include <map>
#include <memory>

namespace cradle {

/// How far a class has come.
struct ClassProgress {
    int students = 0;  ///< of all
    int kept = 0;      ///< that were done by a run before
    int done = 0;      ///< with those
    int steps = 0;     ///< that were judged by this run
    int passed = 0;    ///< of these
    int failed = 0;    ///< of these
    int notGraded = 0; ///< of these
};

/// Judges the students of a class and writes students/ID.json of each as soon as it is done.
class ClassGrader
{
public:
    struct Hooks {
        std::function<void(const ClassProgress &, const StudentResult &)> done{}; ///< a student
        std::function<void(const ClassProgress &)> idle{}; ///< now and then in between
        std::function<bool()> stopped{};                   ///< asked all the time
        std::function<Result<std::unique_ptr<Workers>>()> startWorkers{};
    };

    /// \param classRoot  see ClassFolder::root
    ClassGrader(const Lab &lab, QByteArray classRoot, QByteArray secret, ClassJournal &journal,
                Hooks hooks)
        : m_lab(lab)
        , m_classRoot(std::move(classRoot))
        , m_secret(std::move(secret))
        , m_journal(journal)
        , m_hooks(std::move(hooks))
    {
    }

    /// Judges all of \p students that the journal does not have with the same work already, \p jobs
    /// at a time by \p workers.
    /// \return what kept it from going on; nothing also if it was stopped
    [[nodiscard]] std::optional<Error> run(const std::vector<FoundStudent> &students, int jobs,
                                           std::unique_ptr<Workers> workers);

    [[nodiscard]] const ClassProgress &progress() const { return m_progress; }

private:
    /// A student who is being judged.
    struct Job {
        StudentResult result{};
        JudgingRequest request{}; ///< what is still to be judged
        QString workHash{};
        int kills = 0;
    };

    std::optional<Error> begin(const FoundStudent &student, int number);
    [[nodiscard]] bool isDone(const QString &id, const QString &workHash) const;
    std::optional<Error> take(WorkerEvent event);
    std::optional<Error> finish(int number);
    std::optional<Error> revive();

    const Lab &m_lab;
    QByteArray m_classRoot;
    QByteArray m_secret;
    ClassJournal &m_journal;
    Hooks m_hooks;
    std::unique_ptr<Workers> m_workers{};
    Isolation m_isolation{}; ///< of all that judge this class
    std::map<int, Job> m_jobs{};
    ClassProgress m_progress{};
    int m_deaths = 0; ///< of the process that forks workers, since one has done something
};

} // namespace cradle
