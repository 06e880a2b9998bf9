// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/observation.h"

#include "model/stepper.h"

namespace cradle {

namespace {

/// Enough for a minute of a hundred circles at a fine timestep.
constexpr qint64 maxBytes = 512LL * 1024 * 1024;

} // namespace

Observation observe(const Variant &variant)
{
    Observation observation{variant, Recording(maxBytes)};
    Stepper stepper(variant.preset);
    World world = initialWorld(variant.preset);
    observation.states.append(world);
    std::vector<Hit> hits;
    const auto steps = static_cast<qint64>(std::ceil(variant.duration / variant.preset.timestep));
    for (qint64 k = 0; k < steps; ++k) {
        hits.clear();
        stepper.advance(world, hits);
        observation.states.append(world, hits);
    }
    return observation;
}

} // namespace cradle
