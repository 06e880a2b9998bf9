// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// A run that the proof found worth a look.
struct SceneVisit {
    Preset scene{};
    bool pinned = false; ///< the scene keeps its values whatever on_load sets
    QString program{};   ///< its file in the step, "mistakes/NAME.lua"
    QString source{};    ///< of the program; empty: the laws move the circles
    qint64 step = 0;     ///< where it went wrong
};

} // namespace cradle
