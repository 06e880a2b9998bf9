// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/judging/deviation.h"

#include <optional>
#include <vector>

namespace cradle {

/// What a hit at a moment makes of the circles, beside what a right program makes of them.
class HitAtMoment
{
public:
    /// \param reference  right there; empty if none is known
    HitAtMoment(const QString &program, const QString &reference, const Moment &moment);

    /// The circles of the moment, from 0, whose velocity or place is wrong after it: those that are
    /// so by some share of the one that is most so; all where no right ones are known.
    [[nodiscard]] std::vector<int> wrongCircles() const;
    /// Whether only the size of the push is wrong, not its direction.
    [[nodiscard]] bool isSizeWrong() const;
    /// How many times as large as the right ones the pushes on both circles are; nothing if they
    /// are not along those, or it is not the same for both.
    [[nodiscard]] std::optional<double> timesRight() const;

private:
    [[nodiscard]] Vec2 offOf(int circle) const;

    const Moment &m_moment;
    std::optional<World> m_before;
    std::optional<World> m_own;
    std::optional<World> m_right;
};

} // namespace cradle
