// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/draw_list.h"

#include <limits>
#include <optional>

namespace cradle {

/// Names are the least important labels.
inline constexpr int nameRank = 3;

/// What a place of a label costs that lies far off or on a shaft: the less important ones are
/// left out then where a hit is shown.
inline constexpr double crampedCost = 5.5;

/// A label that still has to find its place.
struct LabelWish {
    DrawList::Label label{};
    Vec2 direction{};                ///< from the anchor, where it would like to be
    double clearance = 8.0;          ///< px from the anchor
    bool atAnchor = false;           ///< best on the anchor itself (a number in its disc)
    std::optional<Vec2> elsewhere{}; ///< another anchor, m, where there is no room at the first
    int rank = nameRank;             ///< the smallest find their places first
    bool clearOfDiscs = false;       ///< rather left out than put over a disc
    double mostCost = std::numeric_limits<double>::infinity(); ///< left out at worse places
};

/// A DrawList in the making: labels are placed when all that they avoid is known.
struct SceneDraft {
    DrawList list{};
    std::vector<LabelWish> wishes{}; ///< in the order they came up
};

/// \p colour with its opacity times \p opacity (0 to 1).
[[nodiscard]] inline QColor faded(QColor colour, double opacity)
{
    colour.setAlphaF(static_cast<float>(opacity) * colour.alphaF());
    return colour;
}

} // namespace cradle
