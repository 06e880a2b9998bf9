// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// Scenes to begin a step with.
enum class SceneTemplate {
    HeadOn,   ///< one circle straight at one at rest
    Glancing, ///< the same, off centre
    Cradle,   ///< Newton's: one circle at a row of four that touch
    Gas,      ///< a crowd with random velocities
    Drop      ///< one circle falls onto the floor
};

inline constexpr SceneTemplate allTemplates[] = {SceneTemplate::HeadOn, SceneTemplate::Glancing,
                                                 SceneTemplate::Cradle, SceneTemplate::Gas,
                                                 SceneTemplate::Drop};

/// A few words, translated.
[[nodiscard]] QString titleOf(SceneTemplate scene);

/// The scene; walls reflect, and hits keep momentum and energy.
[[nodiscard]] Preset presetOf(SceneTemplate scene);

} // namespace cradle
