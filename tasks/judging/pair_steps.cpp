// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/brief_beside.h"
#include "tasks/judging/likeness.h"
#include "tasks/judging/pair_range.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <algorithm>
#include <cmath>

namespace cradle {

QString leftBeside(const PairHit &hit, const PairHit &other)
{
    const auto part = [](const PairHit &one, Vec2 velocity) {
        return one.seenPart(dot(velocity, one.normal));
    };
    return ResponseText::tr("%1 and %2 m/s")
        .arg(briefBeside(part(hit, hit.left1), part(other, other.left1)),
             briefBeside(part(hit, hit.left2), part(other, other.left2)));
}

QString cameTogether(const PairHit &hit, bool isOfE)
{
    const Meeting &m = hit.meeting;
    const QString one = brief(m.velocities.along1);
    const QString two = brief(m.velocities.along2);
    return isOfE ? ResponseText::tr("Two equal circles met head-on with %1 and %2 m/s; e was %3.")
                       .arg(one, two, brief(m.restitution))
                 : ResponseText::tr("Two equal circles met head-on with %1 and %2 m/s.")
                       .arg(one, two);
}

namespace {

/// Of a step, before the rims touch in it.
constexpr double touchesEarly = 1.0 / 4.0;
constexpr double touchesLate = 2.0 / 3.0;

/// Of the closing speed: head-on no line of centres turns, and what differs more is no blur. What a
/// wrong place makes of the answer differs a little from step to step, too, and with the timestep
/// more.
constexpr double otherInStep = 3e-3;
constexpr double otherTimestep = 1e-2;

bool isSteppedAlike(const PairHit &a, const PairHit &b, double blur)
{
    return length(a.left1 - b.left1) + length(a.left2 - b.left2) < blur * length(a.came1 - a.came2);
}

/// How many times as large as \p right the push of \p hit is along the line of centres.
double timesRight(const PairHit &hit, const PairHit &right)
{
    return dot(hit.push2() - hit.push1(), hit.normal)
           / dot(right.push2() - right.push1(), right.normal);
}

/// Whether a normal that is the way from one to the other by r₁ + r₂, taken at \p distance, makes
/// the pushes of both: its length comes into them once or twice.
bool isOfNormal(const std::vector<PairHit> &own, const std::vector<PairHit> &right,
                double PairHit::*distance)
{
    constexpr double normalBlur = 1e-3;
    const auto holds = [&](double power) {
        for (std::size_t i = 0; i < 2; ++i) {
            const double normal = own[i].*distance / own[i].meeting.sum();
            if (std::abs(timesRight(own[i], right[i]) - std::pow(normal, power)) > normalBlur)
                return false;
        }
        return true;
    };
    return holds(1.0) || holds(2.0);
}

/// That an answer is another one where the rims touch early in a step than where they do so late.
LawDeviation depthDeviation(const MeasuredPair &own, const MeasuredPair &right, bool isElseRight)
{
    const PairHit &early = own.inSteps[0];
    const PairHit &late = own.inSteps[1];
    const bool isOfOverlap = isOfNormal(own.inSteps, right.inSteps, &PairHit::reached);
    if (auto overlap = isOfOverlap && isElseRight ? overlapDeviation(own, right) : std::nullopt)
        return std::move(*overlap);
    const bool isOfNormalAhead = isOfNormal(own.inSteps, right.inSteps, &PairHit::before);
    const QString hint =
        isOfOverlap
            ? ResponseText::tr("Look at whether the normal has length 1 where they overlap.")
        : isOfNormalAhead
            ? ResponseText::tr("Look at whether the normal has length 1 where it is made, before "
                               "they touch.")
            : ResponseText::tr("How deep they overlap after a step is chance: it may move their "
                               "places apart, but must not come into the velocities.");
    LawDeviation found = responseDeviation(
        ResponseText::tr("What a hit does depends on where in a step they touch"),
        cameTogether(early, !own.rebounds.empty()) + QLatin1Char(' ')
            + ResponseText::tr("Where their rims touched after a quarter of a step of %1 s, they "
                               "left with %2; where after two thirds, with %3; %4 are right.")
                  .arg(briefTimestep(early.stage.preset.timestep), leftBeside(early, late),
                       leftBeside(late, early), leftBeside(right.inSteps[0], early))
            + QLatin1Char(' ') + hint,
        early, isOfOverlap || isOfNormalAhead ? Suspect::Formula : Suspect::Answer);
    found.topic = Topic::Depth;
    return found;
}

/// That an answer is another one with another timestep.
LawDeviation timestepDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    const PairHit &usual = own.inSteps[0];
    const PairHit &brief = own.inSteps[2];
    const bool isPush = length(usual.push1() + usual.push2()) < 1e-3 * length(usual.push1());
    LawDeviation found = responseDeviation(
        isPush ? ResponseText::tr("The push has a wrong size that depends on the timestep")
               : ResponseText::tr("What a hit does depends on the timestep"),
        cameTogether(usual, !own.rebounds.empty()) + QLatin1Char(' ')
            + ResponseText::tr("In the step of the hit their velocities became %2 with a timestep "
                               "of %1 s, and %4 with %3 s; %5 are right.")
                  .arg(briefTimestep(usual.stage.preset.timestep), leftBeside(usual, brief),
                       briefTimestep(brief.stage.preset.timestep), leftBeside(brief, usual),
                       leftBeside(right.inSteps[0], usual))
            + QLatin1Char(' ')
            + ResponseText::tr("A hit takes no time: look at where the timestep comes into what it "
                               "does."),
        usual, Suspect::Formula);
    found.topic = Topic::Timestep;
    return found;
}

} // namespace

std::vector<PairHit> PairRange::inSteps(Meeting meeting, double restitution) const
{
    meeting.restitution = restitution;
    meeting.velocities = m_ground.pair.bothMove ? PairVelocities{.along1 = 1.2, .along2 = -0.4}
                                                : PairVelocities{.along1 = 1.2};
    std::vector<PairHit> hits;
    for (const auto &[h, part] : {std::pair(m_h, touchesEarly), std::pair(m_h, touchesLate),
                                  std::pair(shortStep, touchesEarly)}) {
        const double way = meeting.closing() * h;
        hits.push_back(
            meet(meeting, meeting.sum() + (1.0 + part) * way, meeting.sum(), h, fewSteps));
    }
    return hits;
}

std::optional<LawDeviation> steppedDeviation(const MeasuredPair &own, const MeasuredPair &right,
                                             bool isElseRight)
{
    // Who is slowed on the way is so in the step of a hit, too, and who flies off far is at a wall.
    const auto isPlain = [](const PairHit &hit) {
        const PairVelocities in = hit.cameParts();
        const PairVelocities &thrown = hit.meeting.velocities;
        return hit.isInTime() && hit.after < 2.0 * hit.meeting.sum()
               && isAlike(in.along1, thrown.along1) && isAlike(in.along2, thrown.along2);
    };
    const auto isInTime = [&](const MeasuredPair &pair) {
        return pair.inSteps.size() == 3
               && std::all_of(pair.inSteps.begin(), pair.inSteps.end(), isPlain);
    };
    const auto isSteady = [](const MeasuredPair &pair, std::size_t other) {
        return isSteppedAlike(pair.inSteps[0], pair.inSteps[other],
                              other == 1 ? otherInStep : otherTimestep);
    };
    if (!isInTime(own) || !isInTime(right) || !isSteady(right, 1) || !isSteady(right, 2))
        return std::nullopt;
    // What points elsewhere goes by places, which another step changes, too, and who is answered in
    // one of them alone is told as that.
    const bool isAlong = std::all_of(own.inSteps.begin(), own.inSteps.end(),
                                     [](const PairHit &hit) { return hit.isAlongCentres(); });
    const auto isAnswered = [](const PairHit &hit) {
        return std::pair(hit.push1() != Vec2{}, hit.push2() != Vec2{});
    };
    if (!isAlong || isAnswered(own.inSteps[0]) != isAnswered(own.inSteps[1]))
        return std::nullopt;
    if (!isSteady(own, 1))
        return depthDeviation(own, right, isElseRight);
    return isSteady(own, 2) ? std::nullopt : std::optional(timestepDeviation(own, right));
}

} // namespace cradle
