// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_pair.h"

#include "tasks/judging/likeness.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double alikeParts = 4e-3; ///< of velocities after a hit in such a step, relative

bool partsAlike(const PairVelocities &a, const PairVelocities &b)
{
    return isAlike(a.along1, b.along1, alikeParts) && isAlike(a.across1, b.across1, alikeParts)
           && isAlike(a.along2, b.along2, alikeParts) && isAlike(a.across2, b.across2, alikeParts);
}

bool answersAlike(const std::vector<PairHit> &a, const std::vector<PairHit> &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const PairHit &p, const PairHit &q) {
                          return p.answered == q.answered && p.leaper == q.leaper
                                 && (!p.answered || partsAlike(p.leftParts(), q.leftParts()));
                      });
}

} // namespace

bool MeasuredPair::contactIsLike(const MeasuredPair &other) const
{
    if (isJudged != other.isJudged || contacts.size() != other.contacts.size()
        || modes.size() != other.modes.size())
        return false;
    // Ways of a step that overlap: more apart are two distances.
    constexpr double alikeWays = 1.01;
    const auto meetAlike = [](const PairHit &a, const PairHit &b) {
        return a.answered == b.answered && a.isHeld() == b.isHeld()
               && (!a.answered
                   || (a.parting == b.parting
                       && std::abs(a.reached - b.reached)
                              <= alikeWays
                                     * std::max(std::abs(a.before - a.reached),
                                                std::abs(b.before - b.reached))));
    };
    const auto met = [](const PairHit &a, const PairHit &b) { return a.isMet() == b.isMet(); };
    const auto answersOwnAlone = [](const MeasuredPair &pair) {
        return pair.own && pair.own->answered
               && std::none_of(pair.contacts.begin(), pair.contacts.end(),
                               [](const PairHit &hit) { return hit.answered; });
    };
    return std::equal(contacts.begin(), contacts.end(), other.contacts.begin(), meetAlike)
           && std::equal(modes.begin(), modes.end(), other.modes.begin(), met)
           && std::equal(varied.begin(), varied.end(), other.varied.begin(), other.varied.end(),
                         met)
           && answersOwnAlone(*this) == answersOwnAlone(other)
           && slow.has_value() == other.slow.has_value()
           && (!slow || slow->isMet() == other.slow->isMet());
}

bool MeasuredPair::sequelIsLike(const MeasuredPair &other) const
{
    const auto answered = [](const PairHit &a, const PairHit &b) {
        return a.answered == b.answered;
    };
    const auto leaps = [](const PairHit &a, const PairHit &b) {
        return a.leaper == b.leaper && a.isPutFar() == b.isPutFar()
               && a.misplaced.has_value() == b.misplaced.has_value();
    };
    return (ownContacts > 1) == (other.ownContacts > 1)
           && std::equal(contacts.begin(), contacts.end(), other.contacts.begin(),
                         other.contacts.end(), leaps)
           && std::equal(partings.begin(), partings.end(), other.partings.begin(),
                         other.partings.end(), answered);
}

bool MeasuredPair::responseIsLike(const MeasuredPair &other) const
{
    if (isJudged != other.isJudged || own.has_value() != other.own.has_value())
        return false;
    if (own && !partsAlike(own->leftParts(), other.own->leftParts())
        && length(own->left1 - other.own->left1) + length(own->left2 - other.own->left2) > 0.1)
        return false;
    if (spread.has_value() != other.spread.has_value())
        return false;
    if (later && other.later && later->isFirstOdd() != other.later->isFirstOdd())
        return false;
    return answersAlike(equals, other.equals) && answersAlike(radii, other.radii)
           && answersAlike(densities, other.densities) && answersAlike(rebounds, other.rebounds);
}

} // namespace cradle
