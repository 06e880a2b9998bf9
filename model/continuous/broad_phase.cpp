// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/broad_phase.h"

namespace cradle {

namespace {

/// The skin as a share of the mean spacing of the circles: wide enough that sorting is rare,
/// narrow enough that few pairs are looked at.
constexpr double skinShare = 0.65;

double meanSpeedOf(const Crowd &crowd)
{
    double sum = 0.0;
    for (Crowd::Slot slot = 0; slot < crowd.count(); ++slot)
        sum += crowd.speed(slot);
    return sum / std::max(1.0, static_cast<double>(crowd.count()));
}

} // namespace

void BroadPhase::start(const Crowd &crowd)
{
    m_skinWidth =
        skinShare * crowd.width / std::sqrt(std::max(1.0, static_cast<double>(crowd.count())));
    m_meanSpeed = meanSpeedOf(crowd);
    m_dt = 0.0;
}

void BroadPhase::sort(double dt, Crowd &crowd, std::span<Crowd::Pair> pairs)
{
    m_grid.build(crowd.small, [&crowd](std::size_t i) { return crowd.motions[i].position; });
    const std::span<const Crowd::Slot> sorted = m_grid.sorted().first(crowd.small);
    crowd.arrange(sorted);
    if (!pairs.empty()) {
        m_moved.resize(crowd.count());
        for (Crowd::Slot slot = 0; slot < crowd.count(); ++slot)
            m_moved[slot < crowd.small ? sorted[slot] : slot] = slot;
        for (Crowd::Pair &pair : pairs)
            pair = {m_moved[pair.a], m_moved[pair.b]};
    }
    double fastest = 0.0;
    for (const Motion &motion : crowd.motions)
        fastest = std::max(fastest, lengthSquared(motion.velocity));
    m_meanSpeed = meanSpeedOf(crowd);
    m_dt = dt;
    m_index = 0;
    m_skin.start(dt, crowd.gravity, m_skinWidth, std::sqrt(fastest));
}

} // namespace cradle
