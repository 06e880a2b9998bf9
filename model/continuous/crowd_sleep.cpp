// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/crowd_sleep.h"

#include <algorithm>

namespace cradle {

namespace {

/// s for which a pile lies before it sleeps.
constexpr double untilSleep = 0.5;
constexpr double mostStill = 250.0; ///< steps
/// Of the speed that gravity gives in a step: what has come no farther meanwhile than at so much
/// lies. That is the error of its pushes, which, one upon the other, are off by as many times more
/// as there are more rows than in a pile of 1,000. It is the way that tells, for the errors of
/// thousands never all are small in one moment, but they go to and fro.
constexpr double lying = 0.05;
constexpr double fewRows = 32.0;
/// Of the same: the error shakes a circle to and fro at no more than this, what falls does not.
constexpr double shaking = 0.5;
/// Of the same: what a rounding leaves to one that lies without a pile.
constexpr double roundedSpeed = 1e-9;

} // namespace

void layToSleep(Crowd &crowd, double dt, StepGroups &groups)
{
    const double gain = crowd.gravity * dt;
    const double steps = std::min(untilSleep / dt, mostStill);
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        StepGroups::Member &group = groups[groups.groupOf(i)];
        const Motion &after = groups[i].after;
        const bool pile = crowd.isPile(group.size);
        const double rows = pile ? std::sqrt(static_cast<double>(group.size)) : 0.0;
        const double reach = lying * gain * untilSleep * std::max(1.0, rows / fewRows);
        const bool slow = length(after.velocity) <= (pile ? shaking : roundedSpeed) * gain;
        if (crowd.sleep.countStill(crowd.ids[groups[i].slot], slow, after.position, reach) < steps)
            group.restless = true;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> tired; // group, circle
    for (std::uint32_t i = 0; i < groups.size(); ++i) {
        const std::uint32_t group = groups.groupOf(i);
        if (groups[group].restless)
            continue;
        const Crowd::Slot slot = groups[i].slot;
        crowd.motions[slot].velocity = Vec2{};
        crowd.slotOf[crowd.ids[slot]] = slot;
        tired.emplace_back(group, crowd.ids[slot]);
    }
    std::sort(tired.begin(), tired.end());
    std::vector<std::uint32_t> island;
    for (std::size_t k = 0; k < tired.size(); ++k) {
        island.push_back(tired[k].second);
        if (k + 1 == tired.size() || tired[k + 1].first != tired[k].first) {
            crowd.sleep.lay(island);
            island.clear();
        }
    }
}

} // namespace cradle
