// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/note_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

namespace {

constexpr double leastStride = 4.0;  ///< px from one place that is tried to the next
constexpr double triedAcross = 40.0; ///< places that are tried, about
constexpr double down = 24.0;
constexpr double noteInset = 4.0;  ///< px from the edges of the plot
constexpr double curveGap = 2.0;   ///< px that a note keeps from curves
constexpr double cursorGap = 5.0;  ///< px that it keeps from the cursor
constexpr double cursorCost = 1e4; ///< hidden columns: what happens there is what it is about
constexpr double steepCost = 0.5;  ///< columns that a px of height is worth
constexpr double wayCost = 0.05;   ///< of a px from the cursor: less than a column of a curve

/// How much of the curves is hidden: columns of pixels, those of steep parts by their height.
double hiddenColumns(const QRectF &plot, const std::vector<CurveProfile> &curves,
                     const QRectF &rect)
{
    double sum = 0.0;
    const int from = static_cast<int>(rect.left() - plot.left());
    const int to = static_cast<int>(rect.right() - plot.left());
    for (const CurveProfile &curve : curves) {
        for (int column = from; column <= to; ++column) {
            const double height = std::min(curve.bottom(column), rect.bottom() + curveGap)
                                  - std::max(curve.top(column), rect.top() - curveGap);
            if (curve.covers(column) && height >= 0.0)
                sum += std::max(1.0, steepCost * height);
        }
    }
    return sum;
}

} // namespace

NotePlace quietestPlace(const QRectF &plot, const std::vector<CurveProfile> &curves, QSizeF size,
                        double cursor)
{
    const QRectF room = plot.adjusted(noteInset, noteInset, -noteInset, -noteInset);
    const QPointF first(std::round(room.left()), std::round(room.top()));
    const double toRight = std::max(leastStride, std::floor(room.width() / triedAcross));
    const double toBottom = std::max(leastStride, std::floor(room.height() / down));
    NotePlace best{QRectF(first, size), hiddenColumns(plot, curves, QRectF(first, size))};
    double least = std::numeric_limits<double>::infinity();
    for (double y = first.y(); y + size.height() <= room.bottom(); y += toBottom) {
        for (double x = first.x(); x + size.width() <= room.right(); x += toRight) {
            const QRectF rect(QPointF(x, y), size);
            const bool onCursor =
                rect.left() - cursorGap < cursor && cursor < rect.right() + cursorGap;
            const double way = std::abs(rect.center().x() - cursor)
                               + std::abs(rect.center().y() - plot.center().y());
            const double hidden = hiddenColumns(plot, curves, rect);
            const double cost = hidden + wayCost * way + (onCursor ? cursorCost : 0.0);
            if (cost < least) {
                least = cost;
                best = {rect, hidden};
            }
        }
    }
    return best;
}

} // namespace cradle
