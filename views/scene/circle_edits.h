// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/preset.h"

namespace cradle {

/// Edits of the list of circles, as new presets; a crowd that was filled becomes a plain list.

/// The preset with one more circle at or near \p at (m): at rest, touching nothing, inside the
/// square; with the next free name "circle N" and a colour that few others have.
[[nodiscard]] Preset withNewCircle(const Preset &preset, Vec2 at);

/// The preset with a copy of circle \p index at the end of the list: at the same place where
/// circles pass through each other, else beside it.
[[nodiscard]] Preset withDuplicate(const Preset &preset, int index);

[[nodiscard]] Preset withoutCircle(const Preset &preset, int index);

/// The place nearest to \p at where a circle of \p radius touches no other and no wall; \p at
/// itself (inside the square) if there is none.
[[nodiscard]] Vec2 freePlace(const Preset &preset, Vec2 at, double radius);

} // namespace cradle
