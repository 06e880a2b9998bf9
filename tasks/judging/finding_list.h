// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/fault_lines.h"
#include "tasks/judging/step_deviations.h"

namespace cradle {

/// What was found in a submission, in the order of the aspects, with the lines at fault.
class FindingList
{
public:
    /// All but \p lines must live as long.
    FindingList(const Task &task, const Submission &submission, const StepDeviations &deviations,
                FaultLines lines)
        : m_task(task)
        , m_submission(submission)
        , m_deviations(deviations)
        , m_lines(std::move(lines))
    {
    }

    [[nodiscard]] const std::vector<Finding> &all() const { return m_findings; }
    [[nodiscard]] bool has(Aspect aspect) const;
    /// Gives all of them away.
    [[nodiscard]] std::vector<Finding> take() { return std::move(m_findings); }

    /// In the deviation's own words.
    void add(const LawDeviation &deviation) { add(deviation, {}, deviation.message); }
    /// In those of a known mistake.
    void add(const LawDeviation &deviation, const KnownScript &mistake)
    {
        add(deviation, mistake.name, mistake.message);
    }
    /// Behind what is said of the start, before all else.
    void addToStart(const LawDeviation &deviation);
    /// Of what is worked out and never written: marked where something else is written.
    void addWritten(const LawDeviation &deviation);

    /// Whether the change that mends one of them mends this, too.
    [[nodiscard]] bool isMended(const LawDeviation &deviation) const
    {
        return m_lines.isMendedBefore(deviation, m_findings);
    }
    /// With what was told last, which the same change mends.
    void tellMended(const LawDeviation &deviation);
    /// A paragraph of its own behind the last of \p aspect, of which there is one.
    void tellBehind(Aspect aspect, const QString &words);

private:
    void add(const LawDeviation &deviation, const QString &mistake, const QString &message);
    void pointToUnread(Finding &finding) const;

    const Task &m_task;
    const Submission &m_submission;
    const StepDeviations &m_deviations;
    FaultLines m_lines;
    std::vector<Finding> m_findings{};
};

} // namespace cradle
