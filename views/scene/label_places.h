// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_builder.h"
#include "views/scene/scene_draft.h"

namespace cradle {

/// Turns the wishes of \p draft into labels, the most important first. All else that is drawn must
/// be in it, for labels avoid that.
void placeLabels(SceneDraft &draft, const SceneLook &look);

} // namespace cradle
