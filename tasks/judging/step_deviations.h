// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/asked_laws.h"
#include "tasks/judging/deviation.h"
#include "tasks/judging/measured_laws.h"
#include "tasks/runs/submission.h"

#include <optional>

namespace cradle {

/// In what programs go wrong in a step, aspect by aspect, where its failed checks ask for that.
class StepDeviations
{
public:
    /// All must live as long.
    /// \param right  the laws of the step's reference
    StepDeviations(const Task &task, const Submission &submission,
                   const std::vector<CheckOutcome> &checks, const MeasuredLaws &right,
                   const Ground &ground);

    /// The failed check in which the aspect shows; null if none asks for it.
    [[nodiscard]] const CheckOutcome *failedOf(Aspect aspect) const;
    [[nodiscard]] bool isAsked(Aspect aspect) const;
    /// Whether there is no solution, and what is right is what the checks themselves tell.
    [[nodiscard]] bool isOfChecks() const { return m_asked.has_value(); }

    /// In what a program goes wrong in one aspect.
    [[nodiscard]] std::vector<LawDeviation> of(const MeasuredLaws &laws, Aspect aspect) const;
    /// The same, and what is said of that beside it which a change may spoil.
    [[nodiscard]] std::vector<LawDeviation> besides(const MeasuredLaws &laws, Aspect aspect) const;
    /// Whether another program passes all checks that failed but those of the start, within the
    /// WorkLimit.
    [[nodiscard]] bool passes(const QString &program) const;

private:
    [[nodiscard]] bool isKnown(Aspect aspect) const;
    /// Null of what is no check of the step, such as a breach.
    [[nodiscard]] const CheckSpec *specOf(const CheckOutcome &outcome) const;

    const Task &m_task;
    const Submission &m_submission;
    const std::vector<CheckOutcome> &m_checks;
    const MeasuredLaws &m_right;
    const Ground &m_ground;
    std::optional<AskedLaws> m_asked; ///< where there is no solution
};

} // namespace cradle
