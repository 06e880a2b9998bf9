// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/meeting_division.h"

#include "tasks/judging/deviation.h"
#include "tasks/judging/tried_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

/// Fewer may be chance.
constexpr std::ptrdiff_t fewestMeetings = 2;

struct DivisionText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A meeting as a program sees it.
struct Thrown {
    Thrown(const PairHit &hit, bool right)
        : meeting(hit.meeting)
        , normal(directionOf(hit.meeting.degrees))
        , v1(worldOf(hit.meeting.velocities.along1, hit.meeting.velocities.across1))
        , v2(worldOf(hit.meeting.velocities.along2, hit.meeting.velocities.across2))
        , slowness(hit.slowness)
        , isRight(right)
    {
    }

    [[nodiscard]] Vec2 relative() const { return v1 - v2; }
    /// A part of \p v, in x or y; not a number where rounding alone would tell its sign.
    [[nodiscard]] static double partOf(Vec2 v, double Vec2::*part)
    {
        return v != Vec2{} && std::abs(v.*part) < 1e-9 * length(v)
                   ? std::numeric_limits<double>::quiet_NaN()
                   : v.*part;
    }
    /// How fast circle 1, seen from circle 2, moves away from the origin; not a number where that
    /// is not so from both places alike.
    [[nodiscard]] double outward() const
    {
        const Vec2 half = 0.5 * meeting.sum() * normal;
        const double from1 = dot(relative(), meeting.middle - half);
        const double from2 = dot(relative(), meeting.middle + half);
        return from1 * from2 > 0.0 ? from1 : std::numeric_limits<double>::quiet_NaN();
    }
    [[nodiscard]] static double massOf(double radius, double density)
    {
        return density * radius * radius * radius;
    }

    Meeting meeting;
    Vec2 normal;
    Vec2 v1;
    Vec2 v2;
    double slowness;
    bool isRight;

private:
    static Vec2 directionOf(double degrees)
    {
        const double angle = degrees * std::numbers::pi / 180.0;
        return {std::cos(angle), std::sin(angle)};
    }
    [[nodiscard]] Vec2 worldOf(double along, double across) const
    {
        return along * normal + across * perpendicular(normal);
    }
};

/// A quantity whose sign may be what counts.
struct Sign {
    double (*of)(const Thrown &);
    QString positive;
    QString negative;
    QString zero{}; ///< empty where that does not come
};

std::vector<Sign> sides()
{
    return {{[](const Thrown &t) { return Thrown::partOf(t.normal, &Vec2::x); },
             DivisionText::tr("circle 2 is to the right of circle 1"),
             DivisionText::tr("circle 2 is to the left of circle 1")},
            {[](const Thrown &t) { return Thrown::partOf(t.normal, &Vec2::y); },
             DivisionText::tr("circle 2 is above circle 1"),
             DivisionText::tr("circle 2 is below circle 1")}};
}

QString rests(int circle)
{
    return DivisionText::tr("circle %1 is at rest").arg(circle);
}

std::vector<Sign> comings()
{
    const auto comes = [](int circle, int other) {
        return DivisionText::tr("circle %1 comes towards circle %2").arg(circle).arg(other);
    };
    const auto leaves = [](int circle, int other) {
        return DivisionText::tr("circle %1 moves away from circle %2").arg(circle).arg(other);
    };
    const auto fasterAlong = [](int circle) {
        return DivisionText::tr("circle %1 is the faster one along the line of centres")
            .arg(circle);
    };
    const auto faster = [](int circle) {
        return DivisionText::tr("circle %1 is the faster one").arg(circle);
    };
    return {
        {[](const Thrown &t) { return t.meeting.velocities.along1; }, comes(1, 2), leaves(1, 2),
         rests(1)},
        {[](const Thrown &t) { return -t.meeting.velocities.along2; }, comes(2, 1), leaves(2, 1),
         rests(2)},
        {[](const Thrown &t) { return t.meeting.velocities.along1 * t.meeting.velocities.along2; },
         DivisionText::tr("both move the same way along the line of centres"),
         DivisionText::tr("both come towards each other"),
         DivisionText::tr("one of them is at rest")},
        {[](const Thrown &t) {
             return std::abs(t.meeting.velocities.along1) - std::abs(t.meeting.velocities.along2);
         },
         fasterAlong(1), fasterAlong(2),
         DivisionText::tr("both are equally fast along the line of centres")},
        {[](const Thrown &t) { return length(t.v1) - length(t.v2); }, faster(1), faster(2),
         DivisionText::tr("both are equally fast")}};
}

std::vector<Sign> ways()
{
    const auto right = [](int circle) {
        return DivisionText::tr("circle %1 moves to the right").arg(circle);
    };
    const auto left = [](int circle) {
        return DivisionText::tr("circle %1 moves to the left").arg(circle);
    };
    const auto up = [](int circle) {
        return DivisionText::tr("circle %1 moves upward").arg(circle);
    };
    const auto down = [](int circle) {
        return DivisionText::tr("circle %1 moves downward").arg(circle);
    };
    return {
        {[](const Thrown &t) { return Thrown::partOf(t.v1, &Vec2::x); }, right(1), left(1),
         rests(1)},
        {[](const Thrown &t) { return Thrown::partOf(t.v1, &Vec2::y); }, up(1), down(1), rests(1)},
        {[](const Thrown &t) { return Thrown::partOf(t.v2, &Vec2::x); }, right(2), left(2),
         rests(2)},
        {[](const Thrown &t) { return Thrown::partOf(t.v2, &Vec2::y); }, up(2), down(2), rests(2)},
        {[](const Thrown &t) { return Thrown::partOf(t.relative(), &Vec2::x); },
         DivisionText::tr("circle 1, seen from circle 2, moves to the right"),
         DivisionText::tr("circle 1, seen from circle 2, moves to the left")},
        {[](const Thrown &t) { return Thrown::partOf(t.relative(), &Vec2::y); },
         DivisionText::tr("circle 1, seen from circle 2, moves upward"),
         DivisionText::tr("circle 1, seen from circle 2, moves downward")},
        {[](const Thrown &t) { return t.outward(); },
         DivisionText::tr("circle 1, seen from circle 2, moves away from (0, 0)"),
         DivisionText::tr("circle 1, seen from circle 2, moves towards (0, 0)")}};
}

std::vector<Sign> sizes()
{
    const auto larger = [](int circle) {
        return DivisionText::tr("circle %1 is the larger one").arg(circle);
    };
    const auto heavier = [](int circle) {
        return DivisionText::tr("circle %1 is the heavier one").arg(circle);
    };
    const auto denser = [](int circle) {
        return DivisionText::tr("circle %1 is the denser one").arg(circle);
    };
    return {{[](const Thrown &t) { return t.meeting.radius1 - t.meeting.radius2; }, larger(1),
             larger(2), DivisionText::tr("both are equally large")},
            {[](const Thrown &t) {
                 return Thrown::massOf(t.meeting.radius1, t.meeting.density1)
                        - Thrown::massOf(t.meeting.radius2, t.meeting.density2);
             },
             heavier(1), heavier(2), DivisionText::tr("both are equally heavy")},
            {[](const Thrown &t) { return t.meeting.density1 - t.meeting.density2; }, denser(1),
             denser(2), DivisionText::tr("both are equally dense")},
            {[](const Thrown &t) { return 1.0 - t.meeting.restitution; },
             DivisionText::tr("e is less than 1"), QString(), DivisionText::tr("e is 1")}};
}

/// The division of \p all by the sign of a quantity, if that tells those that come out right from
/// the others.
std::optional<MeetingDivision> bySign(MeetingDivision::Kind kind, const Sign &sign,
                                      const std::vector<Thrown> &all)
{
    enum { Negative, Zero, Positive };
    bool right[3] = {false, false, false};
    bool wrong[3] = {false, false, false};
    for (const Thrown &one : all) {
        const double value = sign.of(one);
        if (std::isnan(value))
            continue;
        const int which = value > 0.0 ? Positive : value < 0.0 ? Negative : Zero;
        (one.isRight ? right : wrong)[which] = true;
    }
    QStringList ofRight;
    QStringList ofWrong;
    for (const auto &[which, name] : {std::pair<int, const QString &>(Positive, sign.positive),
                                      std::pair<int, const QString &>(Negative, sign.negative),
                                      std::pair<int, const QString &>(Zero, sign.zero)}) {
        if (right[which] && wrong[which])
            return std::nullopt;
        if (right[which])
            ofRight.append(name);
        if (wrong[which])
            ofWrong.append(name);
    }
    if (ofRight.isEmpty() || ofWrong.isEmpty())
        return std::nullopt;
    return MeetingDivision{
        kind, ofRight.size() > 1
                  ? DivisionText::tr("all but those where %1").arg(ofWrong.front())
                  : DivisionText::tr("those where %1, no others").arg(ofRight.front())};
}

/// A quantity that may have to be small, or great; where the limit lies stands in the words.
struct Size {
    MeetingDivision::Kind kind;
    double (*of)(const Thrown &);
    QString below;
    QString above;
};

std::vector<Size> limits()
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
    return {{Kind::Speed, [](const Thrown &t) { return t.slowness * length(t.v1); }, slower(1),
             faster(1)},
            {Kind::Speed, [](const Thrown &t) { return t.slowness * length(t.v2); }, slower(2),
             faster(2)},
            {Kind::Place, [](const Thrown &t) { return length(t.meeting.middle); },
             DivisionText::tr("all up to %1 m from (0, 0), none from %2 m on"),
             DivisionText::tr("all from %1 m from (0, 0) on, none up to %2 m")}};
}

std::optional<MeetingDivision> byLimit(const Size &size, const std::vector<Thrown> &all)
{
    const double infinity = std::numeric_limits<double>::infinity();
    double least[2] = {infinity, infinity}; // of those that come out wrong, and right
    double most[2] = {-infinity, -infinity};
    std::ptrdiff_t none = 0;
    for (const Thrown &one : all) {
        const double value = size.of(one);
        none += value == 0.0 ? 1 : 0;
        least[one.isRight] = std::min(least[one.isRight], value);
        most[one.isRight] = std::max(most[one.isRight], value);
    }
    // Where most of those below are at rest, it may be rest that counts.
    const double limit = std::min(most[true], most[false]);
    const auto below = std::count_if(all.begin(), all.end(),
                                     [&](const Thrown &one) { return size.of(one) <= limit; });
    if (2 * none > below)
        return std::nullopt;
    if (most[true] < least[false])
        return MeetingDivision{size.kind, size.below.arg(brief(most[true]), brief(least[false]))};
    if (most[false] < least[true])
        return MeetingDivision{size.kind, size.above.arg(brief(least[true]), brief(most[false]))};
    return std::nullopt;
}

/// A speed or a place from which on they are answered. It may be the place of either circle.
std::optional<MeetingDivision> limitOf(const std::vector<Thrown> &all)
{
    using Limit = Condition::Kind;
    std::optional<Condition> widest;
    double point = 0.0; // whose place it is, if it is known
    for (const double share : {0.0, -0.5, 0.5}) {
        std::vector<Occasion> occasions;
        for (const Thrown &one : all)
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
    for (const Size &size : limits()) {
        const auto other = byLimit(size, all);
        if (found && other)
            return std::nullopt;
        if (other)
            found = other;
    }
    return found;
}

/// Those of \p hits that can be judged.
template <class IsRight>
std::vector<JudgedMeeting> judged(const std::vector<PairHit> &hits, IsRight isRight)
{
    std::vector<JudgedMeeting> all;
    for (const PairHit &hit : hits) {
        if (!hit.stopped && !hit.isHeldAlone())
            all.push_back({&hit, isRight(hit)});
    }
    return all;
}

} // namespace

std::optional<MeetingDivision> divisionBy(const std::vector<JudgedMeeting> &meetings)
{
    std::vector<Thrown> all;
    for (const JudgedMeeting &one : meetings)
        all.emplace_back(*one.hit, one.isRight);
    const auto right =
        std::count_if(all.begin(), all.end(), [](const Thrown &one) { return one.isRight; });
    if (right < fewestMeetings || std::ssize(all) - right < fewestMeetings)
        return std::nullopt;
    using Kind = MeetingDivision::Kind;
    std::optional<MeetingDivision> found;
    for (const auto &[kind, signs] : {std::pair(Kind::Side, sides()),
                                      {Kind::Coming, comings()},
                                      {Kind::Way, ways()},
                                      {Kind::Size, sizes()}}) {
        for (const Sign &sign : signs) {
            const auto other = bySign(kind, sign, all);
            // Where densities are alike, the larger one is the heavier one.
            if (found && other && other->phrase != found->phrase
                && !(kind == Kind::Size && found->kind == Kind::Size))
                return std::nullopt;
            if (!found)
                found = other;
        }
    }
    const auto limit = limitOf(all);
    return found && limit ? std::nullopt : found ? found : limit;
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
