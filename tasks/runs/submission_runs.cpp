// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/submission_runs.h"

#include <algorithm>

namespace cradle {

namespace {

/// Enough for all runs of a step of a lab, with five seeds.
constexpr qint64 mostBytes = 64 * 1024 * 1024;

} // namespace

const Observation &SubmissionRuns::of(const Variant &variant, const std::function<bool()> &stop,
                                      qint64 mostInstructions)
{
    const auto known = std::find_if(m_kept.begin(), m_kept.end(),
                                    [&](const auto &run) { return run->asked == variant; });
    // One that takes more is made anew, to end where it would have ended at first.
    if (known != m_kept.end() && (*known)->seen.instructions <= mostInstructions)
        return (*known)->seen;
    bool stopped = false;
    const auto ask = [&] { return stopped = stop && stop(); };
    m_latest = std::make_unique<const Run>(
        Run{variant, observe(variant, m_submission.program(), ask, mostInstructions)});
    const qint64 bytes = m_latest->seen.states.bytes();
    if (stopped || m_latest->seen.instructions > mostInstructions || m_bytes + bytes > mostBytes)
        return m_latest->seen;
    m_bytes += bytes;
    m_kept.push_back(std::move(m_latest));
    return m_kept.back()->seen;
}

} // namespace cradle
