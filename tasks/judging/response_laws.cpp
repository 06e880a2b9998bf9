// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_laws.h"

#include "tasks/judging/likeness.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

struct ResponseLawText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

constexpr double hitBlur = 5e-3; ///< of a velocity: the line of centres turns a little in a step

using Hit = const EqualHit &;

/// Each circle by itself, or none of them.
std::vector<ResponseLaw> separateLaws()
{
    const QString both = ResponseLawText::tr("A hit acts on both circles.");
    const QString wall =
        ResponseLawText::tr("Nobody holds the other circle as a wall is held: look at "
                            "what each circle gets of the other.");
    return {
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("A hit leaves circle 2 as it was"), both, true},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("A hit leaves circle 1 as it was"), both, true},
        {[](Hit) { return PairVelocities{}; }, ResponseLawText::tr("A hit stops both circles"),
         ResponseLawText::tr("That was right in the step that only looked for the contact.")},
        {[](Hit h) {
             return PairVelocities{0, 0, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("A hit stops circle 1 and leaves circle 2 as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, 0, 0};
         },
         ResponseLawText::tr("A hit stops circle 2 and leaves circle 1 as it was"), both},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, -h.in.across1, -h.in.along2, -h.in.across2};
         },
         ResponseLawText::tr("Each circle is turned back on its own way"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Each circle bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, h.right.along2, h.right.across2};
         },
         ResponseLawText::tr("Circle 1 bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{h.right.along1, h.right.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 2 bounces as off a wall"), wall},
        {[](Hit h) {
             return PairVelocities{-h.in.along1, h.in.across1, h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 1 bounces as off a wall, and circle 2 stays as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, h.in.across1, -h.in.along2, h.in.across2};
         },
         ResponseLawText::tr("Circle 2 bounces as off a wall, and circle 1 stays as it was"), both},
        {[](Hit h) {
             return PairVelocities{h.in.along1, -h.in.across1, h.in.along2, -h.in.across2};
         },
         ResponseLawText::tr("The parts across the line of centres turn round, not those along it"),
         ResponseLawText::tr("The push acts along the line of centres.")}};
}

} // namespace

PairVelocities pushed(const EqualHit &h, double factor)
{
    const PairVelocities &in = h.in;
    const PairVelocities &r = h.right;
    return {in.along1 + factor * (r.along1 - in.along1),
            in.across1 + factor * (r.across1 - in.across1),
            in.along2 + factor * (r.along2 - in.along2),
            in.across2 + factor * (r.across2 - in.across2)};
}

bool isSameAnswer(const PairVelocities &a, const PairVelocities &b, double gain)
{
    // A line of centres that has turned a little turns a push that is much too strong.
    const double across = hitBlur + 1e-3 * gain;
    return isAlike(a.along1, b.along1, hitBlur) && isAlike(a.across1, b.across1, across)
           && isAlike(a.along2, b.along2, hitBlur) && isAlike(a.across2, b.across2, across);
}

bool follows(const ResponseLaw &law, const std::vector<EqualHit> &hits)
{
    return !hits.empty() && std::all_of(hits.begin(), hits.end(), [&](const EqualHit &h) {
        const double came = std::max(length(h.hit.came1), length(h.hit.came2));
        const double left = std::max(length(h.hit.left1), length(h.hit.left2));
        return isSameAnswer(h.hit.leftParts(), law.answer(h), std::max(left - came, 0.0));
    });
}

std::vector<EqualHit> comparableHits(const std::vector<PairHit> &own,
                                     const std::vector<PairHit> &right)
{
    std::vector<EqualHit> hits;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (own[i].isMet() && right[i].isMet() && own[i].isAligned() && right[i].isAligned())
            hits.push_back({own[i], own[i].cameParts(), right[i].leftParts()});
    }
    return hits;
}

std::vector<ResponseLaw> knownResponses()
{
    std::vector<ResponseLaw> all = separateLaws();
    for (const auto &more : {exchangeLaws(), directionLaws()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace cradle
