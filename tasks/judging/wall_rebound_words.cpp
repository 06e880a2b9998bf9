// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_rebound_words.h"

#include "tasks/judging/brief_beside.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Names the law by which walls change the velocities of some hits.
class ReboundNamer : WallRebounds
{
public:
    explicit ReboundNamer(const WallComparison &walls)
        : WallRebounds(walls)
    {
    }

    [[nodiscard]] ReboundWords words(const std::vector<std::size_t> &odd, std::size_t shown) const
    {
        const WallHit &hit = m_own.hits[shown];
        const WallHit &right = rightOf(shown);
        const auto back = [](const WallHit &h) { return h.back; };
        const auto along = [](const WallHit &h) { return h.along; };
        const auto one = [](double) { return 1.0; };
        const auto minusOne = [](double) { return -1.0; };
        const auto zero = [](double) { return 0.0; };
        const auto same = [](double e) { return e; };
        const QString normalOnly =
            WallText::tr("Where nothing rubs, a push points along the normal only.");
        if (hit.held && hit.turnsLater > 0)
            return {WallText::tr("Hits at the %walls turn the velocity of %who round too late"),
                    WallText::tr("It is put back at once, and its velocity points away from the "
                                 "wall only %1 s later.")
                        .arg(brief(hit.turnsLater * hit.stage.preset.timestep))};
        if (turnLater(odd))
            return {WallText::tr("Hits at the %walls turn the velocity of %who round too late"),
                    WallText::tr("Its velocity points away from the wall only %1 s later, in steps "
                                 "of %2 s.")
                        .arg(brief(hit.turnsLater * hit.stage.preset.timestep),
                             briefTimestep(hit.stage.preset.timestep)),
                    true, false};
        if (hit.held && hit.goesBack)
            return {WallText::tr("At the %walls the way of %who turns round, not its velocity"),
                    WallText::tr("It goes back from the wall while its velocity still points into "
                                 "it: look at what is assigned to that.")};
        if (hit.held)
            return {WallText::tr("Hits at the %walls hold %who and turn no velocity round"),
                    hit.stays ? WallText::tr("In every step it is kept from going on, and its "
                                             "velocity still points into it.")
                              : WallText::tr(
                                  "It is kept from going on, and its velocity stays as it was.")};
        if (isOfOther(odd))
            return {WallText::tr("At the %walls %who gets the velocity of the other circle"),
                    WallText::tr("The other circle had %1 m/s. Look at whose velocity the line "
                                 "takes.")
                        .arg(brief(hit.otherFree.velocity)),
                    true, false};
        if (follows(odd, back, minusOne) && follows(odd, along, minusOne))
            return {WallText::tr("Hits at the %walls turn the wrong part of the velocity of %who"),
                    WallText::tr("The normal of the side walls points along x, that of floor and "
                                 "ceiling along y.")};
        if (follows(odd, along, [&](double e) { return rebounds() ? -e : -1.0; })
            && follows(odd, back, [&](double e) { return rebounds() ? e : 1.0; }))
            return {WallText::tr("Hits at the %walls turn the whole velocity of %who round"),
                    normalOnly};
        if (rebounds() && follows(odd, along, same) && follows(odd, back, same))
            return {WallText::tr("At the %walls e also shortens the part of %who along the wall"),
                    normalOnly};
        if (rebounds() && follows(odd, along, same) && follows(odd, back, one))
            return {WallText::tr("At the %walls e acts on the wrong part of the velocity of %who"),
                    normalOnly};
        if (follows(odd, along, minusOne))
            return {
                WallText::tr("Hits at the %walls turn the part of %who along the wall round, too"),
                normalOnly};
        if (follows(odd, along, zero))
            return {WallText::tr("Hits at the %walls take the part of %who along the wall away"),
                    normalOnly};
        if (isOfOtherPart(odd))
            return {WallText::tr("At the %walls the parts of the velocity of %who are mixed up"),
                    WallText::tr("The part into the wall is turned round, the part along it stays: "
                                 "look at which part stands where."),
                    true, false};
        const auto whole = [&](double) { return hit.along; };
        const AnswerGap gap = answerGap(hit, right);
        const bool isAlongOff = gap.off.y > gap.blur.y;
        if (isAlongOff && gap.off.x > gap.blur.x && follows(odd, along, whole)
            && follows(odd, back, whole))
            return {WallText::tr("Hits at the %walls give %who %1 times the whole velocity back")
                        .arg(brief(hit.along)),
                    normalOnly};
        if (const auto speed = ownWholeSpeed(odd))
            return {WallText::tr("Hits at the %walls give %who one and the same speed"),
                    WallText::tr("From every speed tried it leaves with %1 m/s: work the new "
                                 "velocity out from the old one.")
                        .arg(brief(*speed)),
                    true, false};
        if (isAlongOff)
            return {WallText::tr("Hits at the %walls change the part of %who along the wall"),
                    normalOnly, false, false};
        return backWords(*this, odd, shown);
    }

private:
    /// Whether all of them keep their velocity in the hit, and are turned in a step soon after.
    [[nodiscard]] bool turnLater(const std::vector<std::size_t> &odd) const
    {
        return std::all_of(odd.begin(), odd.end(), [&](std::size_t i) {
            return isNear(m_own.hits[i].back, -1.0) && m_own.hits[i].turnsLater > 0;
        });
    }

    /// Whether in all of them the part into the wall afterwards is as large as that along it was
    /// before, or e times as large, or the other way round.
    [[nodiscard]] bool isOfOtherPart(const std::vector<std::size_t> &odd) const
    {
        const auto isEqual = [&](double a, double b) { return isNear(std::abs(a), std::abs(b)); };
        const auto isOf = [&](double made, double came, const WallHit &hit) {
            return isEqual(made, came) || (rebounds() && isEqual(made, hit.restitution * came));
        };
        return odd.size() > 1 && std::all_of(odd.begin(), odd.end(), [&](std::size_t i) {
                   const WallHit &hit = m_own.hits[i];
                   const Vec2 n = outwardNormal(hit.wall);
                   const Vec2 t = perpendicular(n);
                   return isOf(dot(hit.left, n), dot(hit.came, t), hit)
                          || (isOf(dot(hit.left, t), dot(hit.came, n), hit)
                              && !isEqual(dot(hit.left, t), dot(hit.came, t)));
               });
    }

    /// Whether all of them leave with the part along the normal that the other circle has, or with
    /// that turned round. It had several.
    [[nodiscard]] bool isOfOther(const std::vector<std::size_t> &odd) const
    {
        const auto normal = [](Vec2 v, const WallHit &hit) {
            return std::abs(dot(v, outwardNormal(hit.wall)));
        };
        const auto other = [&](std::size_t i) {
            return normal(m_own.hits[i].otherFree.velocity, m_own.hits[i]);
        };
        return std::all_of(odd.begin(), odd.end(),
                           [&](std::size_t i) {
                               const WallHit &hit = m_own.hits[i];
                               return !hit.disturbs && other(i) > 0.0
                                      && std::abs(normal(hit.left, hit) - other(i)) < 0.02;
                           })
               && std::any_of(odd.begin(), odd.end(), [&](std::size_t i) {
                      return std::abs(other(i) - other(odd.front())) > 0.05;
                  });
    }

    /// The length of the velocity that all leave a wall with, though they came with several: both
    /// parts are scaled alike.
    [[nodiscard]] std::optional<double> ownWholeSpeed(const std::vector<std::size_t> &odd) const
    {
        const WallHit &first = m_own.hits[odd.front()];
        const double left = length(first.left);
        bool several = false;
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            if (std::abs(length(hit.left) - left) > 0.01 * left || !isNear(hit.back, hit.along))
                return std::nullopt;
            several |= std::abs(length(hit.came) / length(first.came) - 1.0) > 0.1;
        }
        return several && left > 0.0 ? std::optional(left) : std::nullopt;
    }
};

} // namespace

ReboundWords reboundWords(const WallComparison &walls, const std::vector<std::size_t> &odd,
                          std::size_t shown)
{
    return ReboundNamer(walls).words(odd, shown);
}

} // namespace cradle
