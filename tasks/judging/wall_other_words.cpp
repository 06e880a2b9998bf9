// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_comparison.h"

#include "tasks/checks/figures.h"

#include <algorithm>

namespace cradle {

namespace {

/// Judges what becomes of the other circle in the step in which a wall answers one.
class OtherJudge : WallComparison
{
public:
    explicit OtherJudge(const WallComparison &walls)
        : WallComparison(walls)
    {
    }

    /// A hit that changes the velocity of another circle, too, of which nothing else is told.
    [[nodiscard]] std::optional<LawDeviation> kicked() const
    {
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(),
                                     [](const WallHit &hit) { return hit.kicks && hit.missed; });
        if (at == m_own.hits.end())
            return std::nullopt;
        const bool isOfBoth = length(at->left - at->came) > 1e-6;
        const QString seen =
            isOfBoth ? WallText::tr("When circle %1 was %2 m from the %3 its velocity changed, and "
                                    "in the same step that of the other, far from it and from "
                                    "every wall. A wall turns the circle that touches it, and no "
                                    "other.")
                     : WallText::tr("When circle %1 was %2 m from the %3 its velocity stayed as it "
                                    "was, and that of the other changed, far from it and from "
                                    "every wall. A wall turns the circle that touches it, and no "
                                    "other.");
        LawDeviation found = deviation(
            isOfBoth ? WallText::tr("Beside a wall the velocity of both circles changes at once")
                     : WallText::tr("Beside a wall the velocity of another circle changes"),
            seen.arg(QString::number(at->circle + 1), brief(at->before),
                     motion::wallName(at->wall)),
            *at, {{at->circle}, {at->wall}}, Suspect::Question);
        if (isOfTwo(*at))
            found.family = QStringLiteral("of two");
        return found;
    }

    [[nodiscard]] std::optional<LawDeviation> disturbed() const
    {
        // What changes in the first step of a throw is no answer of a wall.
        const auto disturbs = [](const WallHit &hit) {
            return hit.disturbs && !hit.missed && (hit.step > 1 || hit.fits(hit.radius));
        };
        const auto at = std::find_if(m_own.hits.begin(), m_own.hits.end(), disturbs);
        const auto leaps = [](const WallHit &hit) { return hit.isLeap(); };
        if (at == m_own.hits.end() || std::any_of(m_own.hits.begin(), m_own.hits.end(), leaps)
            || std::any_of(m_right.hits.begin(), m_right.hits.end(), disturbs))
            return std::nullopt;
        if (isMovedOnlyThen(*at)) {
            return deviation(
                WallText::tr("Circle %1 moved only in a step in which a wall was hit")
                    .arg(at->circle == 0 ? 2 : 1),
                WallText::tr(
                    "In the step in which circle %1 was answered by the %2 the other circle went "
                    "%3 m; in no step before did it move. Look at what lets a step end before its "
                    "turn, as `return` and `break` do, and at what is asked before it moves.")
                    .arg(QString::number(at->circle + 1), motion::wallName(at->wall),
                         brief(at->otherWas.position - at->otherFree.position)),
                *at, {{at->circle}, {at->wall}}, Suspect::Question, true);
        }
        LawDeviation found = deviation(
            WallText::tr("As one circle hit a wall the way of the other changed"),
            WallText::tr("In the step in which circle %1 was answered by the %2, the other circle, "
                         "far from every wall, did not go on freely: its place is %3 m and its "
                         "velocity %4 m/s off. A wall acts on the circle that touches it, and on "
                         "no other.")
                .arg(QString::number(at->circle + 1), motion::wallName(at->wall),
                     brief(at->otherWas.position - at->otherFree.position),
                     brief(at->otherWas.velocity - at->otherFree.velocity)),
            *at, {{at->circle}, {at->wall}}, Suspect::Answer,
            length(at->otherWas.position - at->otherFree.position) > 1e-6);
        found.moment.circles = {at->circle == 0 ? 1 : 0};
        return found;
    }

private:
    /// Whether it may be a hit of the two, near a wall by chance: both rest after it, one has the
    /// velocity of the other, or the other was pushed along the line of centres. The one beside the
    /// wall may have been turned by that, too.
    [[nodiscard]] bool isOfTwo(const WallHit &hit) const
    {
        const auto isSame = [](Vec2 a, Vec2 b) { return length(a - b) < 1e-6; };
        const Vec2 line = normalized(hit.otherFree.position - hit.landed);
        const auto isAlong = [&](Vec2 push) {
            return std::abs(cross(push, line)) < 0.05 * length(push);
        };
        const Vec2 was = hit.otherFree.velocity;
        const Vec2 is = hit.otherWas.velocity;
        return m_ground.pair.asked
               && ((hit.left == Vec2{} && is == Vec2{}) || isSame(hit.left, was)
                   || isSame(is, hit.came) || isAlong(is - was));
    }

    /// Whether the other of two circles, which no step has moved, went on in that of \p hit.
    [[nodiscard]] static bool isMovedOnlyThen(const WallHit &hit)
    {
        const auto &circles = hit.stage.preset.circles;
        if (circles.size() != 2)
            return false;
        const Circle &start = circles[hit.circle == 0 ? 1 : 0].body;
        return hit.otherFree.position == start.position && hit.otherFree.velocity == start.velocity
               && hit.otherWas.position != start.position;
    }
};

} // namespace

std::optional<LawDeviation> kickedDeviation(const WallComparison &walls)
{
    return OtherJudge(walls).kicked();
}

std::optional<LawDeviation> disturbedDeviation(const WallComparison &walls)
{
    return OtherJudge(walls).disturbed();
}

} // namespace cradle
