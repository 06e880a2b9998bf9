// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// Scenes to begin a step with, by their names in the language of the moment; walls reflect, and
/// hits keep momentum and energy.
[[nodiscard]] std::vector<Preset> sceneTemplates();

} // namespace cradle
