// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/crowd.h"

#include <algorithm>

namespace cradle {

/// The circles of a crowd that do not simply fly on in a step, the members, and the groups in which
/// they meet. Groups only grow. Members are known by their index, circles by their slot.
class StepGroups
{
public:
    using Slot = Crowd::Slot;

    struct Member {
        Slot slot = 0;
        std::uint32_t group = 0; ///< a member of its group that leads to the one that stands for it
        std::uint32_t run = 0;   ///< of the group, that counts
        bool changed = true;     ///< the group must be solved
        bool disturbed = false;  ///< has left its free flight
        bool restless = false;   ///< one of the group is not at rest for long enough
        std::uint32_t size = 1;  ///< of the group, if it stands for it
        double fastest = 0;      ///< speed in the step, m/s
        double foreseen = -1;    ///< whom it may reach at this speed has joined a pile already, m/s
        Motion after{};          ///< at the end of the step
    };

    /// For \p circles of them, none of which is a member.
    void start(std::size_t circles)
    {
        clear();
        m_places.assign(circles, 0);
    }
    /// Another step begins.
    void clear()
    {
        m_members.clear();
        m_fastest = 0.0;
    }

    [[nodiscard]] bool has(Slot slot) const
    {
        return m_places[slot] < m_members.size() && m_members[m_places[slot]].slot == slot;
    }
    /// The circle that is not a member becomes one, in a group of its own.
    void add(Slot slot)
    {
        m_places[slot] = static_cast<std::uint32_t>(m_members.size());
        m_members.push_back({.slot = slot, .group = m_places[slot]});
    }
    /// The index of a member.
    [[nodiscard]] std::uint32_t of(Slot slot) const { return m_places[slot]; }

    /// The member that stands for the group of another.
    [[nodiscard]] std::uint32_t groupOf(std::uint32_t member)
    {
        while (m_members[member].group != member) {
            m_members[member].group = m_members[m_members[member].group].group;
            member = m_members[member].group;
        }
        return member;
    }
    /// Makes one group of those of two members.
    void join(std::uint32_t a, std::uint32_t b)
    {
        const std::uint32_t first = groupOf(a);
        const std::uint32_t second = groupOf(b);
        if (first == second)
            return;
        Member &kept = m_members[std::min(first, second)];
        m_members[std::max(first, second)].group = std::min(first, second);
        kept.changed = true;
        kept.size += m_members[std::max(first, second)].size;
    }

    /// A member has this speed, m/s.
    void note(double speed) { m_fastest = std::max(m_fastest, speed); }
    /// The fastest that was noted, m/s.
    [[nodiscard]] double fastest() const { return m_fastest; }

    [[nodiscard]] std::uint32_t size() const
    {
        return static_cast<std::uint32_t>(m_members.size());
    }
    [[nodiscard]] Member &operator[](std::uint32_t member) { return m_members[member]; }
    [[nodiscard]] const Member &operator[](std::uint32_t member) const { return m_members[member]; }
    [[nodiscard]] auto begin() const { return m_members.begin(); }
    [[nodiscard]] auto end() const { return m_members.end(); }

private:
    std::vector<Member> m_members;
    std::vector<std::uint32_t> m_places; ///< of each slot in m_members, where it is there
    double m_fastest = 0.0;
};

} // namespace cradle
