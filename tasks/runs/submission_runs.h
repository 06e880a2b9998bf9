// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/runs/observation.h"
#include "tasks/runs/submission.h"

#include <memory>
#include <vector>

namespace cradle {

/// The runs of one submission. Checks, and seeds, often ask for the same scene: it runs once.
class SubmissionRuns
{
public:
    /// \param submission  must outlive this
    explicit SubmissionRuns(const Submission &submission)
        : m_submission(submission)
    {
    }

    [[nodiscard]] const Submission &submission() const { return m_submission; }

    /// observe() of \p variant; the reference holds until the next call. A run that \p stop
    /// or \p mostInstructions ended is not kept.
    const Observation &of(const Variant &variant, const std::function<bool()> &stop = {},
                          qint64 mostInstructions = std::numeric_limits<qint64>::max());

private:
    struct Run {
        Variant asked; ///< the observation has what the program made of it
        Observation seen;
    };

    const Submission &m_submission;
    std::vector<std::unique_ptr<const Run>> m_kept;
    std::unique_ptr<const Run> m_latest; ///< if it is not kept
    qint64 m_bytes = 0;                  ///< of all that are kept
};

} // namespace cradle
