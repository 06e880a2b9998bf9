// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/world.h"

#include <deque>
#include <span>
#include <unordered_map>

namespace cradle {

/// A hit, or a contact that lasts: hits of the same two that follow each other within a few steps,
/// in which they do not leave each other by more than a radius, as of a circle that rests on the
/// floor.
struct Encounter {
    double time = 0.0;    ///< of its first hit, s
    qint64 step = 0;      ///< at whose end that shows
    double endTime = 0.0; ///< of its last hit, s
    qint64 endStep = 0;
    qint64 hit = 0; ///< number of the first hit among all hits ever, from 0

    [[nodiscard]] bool lasts() const { return endStep > step; }
    friend bool operator==(const Encounter &, const Encounter &) = default;
};

/// The contacts of a run, read from its hits one after the other.
class EncounterLog
{
public:
    /// A hit of the same two no more than so many steps after the last one goes on with its
    /// contact.
    static constexpr qint64 restingSteps = 3;

    /// \param hits     of one step, after which the circles are \p circles
    /// \param first    number of the first of them among all hits ever
    void add(std::span<const Hit> hits, std::span<const Circle> circles, qint64 first);
    /// Forgets what came after step \p step, whose end was at \p time s.
    void truncateAfter(qint64 step, double time);
    /// Forgets the contacts that began before step \p step.
    void dropBefore(qint64 step);

    /// In the order in which they began.
    [[nodiscard]] const std::deque<Encounter> &encounters() const { return m_encounters; }
    /// How many were forgotten at the front; an index into all contacts ever is this + i.
    [[nodiscard]] qint64 dropped() const { return m_dropped; }
    /// Indices among all contacts ever of those that last, in order.
    [[nodiscard]] const std::deque<qint64> &lasting() const { return m_lasting; }

private:
    [[nodiscard]] bool goesOn(const Encounter &contact, const Hit &hit,
                              std::span<const Circle> circles) const;
    void forgetOld(qint64 step);
    [[nodiscard]] qint64 end() const
    {
        return m_dropped + static_cast<qint64>(m_encounters.size());
    }

    std::deque<Encounter> m_encounters;
    std::deque<qint64> m_lasting;
    std::unordered_map<quint64, qint64> m_latest; ///< contact of two that may go on
    std::size_t m_tidyAt = 1024;                  ///< entries at which old ones are forgotten
    qint64 m_dropped = 0;
};

} // namespace cradle
