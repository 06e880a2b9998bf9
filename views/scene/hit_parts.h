// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"
#include "views/scene/scene_draft.h"

#include <optional>

namespace cradle {

/// A hit that is shown, and how clearly.
struct ShownHit {
    const Hit *hit;
    double opacity; ///< 1 at its step, less as it fades
};

/// The hits to show at \p moment: those of the shown step, while running also those of the last
/// hitSeconds; of each pair only the newest. In a crowd only those of \p selected.
[[nodiscard]] std::vector<ShownHit> shownHits(const SceneMoment &moment, int selected);

/// Where the two of \p hit touched, m; nullopt if its step is not kept, or it has no normal.
[[nodiscard]] std::optional<Vec2> contactOf(const SceneMoment &moment, const Hit &hit);

/// Draws \p shown: the normal, each circle's velocity before with its parts
///     v = (v·n) n + (v − (v·n) n)
/// along and across the normal n, and what it became, at the place of the hit. The label of an
/// arrow that leaves the picture stands at the part that is seen.
void addHitParts(SceneDraft &draft, const SceneMoment &moment, const ShownHit &shown,
                 const Camera &camera);

} // namespace cradle
