// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/charts/label_layout.h"

namespace cradle {

/// Where a note goes, and how much of the curves it hides.
struct NotePlace {
    QRectF rect{};       ///< px
    double hidden = 0.0; ///< columns of pixels, steep parts by their height
};

/// Where in \p plot a note of \p size px hides the fewest columns of curves and leaves the cursor
/// at \p cursor px free; the place nearest to the cursor if several do. The top left corner of the
/// plot if the note is larger than that.
[[nodiscard]] NotePlace quietestPlace(const QRectF &plot, const std::vector<CurveProfile> &curves,
                                      QSizeF size, double cursor);

} // namespace cradle
