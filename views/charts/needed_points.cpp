// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/needed_points.h"

#include <algorithm>
#include <limits>

namespace cradle {

QList<qsizetype> neededPoints(const QList<QPointF> &pixels, double tolerance)
{
    QList<qsizetype> needed;
    constexpr double steepest = std::numeric_limits<double>::infinity();
    double least = -steepest; // slopes from the last needed point that pass all since then
    double greatest = steepest;
    for (qsizetype i = 0; i < pixels.size(); ++i) {
        if (i > 0) {
            const QPointF way = pixels[i] - pixels[needed.last()];
            const double slope = way.y() / way.x();
            if (way.x() > 0.0 && slope >= least && slope <= greatest) {
                least = std::max(least, (way.y() - tolerance) / way.x());
                greatest = std::min(greatest, (way.y() + tolerance) / way.x());
                continue;
            }
            if (needed.last() != i - 1) {
                needed.append(i - 1);
                least = -steepest;
                greatest = steepest;
                --i; // once more, from there
                continue;
            }
        }
        needed.append(i);
        least = -steepest;
        greatest = steepest;
    }
    if (!pixels.isEmpty() && needed.last() != pixels.size() - 1)
        needed.append(pixels.size() - 1);
    return needed;
}

} // namespace cradle
