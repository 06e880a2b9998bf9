// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <limits>
#include <utility>

namespace cradle {

/// While it is there, students' programs that are tried in this thread may work no more than that:
/// a bound that no clock moves, of what only helps to explain. Who tries them asks.
class WorkLimit
{
public:
    /// \param most  instructions; what nobody counts weighs as much as it takes
    explicit WorkLimit(qint64 most)
        : m_outer(std::exchange(s_end, s_done + most))
    {
    }
    ~WorkLimit() { s_end = m_outer; }
    WorkLimit(const WorkLimit &) = delete;
    WorkLimit &operator=(const WorkLimit &) = delete;

    /// Instructions; negative once it is passed.
    [[nodiscard]] static qint64 left() { return s_end - s_done; }
    [[nodiscard]] static bool isPassed() { return left() < 0; }

    static constexpr qint64 ofBegin = 3'000;       ///< making a program ready to run
    static constexpr qint64 ofUncountedCall = 200; ///< see limits::uncountedInstructions
    /// What a program of this thread has done, in instructions.
    static void count(qint64 done) { s_done += done; }

private:
    static inline thread_local qint64 s_done = 0;
    static inline thread_local qint64 s_end = std::numeric_limits<qint64>::max();
    qint64 m_outer;
};

} // namespace cradle
