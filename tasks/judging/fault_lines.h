// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/mending_values.h"
#include "tasks/judging/ran_lines.h"
#include "tasks/judging/step_deviations.h"
#include "tasks/judging/value_repairs.h"

#include <memory>

namespace cradle {

/// The lines at fault of one submission, fault by fault, and what the changes that prove them mend
/// besides.
class FaultLines
{
public:
    /// All must live as long.
    /// \param proves  whether lines are proven; else they are guessed
    FaultLines(const Task &task, const Submission &submission, const StepDeviations &deviations,
               const MeasuredLaws &own, const MeasuredLaws &right, const Ground &ground,
               bool proves);

    /// Marks in \p finding, which has the last assignment, a better line if there is one.
    /// \param before  the findings that come before it
    void point(Finding &finding, const LawDeviation &deviation, const std::vector<Finding> &before);

    /// Whether the change that mends what was found before mends this, too: it is the same fault.
    [[nodiscard]] bool isMendedBefore(const LawDeviation &deviation,
                                      const std::vector<Finding> &before) const;

private:
    /// The student's program with a change that mends a finding.
    struct Mended {
        Mended(QString source, const Ground &ground)
            : program(std::move(source))
            , laws(&program, ground)
        {
        }
        QString program;
        MeasuredLaws laws;
    };

    /// All must live as long.
    [[nodiscard]] MendingValues valuesOf(SoundValues &sound, const LawDeviation &deviation,
                                         const RanLines &ran) const;
    /// The line of which another value would mend it; 0 if that is not known.
    [[nodiscard]] int mendingLine(const LawDeviation &deviation, const RanLines &ran);
    /// Whether all that is wrong with the motion is of the circles of \p deviation.
    [[nodiscard]] bool isOfOne(const LawDeviation &deviation) const;
    /// Without a proof.
    /// \param workedOut  where the value that the last assignment writes back was worked out
    [[nodiscard]] int likelyLine(const Finding &finding, const LawDeviation &deviation,
                                 const RanLines &ran, std::optional<int> workedOut) const;
    [[nodiscard]] int provenLine(const LawDeviation &deviation, const RanLines &ran, int last,
                                 const std::vector<Finding> &before);
    /// Whether as much can be told of a changed program: what cannot be measured is not mended.
    [[nodiscard]] bool seesAsMuch(const MeasuredLaws &laws, Aspect aspect,
                                  const std::vector<Finding> &before) const;

    const Task &m_task;
    const Submission &m_submission;
    const StepDeviations &m_deviations;
    const MeasuredLaws &m_own;
    const MeasuredLaws &m_right;
    const Ground &m_ground;
    bool m_proves;
    qint64 m_workLeft; ///< of proofs, in instructions
    std::vector<std::unique_ptr<const Mended>> m_mended{};
};

} // namespace cradle
