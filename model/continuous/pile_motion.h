// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/continuous/pile_near.h"

#include <unordered_map>

namespace cradle {

/// The pushes of the latest steps, by the names of who pushed whom: where the search for the next
/// ones begins.
class PilePushes
{
public:
    void clear() { m_pushes.clear(); }
    [[nodiscard]] bool knows(const Pile &pile, const NearPair &pair) const
    {
        return m_pushes.contains(keyOf(pile, pair));
    }
    /// N s; 0 if it is not known.
    [[nodiscard]] double of(const Pile &pile, const NearPair &pair) const;
    /// Keeps what was found: \p contacts, and the pair of each among \p near.
    void keep(const Pile &pile, std::span<const PileContact> contacts,
              std::span<const NearPair> near, std::span<const std::uint32_t> pairOf);

private:
    [[nodiscard]] static std::uint64_t keyOf(const Pile &pile, const NearPair &pair);

    std::unordered_map<std::uint64_t, double> m_pushes;
};

/// How a pile moves in a step.
struct PileMotion {
    [[nodiscard]] const NearPair &pairOf(std::size_t contact) const
    {
        return near[nearOf[contact]];
    }

    std::vector<NearPair> near;        ///< all that may meet
    std::vector<PileContact> contacts; ///< those that do, or would without a push
    std::vector<std::uint32_t> nearOf; ///< each contact's place in near
    std::vector<Vec2> velocities;      ///< w of every circle, m/s
};

/// The velocities w = v + g h + Σ J n / m at which no contact closes faster than its gap allows,
///     0 ≤ J ⊥ gap/h − (closing speed of w) ≥ 0.
/// Contacts are those that would meet; then those, too, that the pushes make meet.
/// \param pushes  a guess, by those of earlier steps
/// \param motion  overwritten
void findMotion(const Pile &pile, PilePushes &pushes, PileMotion &motion);

} // namespace cradle
