// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

#include <QStringList>

namespace cradle {

/// What a run comes from.
struct RunSource {
    Preset preset;     ///< the scene that runs
    QString program{}; ///< that moves the circles; empty: the laws do

    friend bool operator==(const RunSource &, const RunSource &) = default;
};

/// What is different between two runs, each as "e 1 → 0.8", from \p then to \p now; the scene's
/// name and colours do not count. Empty if nothing is.
[[nodiscard]] QStringList differences(const RunSource &then, const RunSource &now);

} // namespace cradle
