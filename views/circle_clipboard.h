// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <vector>

namespace cradle {

/// The circles \p indices of \p preset as the text of a preset file with no others, for the
/// clipboard: it can be pasted into another window, read in an editor and saved as a scene.
[[nodiscard]] QString circlesText(const Preset &preset, const std::vector<int> &indices);

/// The circles of a preset file's \p text; an Error says why there are none.
[[nodiscard]] Result<std::vector<PresetCircle>> circlesFromText(const QString &text);

} // namespace cradle
