// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/wall_rebound_words.h"

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

/// Names the law by which walls give the part of a velocity into them back.
class BackNamer : WallRebounds
{
public:
    explicit BackNamer(const WallComparison &walls)
        : WallRebounds(walls)
    {
    }

    [[nodiscard]] ReboundWords words(const std::vector<std::size_t> &odd, std::size_t shown) const
    {
        const WallHit &hit = m_own.hits[shown];
        const auto back = [](const WallHit &h) { return h.back; };
        if (const auto [one, two] = unlike(odd, m_own.denser, true); one && two)
            return {
                WallText::tr("At the %walls the density comes into the speed of %who"),
                WallText::tr("With ρ = %1 what comes back is %2 times the speed, with ρ = %3 "
                             "it is %4 times; %5 is right.")
                        .arg(brief(densityOf(*one)), brief(one->back), brief(densityOf(*two)),
                             brief(two->back),
                             brief(rightOf(static_cast<std::size_t>(one - m_own.hits.data())).back))
                    + QLatin1Char(' ') + lookAtNew(),
                false, false};
        if (const auto words = slantWords(*this, odd))
            return *words;
        for (const BackLaw &law : backLaws()) {
            if ((rebounds() || !law.hasE) && follows(odd, back, law.back))
                return {law.headline, law.why};
        }
        if (std::all_of(odd.begin(), odd.end(),
                        [&](std::size_t i) { return m_own.hits[i].back < 0.0; }))
            return {WallText::tr("Hits at the %walls leave %who moving outward"),
                    WallText::tr("Its velocity still points into the wall: look at what it is "
                                 "worked out from."),
                    true, false};
        if (const auto words = fixedLossWords(*this, odd))
            return *words;
        const auto number = [&](double) { return hit.back; };
        if (odd.size() > 2 && rebounds() && follows(odd, back, number))
            return {WallText::tr("At the %walls a number stands for e, for %who"),
                    WallText::tr("With every e tried %1 of the speed comes back.")
                        .arg(brief(hit.back))};
        const double share = hit.back / hit.restitution;
        if (rebounds() && hit.restitution > 0.0
            && follows(odd, back, [&](double e) { return share * e; }))
            return {WallText::tr("Hits at the %walls give %who %1 e of the speed back, not e")
                        .arg(brief(share)),
                    lookAtNew()};
        if (const auto speed = ownSpeed(odd))
            return {WallText::tr("Hits at the %walls give %who a speed of their own"),
                    WallText::tr("From every speed tried it has %1 m/s along the normal "
                                 "afterwards: work the new velocity out from the old one.")
                        .arg(brief(*speed)),
                    true, false};
        // What is so of one speed is no law of e.
        if (const auto [one, two] = unlike(odd, m_own.slower, false); rebounds() && one && two)
            return {WallText::tr("Hits at the %walls give %who another share of the speed than e"),
                    WallText::tr("With e = %1 a hit with %2 m/s into the wall gives %3 times the "
                                 "speed back, one with %4 m/s %5 times: the share should be the "
                                 "same for every speed.")
                            .arg(brief(one->restitution), speedInto(*one), brief(one->back),
                                 speedInto(*two), brief(two->back))
                        + QLatin1Char(' ') + lookAtNew(),
                    false, false};
        // A share that is seen with one e alone is no law.
        if (const WallHit *other = rebounds() ? otherShare(odd, hit) : nullptr)
            return {WallText::tr("Hits at the %walls give %who another share of the speed than e"),
                    WallText::tr("With e = %1 it is %2 times the speed, with e = %3 %4 times.")
                            .arg(brief(hit.restitution), brief(hit.back), brief(other->restitution),
                                 brief(other->back))
                        + QLatin1Char(' ') + lookAtNew(),
                    false, false};
        const auto lowest = std::min_element(odd.begin(), odd.end(), [&](auto a, auto b) {
            return m_own.hits[a].back < m_own.hits[b].back;
        });
        const auto highest = std::max_element(odd.begin(), odd.end(), [&](auto a, auto b) {
            return m_own.hits[a].back < m_own.hits[b].back;
        });
        const double least = m_own.hits[*lowest].back;
        const double most = m_own.hits[*highest].back;
        if (!isNear(least, most))
            return {
                WallText::tr("Hits at the %walls give %who between %1 and %2 times the speed back")
                    .arg(brief(least), brief(most)),
                extremes(m_own.hits[*lowest], m_own.hits[*highest]), false, false, true};
        const double asked = rightOf(shown).back;
        return {WallText::tr("Hits at the %walls give %who %1 times the speed back")
                    .arg(briefBeside(hit.back, asked)),
                lookAtNew(), true, false};
    }

private:
    static double densityOf(const WallHit &hit)
    {
        return hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body.density;
    }

    /// One of those hits and one like it among \p others, as fast or not, of whose speed another
    /// share comes back; null if there is none.
    [[nodiscard]] std::pair<const WallHit *, const WallHit *>
    unlike(const std::vector<std::size_t> &odd, const std::vector<WallHit> &others,
           bool isAsFast) const
    {
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            for (const WallHit &other : others) {
                const bool isLike =
                    other.circle == hit.circle && other.wall == hit.wall && other.turned
                    && hit.turned && other.restitution == hit.restitution
                    && other.radius == hit.radius
                    && (length(other.came - hit.came) < 1e-6 * length(hit.came)) == isAsFast;
                if (isLike && !isNear(other.back, hit.back))
                    return {&hit, &other};
            }
        }
        return {};
    }

    static QString speedInto(const WallHit &hit)
    {
        return brief(dot(hit.came, outwardNormal(hit.wall)));
    }

    static QString lookAtNew()
    {
        return WallText::tr("Look at what the new velocity is worked out from.");
    }

    /// Where the least and the most of the speed came back.
    static QString extremes(const WallHit &least, const WallHit &most)
    {
        return WallText::tr("The least came at the %1 with %2 m/s into it, the most at the %3 with "
                            "%4 m/s.")
            .arg(motion::wallName(least.wall), speedInto(least), motion::wallName(most.wall),
                 speedInto(most));
    }

    /// A hit like \p hit with another e that gives another share of the speed back.
    [[nodiscard]] const WallHit *otherShare(const std::vector<std::size_t> &odd,
                                            const WallHit &hit) const
    {
        const WallHit *right = nullptr;
        for (std::size_t i = 0; i < m_own.hits.size(); ++i) {
            const WallHit &other = m_own.hits[i];
            if (other.restitution == hit.restitution || !other.turned || other.circle != hit.circle
                || isNear(other.back, hit.back))
                continue;
            if (std::find(odd.begin(), odd.end(), i) != odd.end())
                return &other;
            right = other.wall == hit.wall ? &other : right;
        }
        return right;
    }

    /// What may stand where the speed that comes back does.
    struct BackLaw {
        double (*back)(double e);
        bool hasE; ///< it says something of e
        QString headline;
        QString why;
    };

    static std::vector<BackLaw> backLaws()
    {
        const QString look = WallText::tr("Its velocity still points into the wall: look at the "
                                          "sign.");
        return {{[](double) { return 1.0; }, true,
                 WallText::tr("Hits at the %walls give %who all of the speed back"),
                 WallText::tr("With every e tried nothing of it is lost.")},
                {[](double e) { return e * e; }, true,
                 WallText::tr("At the %walls e acts on %who twice"),
                 WallText::tr("Heights go with e², speeds with e.")},
                {[](double e) { return std::sqrt(e); }, true,
                 WallText::tr("At the %walls the root of e acts on %who"),
                 WallText::tr("What comes back of the speed is e times it, not √e times.")},
                {[](double) { return 0.0; }, false,
                 WallText::tr("Hits at the %walls take the part of %who along the normal away"),
                 WallText::tr("Of the part along the normal nothing comes back.")},
                {[](double e) { return 1.0 - e; }, true,
                 WallText::tr("At the %walls 1 − e stands where e belongs, for %who"),
                 WallText::tr("1 − e is what is lost; e is what is left.")},
                {[](double e) { return 1.0 + e; }, true,
                 WallText::tr("At the %walls 1 + e stands where e belongs, for %who"),
                 WallText::tr("1 + e is the whole change of the velocity, e what comes back.")},
                {[](double) { return -1.0; }, false,
                 WallText::tr("Hits at the %walls leave %who moving outward"), look},
                {[](double e) { return -e; }, true,
                 WallText::tr("Hits at the %walls slow %who and turn nothing round"), look}};
    }

    /// The speed that all leave a wall with, though they came with several.
    [[nodiscard]] std::optional<double> ownSpeed(const std::vector<std::size_t> &odd) const
    {
        const auto speedOf = [](Vec2 v, const WallHit &hit) {
            return std::abs(dot(v, outwardNormal(hit.wall)));
        };
        const WallHit &first = m_own.hits[odd.front()];
        const double left = speedOf(first.left, first);
        bool several = false;
        for (const std::size_t i : odd) {
            const WallHit &hit = m_own.hits[i];
            if (std::abs(speedOf(hit.left, hit) - left) > 0.02 * left)
                return std::nullopt;
            several |= std::abs(speedOf(hit.came, hit) / speedOf(first.came, first) - 1.0) > 0.1;
        }
        return several ? std::optional(left) : std::nullopt;
    }
};

} // namespace

ReboundWords backWords(const WallComparison &walls, const std::vector<std::size_t> &odd,
                       std::size_t shown)
{
    return BackNamer(walls).words(odd, shown);
}

} // namespace cradle
