// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/thrown_meeting.h"

#include "tasks/judging/deviation.h"
#include "tasks/judging/tried_words.h"

#include <algorithm>
#include <limits>

namespace cradle {

namespace {

/// A quantity that may have to be small, or great; where the limit lies stands in the words.
struct Size {
    MeetingDivision::Kind kind;
    double (*of)(const ThrownMeeting &);
    QString below;
    QString above;
};

std::vector<Size> sizeLimits()
{
    using Kind = MeetingDivision::Kind;
    const auto slower = [](int circle) {
        return DivisionText::tr(
                   "all with circle %1 at up to %2 m/s, none with it at %3 m/s or more")
            .arg(QString::number(circle), QStringLiteral("%1"), QStringLiteral("%2"));
    };
    const auto faster = [](int circle) {
        return DivisionText::tr(
                   "all with circle %1 at %2 m/s or more, none with it at up to %3 m/s")
            .arg(QString::number(circle), QStringLiteral("%1"), QStringLiteral("%2"));
    };
    return {{Kind::Speed, [](const ThrownMeeting &t) { return t.slowness * length(t.v1); },
             slower(1), faster(1)},
            {Kind::Speed, [](const ThrownMeeting &t) { return t.slowness * length(t.v2); },
             slower(2), faster(2)},
            {Kind::Place, [](const ThrownMeeting &t) { return length(t.meeting.middle); },
             DivisionText::tr("all up to %1 m from (0, 0), none from %2 m on"),
             DivisionText::tr("all from %1 m from (0, 0) on, none up to %2 m")}};
}

std::optional<MeetingDivision> byLimit(const Size &size, const std::vector<ThrownMeeting> &all)
{
    const double infinity = std::numeric_limits<double>::infinity();
    double least[2] = {infinity, infinity}; // of those that come out wrong, and right
    double most[2] = {-infinity, -infinity};
    std::ptrdiff_t none = 0;
    for (const ThrownMeeting &one : all) {
        const double value = size.of(one);
        none += value == 0.0 ? 1 : 0;
        least[one.isRight] = std::min(least[one.isRight], value);
        most[one.isRight] = std::max(most[one.isRight], value);
    }
    // Where most of those below are at rest, it may be rest that counts.
    const double limit = std::min(most[true], most[false]);
    const auto below = std::count_if(
        all.begin(), all.end(), [&](const ThrownMeeting &one) { return size.of(one) <= limit; });
    if (2 * none > below)
        return std::nullopt;
    if (most[true] < least[false])
        return MeetingDivision{size.kind, size.below.arg(brief(most[true]), brief(least[false]))};
    if (most[false] < least[true])
        return MeetingDivision{size.kind, size.above.arg(brief(least[true]), brief(most[false]))};
    return std::nullopt;
}

} // namespace

/// It may be the place of either circle.
std::optional<MeetingDivision> divisionByLimit(const std::vector<ThrownMeeting> &all)
{
    using Limit = Condition::Kind;
    std::optional<Condition> widest;
    double point = 0.0; // whose place it is, if it is known
    for (const double share : {0.0, -0.5, 0.5}) {
        std::vector<Occasion> occasions;
        occasions.reserve(all.size());
        for (const ThrownMeeting &one : all)
            occasions.push_back(
                {.place = one.meeting.middle + share * one.meeting.sum() * one.normal,
                 .speed = one.slowness * one.meeting.closing(),
                 .isRight = one.isRight});
        const auto limit = conditionOf(occasions);
        if (!limit || limit->kind == Limit::Sometimes || (widest && widest->kind != limit->kind))
            continue;
        // Nobody knows of which point the place counts: the limit is told for all of them.
        if (!widest) {
            widest = limit;
            point = share;
        } else {
            point = 0.0;
            const bool isFalling = limit->inside < limit->outside;
            widest->inside = isFalling ? std::min(widest->inside, limit->inside)
                                       : std::max(widest->inside, limit->inside);
            widest->outside = isFalling ? std::max(widest->outside, limit->outside)
                                        : std::min(widest->outside, limit->outside);
        }
    }
    if (widest) {
        const QString phrase = triedPhrase(*widest);
        if (!widest->isOfPlace())
            return MeetingDivision{MeetingDivision::Kind::Speed, phrase};
        return MeetingDivision{
            MeetingDivision::Kind::Place,
            point == 0.0
                ? phrase
                : DivisionText::tr("%1, where circle %2 was").arg(phrase).arg(point < 0.0 ? 1 : 2)};
    }
    std::optional<MeetingDivision> found;
    for (const Size &size : sizeLimits()) {
        const auto other = byLimit(size, all);
        if (found && other)
            return std::nullopt;
        if (other)
            found = other;
    }
    return found;
}

} // namespace cradle
