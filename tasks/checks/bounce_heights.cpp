// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/checks/check_kinds.h"
#include "tasks/checks/figures.h"
#include "tasks/checks/kinds.h"
#include "tasks/checks/motion.h"

#include <QCoreApplication>

#include <algorithm>

namespace cradle::kinds {

namespace {

struct HeightText {
    Q_DECLARE_TR_FUNCTIONS(Checks)
};

/// The highest point between two bounces.
struct Peak {
    double height = 0.0; ///< of the rim above the floor, m
    qint64 step = 0;
};

/// The wall onto which gravity pulls.
Wall floorUnder(Vec2 gravity)
{
    return *std::max_element(std::begin(allWalls), std::end(allWalls), [&](Wall a, Wall b) {
        return dot(outwardNormal(a), gravity) < dot(outwardNormal(b), gravity);
    });
}

/// The peaks of circle \p i: before the first bounce off \p floor, after it, and so on. The last is
/// left out if the circle still rises at the end.
std::vector<Peak> peaksOf(const Observation &o, int i, Wall floor)
{
    const Vec2 down = outwardNormal(floor);
    std::vector<Peak> peaks;
    Peak peak{motion::wallGap(o, o.circle(i, 0), floor), 0};
    bool fell = false;
    for (qint64 k = 1; k <= o.steps(); ++k) {
        const Circle &now = o.circle(i, k);
        const bool falls = dot(now.velocity, down) > 0.0;
        const double height = motion::wallGap(o, now, floor);
        if (fell && !falls) {
            peaks.push_back(peak);
            peak = {height, k};
        } else if (height > peak.height) {
            peak = {height, k};
        }
        fell = falls;
    }
    if (fell)
        peaks.push_back(peak);
    return peaks;
}

Fault wrongHeight(int i, std::size_t n, const Peak &peak, double expected, double e)
{
    return {.message =
                HeightText::tr("After bounce %1 circle %2 rises to %3 m above the floor; e to "
                               "the power of %4 times the first height, with e = %5, is "
                               "%6 m")
                    .arg(QString::number(n), QString::number(i + 1),
                         motion::figureBeside(peak.height, expected), QString::number(2 * n),
                         motion::figure(e), motion::figureBeside(expected, peak.height)),
            .expected = expected,
            .observed = peak.height,
            .unit = QStringLiteral("m"),
            .step = peak.step};
}

Fault tooFewBounces(int i, std::size_t seen, std::size_t wanted, qint64 last)
{
    return {.message = HeightText::tr("Circle %1 comes off the floor and down again %2 times; at "
                                      "least %3 is right")
                           .arg(i + 1)
                           .arg(seen)
                           .arg(wanted),
            .expected = static_cast<double>(wanted),
            .observed = static_cast<double>(seen),
            .step = last};
}

} // namespace

std::optional<Fault> bounceHeights(const CheckSpec &check, const Observation &o)
{
    const Wall floor = floorUnder(motion::gravityOf(check, o));
    const double e = motion::restitutionOf(check, o);
    const auto wanted = static_cast<std::size_t>(valueOf(check, QStringLiteral("bounces")).toInt());
    for (const int i : check.circles) {
        const std::vector<Peak> peaks = peaksOf(o, i, floor);
        if (peaks.empty())
            return tooFewBounces(i, 0, wanted, o.steps());
        const double first = peaks.front().height;
        const double slack = motion::toleranceOf(check) * first;
        double expected = first;
        for (std::size_t n = 1; n <= wanted; ++n) {
            expected *= e * e;
            // Hops that are lower than the tolerance say nothing.
            if (n >= peaks.size()) {
                if (expected <= slack)
                    break;
                return tooFewBounces(i, peaks.size() - 1, wanted, o.steps());
            }
            if (std::abs(peaks[n].height - expected) > slack)
                return wrongHeight(i, n, peaks[n], expected, e);
        }
    }
    return std::nullopt;
}

} // namespace cradle::kinds
