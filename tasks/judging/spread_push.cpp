// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_range.h"
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include <cmath>

namespace cradle {

namespace {

/// Of the closing speed: less is no push of a hit, and what differs less is the same share of it.
constexpr double leastPush = 2e-3;
constexpr double sameShareOfClosing = 0.05;
constexpr double rightAtOnce = 0.02;
constexpr double mostTurned = 0.1; ///< of the first push out of the line of centres, as a sine

/// How fast two come nearer along \p n, m/s.
double closingAlong(Vec2 n, Vec2 v1, Vec2 v2)
{
    return dot(v1 - v2, n);
}

/// Whether the first step with a push leaves the circles as it should, or pushes them even more:
/// then nothing is left for later ones.
bool isDoneAtOnce(const SpreadPush &spread, const PairHit &right)
{
    const PairHit &first = spread.first;
    const auto isWhole = [](Vec2 push, Vec2 asked) {
        return dot(push, asked) > (1.0 - rightAtOnce) * dot(asked, asked);
    };
    return length(first.left1 - right.left1) + length(first.left2 - right.left2)
               < rightAtOnce * length(first.came1 - first.came2)
           || (isWhole(first.push1(), right.push1()) && isWhole(first.push2(), right.push2()));
}

/// Whether the first step pushes along the line in which both should be pushed: else it is its
/// direction that is wrong, and later steps answer again what that left.
bool isAlongTheLine(const PairHit &first, const PairHit &right)
{
    const Vec2 line = normalized(right.push2());
    const auto isAlong = [&](Vec2 push) {
        return std::abs(cross(push, line)) <= mostTurned * length(push);
    };
    return isAlong(first.push1()) && isAlong(first.push2());
}

} // namespace

/// Who pushes by a share of the speed with which they come nearer, now and in later steps, has one
/// law for all of them: there the share is what is wrong.
std::optional<SpreadPush> PairRange::spread(const PairHit &model) const
{
    constexpr int stepsAfterwards = 40;
    const Meeting &meeting = model.meeting;
    PairHit hit{.meeting = meeting, .slowness = model.slowness, .stage = model.stage};
    Probe probe(m_program, hit.stage);
    const Vec2 n = normalized(probe.circle(1).position - probe.circle(0).position);
    const double least = leastPush * meeting.closing();
    std::optional<SpreadPush> spread;
    double share = 0.0; // of the closing speed, that the first step turns
    bool isOfSpeed = true;
    bool isAfterwards = false; // pushed when they come nearer no more
    for (int k = 1; k <= (spread ? spread->first.step + stepsAfterwards : fewSteps); ++k) {
        const std::vector<Circle> before = probe.world().circles;
        if (isNearWall(before[0]) || isNearWall(before[1]) || !probe.step())
            break;
        const Vec2 free1 = m_paths.free(0, before, m_h).velocity;
        const Vec2 free2 = m_paths.free(1, before, m_h).velocity;
        const Vec2 now1 = probe.circle(0).velocity;
        const Vec2 now2 = probe.circle(1).velocity;
        if (length(now1 - free1) + length(now2 - free2) < least)
            continue;
        // What a wall turned in the same step is no push of theirs.
        if (isNearWall(before[0], length(now1) * m_h) || isNearWall(before[1], length(now2) * m_h))
            break;
        const double closing = closingAlong(n, free1, free2);
        const double turned = closing - closingAlong(n, now1, now2);
        if (!spread) {
            note(hit, before, probe, k);
            share = turned / closing;
            spread = SpreadPush{.first = hit, .last = hit};
            if (!hit.isMet() || turned < least)
                return std::nullopt;
            continue;
        }
        isOfSpeed = isOfSpeed
                    && std::abs(turned - share * closing) < sameShareOfClosing * meeting.closing();
        isAfterwards = isAfterwards || (closing < least && turned > least);
        spread->last.step = k;
        spread->last.left1 = now1;
        spread->last.left2 = now2;
    }
    return isAfterwards && !isOfSpeed ? spread : std::nullopt;
}

std::optional<LawDeviation> spreadDeviation(const MeasuredPair &own, const MeasuredPair &right)
{
    if (!own.isJudged || !own.spread || right.inSteps.empty() || !right.inSteps.front().isMet()
        || isDoneAtOnce(*own.spread, right.inSteps.front())
        || !isAlongTheLine(own.spread->first, right.inSteps.front()))
        return std::nullopt;
    const PairHit &first = own.spread->first;
    const PairHit &last = own.spread->last;
    QString body =
        cameTogether(first, !own.rebounds.empty()) + QLatin1Char(' ')
        + ResponseText::tr("The first step of the hit, of %1 s, left them with %2, step %3 of it "
                           "with %4; %5 are right, from the first on.")
              .arg(briefTimestep(first.stage.preset.timestep), leftBeside(first, last),
                   QString::number(last.step - first.step + 1), leftBeside(last, first),
                   leftBeside(right.inSteps.front(), first))
        + QLatin1Char(' ')
        + ResponseText::tr("A hit takes no time: all that it changes is due in the step in which "
                           "they touch.");
    // Where early and late hits are read, the first of them is this one.
    if (own.inSteps.size() > 1
        && std::abs(length(own.inSteps[0].push2()) - length(own.inSteps[1].push2()))
               > rightAtOnce * first.meeting.closing())
        body += QLatin1Char(' ')
                + ResponseText::tr("How deep they overlap after a step is chance: it may move "
                                   "their places apart, but must not come into the velocities.");
    LawDeviation found = responseDeviation(
        ResponseText::tr("The push of a hit is spread over several steps"), body, first);
    found.topic = Topic::Depth;
    return found;
}

} // namespace cradle
