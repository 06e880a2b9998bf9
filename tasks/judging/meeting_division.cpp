// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/meeting_division.h"

#include "tasks/judging/tried_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cradle {

namespace {

struct DivisionText {
    Q_DECLARE_TR_FUNCTIONS(Findings)
};

/// A meeting as a program sees it.
struct Thrown {
    Thrown(const PairHit &hit, bool isRight)
        : meeting(hit.meeting)
        , normal(directionOf(hit.meeting.degrees))
        , v1(worldOf(hit.meeting.velocities.along1, hit.meeting.velocities.across1))
        , v2(worldOf(hit.meeting.velocities.along2, hit.meeting.velocities.across2))
        , slowness(hit.slowness)
        , isMet(isRight)
    {
    }

    [[nodiscard]] Vec2 relative() const { return v1 - v2; }
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
    bool isMet;

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
    return {{[](const Thrown &t) { return t.normal.x; },
             DivisionText::tr("circle 2 is to the right of circle 1"),
             DivisionText::tr("circle 2 is to the left of circle 1")},
            {[](const Thrown &t) { return t.normal.y; },
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
    return {{[](const Thrown &t) { return t.v1.x; }, right(1), left(1), rests(1)},
            {[](const Thrown &t) { return t.v1.y; }, up(1), down(1), rests(1)},
            {[](const Thrown &t) { return t.v2.x; }, right(2), left(2), rests(2)},
            {[](const Thrown &t) { return t.v2.y; }, up(2), down(2), rests(2)},
            {[](const Thrown &t) { return t.relative().x; },
             DivisionText::tr("circle 1, seen from circle 2, moves to the right"),
             DivisionText::tr("circle 1, seen from circle 2, moves to the left")},
            {[](const Thrown &t) { return t.relative().y; },
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
             denser(2), DivisionText::tr("both are equally dense")}};
}

/// Fewer may be chance.
constexpr std::ptrdiff_t fewest = 2;

/// The words for those of \p all that are answered, if the sign of a quantity tells them from the
/// others; empty if it does not.
QString phraseBy(const Sign &sign, const std::vector<Thrown> &all)
{
    enum { Negative, Zero, Positive };
    bool met[3] = {false, false, false};
    bool missed[3] = {false, false, false};
    for (const Thrown &one : all) {
        const double value = sign.of(one);
        if (std::isnan(value))
            continue;
        const int which = value > 0.0 ? Positive : value < 0.0 ? Negative : Zero;
        (one.isMet ? met : missed)[which] = true;
    }
    QStringList names;
    for (const auto &[which, name] : {std::pair<int, const QString &>(Positive, sign.positive),
                                      std::pair<int, const QString &>(Negative, sign.negative),
                                      std::pair<int, const QString &>(Zero, sign.zero)}) {
        if (met[which] && missed[which])
            return {};
        if (met[which])
            names.append(name);
    }
    return names.size() == 2 ? DivisionText::tr("%1 or %2").arg(names[0], names[1])
                             : names.value(0);
}

/// A speed or a place from which on they are answered. It may be the place of either circle.
std::optional<MeetingDivision> limitOf(const std::vector<Thrown> &all)
{
    using Limit = Condition::Kind;
    for (const double share : {0.0, -0.5, 0.5}) {
        std::vector<Occasion> occasions;
        for (const Thrown &one : all)
            occasions.push_back(
                {.place = one.meeting.middle + share * one.meeting.sum() * one.normal,
                 .speed = one.slowness * one.meeting.closing(),
                 .isRight = one.isMet});
        const auto limit = conditionOf(occasions);
        if (!limit || limit->kind == Limit::Sometimes)
            continue;
        const QString phrase = triedPhrase(*limit);
        if (!limit->isOfPlace())
            return MeetingDivision{MeetingDivision::Kind::Speed, phrase};
        return MeetingDivision{
            MeetingDivision::Kind::Place,
            share == 0.0
                ? phrase
                : DivisionText::tr("%1, where circle %2 was").arg(phrase).arg(share < 0.0 ? 1 : 2)};
    }
    return std::nullopt;
}

/// What tells those that \p isRight says so of from the others.
template <class IsRight>
std::optional<MeetingDivision> divided(const std::vector<PairHit> &hits, IsRight isRight)
{
    std::vector<Thrown> all;
    for (const PairHit &hit : hits) {
        if (!hit.stopped && !hit.isHeldAlone())
            all.emplace_back(hit, isRight(hit));
    }
    const auto met =
        std::count_if(all.begin(), all.end(), [](const Thrown &one) { return one.isMet; });
    if (met < fewest || std::ssize(all) - met < fewest)
        return std::nullopt;
    using Kind = MeetingDivision::Kind;
    for (const auto &[kind, signs] : {std::pair(Kind::Side, sides()),
                                      {Kind::Coming, comings()},
                                      {Kind::Way, ways()},
                                      {Kind::Size, sizes()}}) {
        for (const Sign &sign : signs) {
            const QString phrase = phraseBy(sign, all);
            if (!phrase.isEmpty())
                return MeetingDivision{kind,
                                       DivisionText::tr("those where %1, no others").arg(phrase)};
        }
    }
    return limitOf(all);
}

} // namespace

std::optional<MeetingDivision> divisionOf(const std::vector<PairHit> &hits, bool isAlong)
{
    if (auto found = divided(hits, [](const PairHit &hit) { return hit.isInTime(); }))
        return found;
    if (!isAlong)
        return std::nullopt;
    auto found =
        divided(hits, [](const PairHit &hit) { return hit.isInTime() && hit.isAlongCentres(); });
    if (found)
        found->isOfDirection = true;
    return found;
}

} // namespace cradle
