// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/meeting_division.h"

#include "tasks/judging/thrown_meeting.h"

#include <algorithm>

namespace cradle {

namespace {

/// Of 36, two are the fastest or the last by chance in one of forty ways to look at them; three are
/// not.
constexpr std::ptrdiff_t fewestMeetings = 3;

/// Those of \p hits that can be judged.
template <class IsRight>
std::vector<JudgedMeeting> judged(const std::vector<PairHit> &hits, IsRight isRight)
{
    std::vector<JudgedMeeting> all;
    for (const PairHit &hit : hits) {
        if (!hit.stopped)
            all.push_back({&hit, isRight(hit)});
    }
    return all;
}

} // namespace

std::optional<MeetingDivision> divisionBy(const std::vector<JudgedMeeting> &meetings)
{
    std::vector<ThrownMeeting> all;
    all.reserve(meetings.size());
    for (const JudgedMeeting &one : meetings)
        all.emplace_back(*one.hit, one.isRight);
    const auto right =
        std::count_if(all.begin(), all.end(), [](const ThrownMeeting &one) { return one.isRight; });
    if (right < fewestMeetings || std::ssize(all) - right < fewestMeetings)
        return std::nullopt;
    const std::vector<MeetingDivision> found = divisionsBySign(all);
    const auto limit = divisionByLimit(all);
    if (found.empty() || limit)
        return found.empty() ? limit : std::nullopt;
    using Kind = MeetingDivision::Kind;
    const MeetingDivision &first = found.front();
    const bool isKnown = std::all_of(found.begin(), found.end(), [&](const MeetingDivision &other) {
        // Where densities are alike, the larger one is the heavier one.
        return other.phrase == first.phrase
               || (other.kind == Kind::Size && first.kind == Kind::Size);
    });
    return isKnown ? std::optional(first) : std::nullopt;
}

std::optional<MeetingDivision> divisionOf(const std::vector<PairHit> &hits, bool isAlong)
{
    if (auto found = divisionBy(judged(hits, [](const PairHit &hit) { return hit.isInTime(); })))
        return found;
    if (!isAlong)
        return std::nullopt;
    auto found = divisionBy(
        judged(hits, [](const PairHit &hit) { return hit.isInTime() && hit.isAlongCentres(); }));
    if (found)
        found->isOfDirection = true;
    return found;
}

} // namespace cradle
