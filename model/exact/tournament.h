// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace cradle {

/// Which of many is due first: each has one time, and the winner of every match of a knockout tree
/// is the earlier. A new time costs a walk from the leaf to the root, the same whatever the times,
/// so that a processor need not guess; a heap is shorter, but guesses wrong.
/// Source: Knuth, The Art of Computer Programming, vol. 3, 2nd ed., 5.4.1.
class Tournament
{
public:
    using Slot = std::uint32_t;

    /// \p count ≥ 1 players, none due ever.
    void reset(std::size_t count)
    {
        m_times.assign(count, std::numeric_limits<double>::infinity());
        m_winners.resize(2 * count);
        for (std::size_t i = 0; i < count; ++i)
            m_winners[count + i] = static_cast<Slot>(i);
        for (std::size_t node = count; --node > 0;)
            m_winners[node] = m_winners[2 * node];
    }

    void set(Slot slot, double time)
    {
        m_times[slot] = time;
        Slot winner = slot;
        for (std::size_t node = m_times.size() + slot; node > 1; node /= 2) {
            const Slot rival = m_winners[node ^ 1U];
            const double rivalTime = m_times[rival];
            winner = rivalTime < time ? rival : winner;
            time = std::min(rivalTime, time);
            m_winners[node / 2] = winner;
        }
    }

    [[nodiscard]] Slot first() const { return m_winners[1]; }
    [[nodiscard]] double firstTime() const { return m_times[first()]; }
    /// When the first is due that is not \p first().
    [[nodiscard]] double secondTime() const
    {
        double time = std::numeric_limits<double>::infinity();
        for (std::size_t node = m_times.size() + first(); node > 1; node /= 2)
            time = std::min(time, m_times[m_winners[node ^ 1U]]);
        return time;
    }

    /// Calls visit(slot) for some of those that are due soonest, if there are many.
    template <class Visit>
    void visitSoonest(Visit visit) const
    {
        constexpr std::size_t some = 8;
        if (m_times.size() < many)
            return;
        for (std::size_t node = some; node < 2 * some; ++node)
            visit(m_winners[node]);
    }

private:
    static constexpr std::size_t many = 4096; ///< more than a processor has near at hand
    std::vector<double> m_times;
    std::vector<Slot> m_winners; ///< node i plays nodes 2i and 2i + 1; the leaves come last
};

} // namespace cradle
