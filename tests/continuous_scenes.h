// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/scenes.h"

/// Scenes and laws of continuous timing.
namespace cradle::scenes {

inline constexpr int minute = 3600; // steps of 1/60 s
inline constexpr double room = halfWidth - 0.2;

inline Laws lawsOf(CircleLaw law)
{
    return {WallLaw::Reflect, law, Timing::Continuous};
}

/// The circle glances off the other at T11 of the lab: 0.3 m beside its centre.
inline Preset glancing(CircleLaw law)
{
    return scene({circle({-2, 2.3}, {2, 0}), circle({2, 2}, {0, 0})}, lawsOf(law));
}

} // namespace cradle::scenes
