// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/run/recording.h"

#include <deque>
#include <functional>
#include <optional>

namespace cradle {

/// The hits that fall on one column of pixels.
struct HitColumn {
    int x = 0;             ///< px from the left
    std::size_t first = 0; ///< index of the first of them
    std::size_t count = 0;
};

/// The columns of a time axis from \p t0 to \p t1 over \p width pixels that have hits, from left
/// to right: O(width · log hits).
[[nodiscard]] std::vector<HitColumn> hitColumns(const std::deque<Encounter> &hits, double t0,
                                                double t1, int width);

/// Where contacts last, as stretches from and to on an axis on which \p xOf places times; stretches
/// that touch are one.
[[nodiscard]] std::vector<std::pair<double, double>>
lastingEncounters(const Recording &recording, const std::function<double(double)> &xOf);

/// The index of the hit nearest to \p time.
[[nodiscard]] std::optional<std::size_t> nearestHit(const std::deque<Encounter> &hits, double time);

/// The index of the last hit that shows at \p step or before.
[[nodiscard]] std::optional<std::size_t> lastHit(const std::deque<Encounter> &hits, qint64 step);

} // namespace cradle
