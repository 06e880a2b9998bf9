// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/approved_text.h"
#include "tests/draws.h"
#include "tests/made_meetings.h"
#include "tests/text_print.h"

#include "tasks/judging/tried_words.h"

#include <QTest>

#include <map>

using namespace cradle;
using namespace cradle::approved;

/// What is said to divide those that come out right from the others, where one thing decides, or
/// two: hashes of what is known and said, and how often of which kind, for each thing that decides,
/// are in tests/approved/occasions.txt.
class TestApprovedOccasions : public QObject
{
    Q_OBJECT
private slots:
    void whatDividesIsAsApproved();
};

namespace {

/// What may decide whether an occasion comes out right.
struct Feature {
    const char *name;
    double (*of)(const Occasion &);
};
constexpr Feature features[] = {
    {"time", [](const Occasion &o) { return o.time; }},
    {"number", [](const Occasion &o) { return double(o.number); }},
    {"number of its circle", [](const Occasion &o) { return double(o.ownNumber); }},
    {"number at its wall", [](const Occasion &o) { return double(o.wallNumber); }},
    {"number of its kind", [](const Occasion &o) { return double(o.likeNumber); }},
    {"odd number", [](const Occasion &o) { return double(o.number % 2); }},
    {"odd number of its circle", [](const Occasion &o) { return double(o.ownNumber % 2); }},
    {"odd number of its kind", [](const Occasion &o) { return double(o.likeNumber % 2); }},
    {"pause", [](const Occasion &o) { return o.pause; }},
    {"x", [](const Occasion &o) { return o.place.x; }},
    {"y", [](const Occasion &o) { return o.place.y; }},
    {"speed", [](const Occasion &o) { return o.speed; }},
    {"speed into", [](const Occasion &o) { return o.into; }},
    {"speed along", [](const Occasion &o) { return o.along; }},
    {"way in x", [](const Occasion &o) { return o.velocity.x; }},
    {"way in y", [](const Occasion &o) { return o.velocity.y; }},
    {"way of another in x", [](const Occasion &o) { return o.otherVelocity.x; }},
    {"way of another in y", [](const Occasion &o) { return o.otherVelocity.y; }},
    {"setting", [](const Occasion &o) { return double(o.setting); }},
    {"met", [](const Occasion &o) { return double(o.hasMet); }},
    {"hit", [](const Occasion &o) { return double(o.hasHit); }},
    {"run", [](const Occasion &o) { return double(o.run); }},
    {"nothing", [](const Occasion &) { return 0.0; }},
};

struct MeetingFeature {
    const char *name;
    double (*of)(const PairHit &);
};
constexpr MeetingFeature meetingFeatures[] = {
    {"line in x", [](const PairHit &h) { return made::lineOf(h).x; }},
    {"line in y", [](const PairHit &h) { return made::lineOf(h).y; }},
    {"speed 1", [](const PairHit &h) { return length(made::velocityOf(h, 1)); }},
    {"speed 2", [](const PairHit &h) { return length(made::velocityOf(h, 2)); }},
    {"way 1 in x", [](const PairHit &h) { return made::velocityOf(h, 1).x; }},
    {"way 2 in y", [](const PairHit &h) { return made::velocityOf(h, 2).y; }},
    {"closing", [](const PairHit &h) { return h.meeting.closing(); }},
    {"distance", [](const PairHit &h) { return length(h.meeting.middle); }},
    {"x", [](const PairHit &h) { return h.meeting.middle.x; }},
    {"y of 1",
     [](const PairHit &h) {
         return h.meeting.middle.y - 0.5 * h.meeting.sum() * made::lineOf(h).y;
     }},
    {"x of 2",
     [](const PairHit &h) {
         return h.meeting.middle.x + 0.5 * h.meeting.sum() * made::lineOf(h).x;
     }},
    {"radii", [](const PairHit &h) { return h.meeting.radius1 - h.meeting.radius2; }},
    {"densities", [](const PairHit &h) { return h.meeting.density1 - h.meeting.density2; }},
    {"along 1", [](const PairHit &h) { return h.meeting.velocities.along1; }},
    {"along 2", [](const PairHit &h) { return h.meeting.velocities.along2; }},
    {"slowness", [](const PairHit &h) { return h.slowness; }},
};

/// From \p low to \p high, of steps of a thousandth; now and then 0.
double among(Draws &draws, double low, double high)
{
    return draws.oneOf(9) ? 0.0 : low + 0.001 * (high - low) * double(draws.below(1000));
}

std::vector<Occasion> occasions(Draws &draws)
{
    std::vector<Occasion> all(3 + draws.below(30));
    const std::size_t runs = 1 + draws.below(4);
    int number = 0;
    for (Occasion &o : all) {
        o.run = int(draws.below(runs));
        o.number = ++number;
        o.ownNumber = 1 + number / 2;
        o.wallNumber = 1 + int(draws.below(4));
        o.likeNumber = 1 + number / 3;
        o.time = 0.3 * number + among(draws, 0.0, 0.2);
        if (!draws.oneOf(3))
            o.pause = among(draws, 0.01, 2.0);
        o.place = {among(draws, -4.0, 4.0), among(draws, -4.0, 4.0)};
        o.velocity = {among(draws, -3.0, 3.0), among(draws, -3.0, 3.0)};
        o.otherVelocity = {among(draws, -3.0, 3.0), among(draws, -3.0, 3.0)};
        o.speed = length(o.velocity);
        o.into = std::abs(o.velocity.x);
        o.along = std::abs(o.velocity.y);
        o.setting = int(draws.below(3));
        o.hasMet = number > 4;
        o.hasHit = number > 6 || draws.oneOf(5);
    }
    return all;
}

/// What decides: a limit that one of \p all has, or whether there is anything of it.
template <class All, class Of>
auto rule(const All &all, Of of, Draws &draws)
{
    const double limit = draws.oneOf(2) ? 0.0 : of(all[draws.below(all.size())]);
    const bool isLess = draws.oneOf(2);
    const bool isEqual = draws.oneOf(5);
    return [=](const auto &one) {
        const double value = of(one);
        return isEqual ? (value == limit) != isLess : isLess ? value < limit : value >= limit;
    };
}

QString conditionsTold(const Feature &feature, Draws &draws)
{
    TextPrint print;
    std::map<int, int> kinds;
    for (int i = 0; i < 400; ++i) {
        std::vector<Occasion> all = occasions(draws);
        const auto isRight = rule(all, feature.of, draws);
        for (Occasion &one : all)
            one.isRight = isRight(one);
        if (draws.oneOf(6))
            all[draws.below(all.size())].isRight ^= true;
        for (const Condition &each : conditionsOf(all)) {
            ++kinds[int(each.kind)];
            print << int(each.kind) << each.inside << each.outside << int(each.counted)
                  << triedPhrase(each);
        }
        if (const auto one = conditionOf(all))
            print << int(one->kind) << triesTold(all) << answersTold(all);
        print << rightOnes(all);
    }
    QString text = QLatin1String(feature.name) + QLatin1String(": ") + print.text();
    for (const auto &[kind, count] : kinds)
        text += QStringLiteral(" %1×%2").arg(count).arg(kind);
    return text + QLatin1Char('\n');
}

QString divisionsTold(const MeetingFeature &feature, Draws &draws)
{
    const std::vector<PairHit> meetings = made::manyMeetings();
    TextPrint print;
    std::map<int, int> kinds;
    for (int i = 0; i < 250; ++i) {
        std::vector<PairHit> some;
        for (std::size_t k = 0; k < 36; ++k) {
            some.push_back(meetings[draws.below(meetings.size())]);
            some.back().slowness = draws.oneOf(3) ? 0.1 : 1.0;
        }
        const auto isRight = rule(some, feature.of, draws);
        std::vector<JudgedMeeting> all;
        for (const PairHit &hit : some)
            all.push_back({&hit, isRight(hit)});
        if (draws.oneOf(6))
            all[draws.below(all.size())].isRight ^= true;
        const auto division = divisionBy(all);
        if (!division)
            continue;
        ++kinds[int(division->kind)];
        print << division->phrase << int(division->kind);
    }
    QString text =
        QStringLiteral("meetings by %1: %2").arg(QLatin1String(feature.name), print.text());
    for (const auto &[kind, count] : kinds)
        text += QStringLiteral(" %1×%2").arg(count).arg(kind);
    return text + QLatin1Char('\n');
}

} // namespace

void TestApprovedOccasions::whatDividesIsAsApproved()
{
    QString all;
    Draws draws(1);
    for (const Feature &feature : features)
        all += conditionsTold(feature, draws);
    for (const MeetingFeature &feature : meetingFeatures)
        all += divisionsTold(feature, draws);
    const QString difference = compare(QStringLiteral("occasions.txt"), all);
    QVERIFY2(difference.isEmpty(), qPrintable(difference));
}

QTEST_GUILESS_MAIN(TestApprovedOccasions)
#include "test_approved_occasions.moc"
