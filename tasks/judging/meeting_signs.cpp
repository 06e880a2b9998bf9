// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/thrown_meeting.h"

#include <cmath>

namespace cradle {

namespace {

/// A quantity whose sign may be what counts.
struct Sign {
    double (*of)(const ThrownMeeting &);
    QString positive;
    QString negative;
    QString zero{}; ///< empty where that does not come
};

std::vector<Sign> sides()
{
    return {{[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.normal, &Vec2::x); },
             DivisionText::tr("circle 2 is to the right of circle 1"),
             DivisionText::tr("circle 2 is to the left of circle 1")},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.normal, &Vec2::y); },
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
    return {{[](const ThrownMeeting &t) { return t.meeting.velocities.along1; }, comes(1, 2),
             leaves(1, 2), rests(1)},
            {[](const ThrownMeeting &t) { return -t.meeting.velocities.along2; }, comes(2, 1),
             leaves(2, 1), rests(2)},
            {[](const ThrownMeeting &t) {
                 return t.meeting.velocities.along1 * t.meeting.velocities.along2;
             },
             DivisionText::tr("both move the same way along the line of centres"),
             DivisionText::tr("both come towards each other"),
             DivisionText::tr("one of them is at rest")},
            {[](const ThrownMeeting &t) {
                 return std::abs(t.meeting.velocities.along1)
                        - std::abs(t.meeting.velocities.along2);
             },
             fasterAlong(1), fasterAlong(2),
             DivisionText::tr("both are equally fast along the line of centres")},
            {[](const ThrownMeeting &t) { return length(t.v1) - length(t.v2); }, faster(1),
             faster(2), DivisionText::tr("both are equally fast")}};
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
    return {{[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.v1, &Vec2::x); }, right(1),
             left(1), rests(1)},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.v1, &Vec2::y); }, up(1),
             down(1), rests(1)},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.v2, &Vec2::x); }, right(2),
             left(2), rests(2)},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.v2, &Vec2::y); }, up(2),
             down(2), rests(2)},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.relative(), &Vec2::x); },
             DivisionText::tr("circle 1, seen from circle 2, moves to the right"),
             DivisionText::tr("circle 1, seen from circle 2, moves to the left")},
            {[](const ThrownMeeting &t) { return ThrownMeeting::partOf(t.relative(), &Vec2::y); },
             DivisionText::tr("circle 1, seen from circle 2, moves upward"),
             DivisionText::tr("circle 1, seen from circle 2, moves downward")},
            {[](const ThrownMeeting &t) { return t.outward(); },
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
    return {{[](const ThrownMeeting &t) { return t.meeting.radius1 - t.meeting.radius2; },
             larger(1), larger(2), DivisionText::tr("both are equally large")},
            {[](const ThrownMeeting &t) {
                 return ThrownMeeting::massOf(t.meeting.radius1, t.meeting.density1)
                        - ThrownMeeting::massOf(t.meeting.radius2, t.meeting.density2);
             },
             heavier(1), heavier(2), DivisionText::tr("both are equally heavy")},
            {[](const ThrownMeeting &t) { return t.meeting.density1 - t.meeting.density2; },
             denser(1), denser(2), DivisionText::tr("both are equally dense")},
            {[](const ThrownMeeting &t) { return 1.0 - t.meeting.restitution; },
             DivisionText::tr("e is less than 1"), QString(), DivisionText::tr("e is 1")}};
}

/// The division of \p all by the sign of a quantity, if that tells those that come out right from
/// the others.
std::optional<MeetingDivision> bySign(MeetingDivision::Kind kind, const Sign &sign,
                                      const std::vector<ThrownMeeting> &all)
{
    enum { Negative, Zero, Positive };
    bool right[3] = {false, false, false};
    bool wrong[3] = {false, false, false};
    for (const ThrownMeeting &one : all) {
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

} // namespace

std::vector<MeetingDivision> divisionsBySign(const std::vector<ThrownMeeting> &meetings)
{
    using Kind = MeetingDivision::Kind;
    std::vector<MeetingDivision> found;
    for (const auto &[kind, signs] : {std::pair(Kind::Side, sides()),
                                      {Kind::Coming, comings()},
                                      {Kind::Way, ways()},
                                      {Kind::Size, sizes()}}) {
        for (const Sign &sign : signs) {
            if (const auto division = bySign(kind, sign, meetings))
                found.push_back(*division);
        }
    }
    return found;
}

} // namespace cradle
