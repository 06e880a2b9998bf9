// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/meeting_division.h"

#include "tests/made_meetings.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// What divides meetings that come out right from others is told, of meetings of all kinds of which
/// one thing alone decides.
class TestMeetingDivision : public QObject
{
    Q_OBJECT
private slots:
    void whatDecidesIsTold_data();
    void whatDecidesIsTold();
    void limitsAreTold_data();
    void limitsAreTold();
    void limitIsOfTheCircleThatWasThere();
    void slowOnesMayBeAtRest();
    void twoThingsAreNone();
    void roundingIsNoSide();
    void fewAloneAreNoRule();
    void whoseAnswerCounts();
};

namespace {

using DivisionKind = MeetingDivision::Kind;

} // namespace

void TestMeetingDivision::whatDecidesIsTold_data()
{
    QTest::addColumn<MeetingRule>("rule");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("phrase");
    // Of a quantity those above 0, below 0, and where it is 0: words for the three.
    const auto sign = [](const char *name, DivisionKind kind, auto of, const char *positive,
                         const char *negative, const char *zero) {
        const auto row = [&](const char *which, const MeetingRule &rule, const char *text,
                             const char *where) {
            QTest::addRow("%s %s", name, which)
                << rule << static_cast<int>(kind)
                << QString::fromUtf8(text).arg(QString::fromUtf8(where));
        };
        const char *const those = "those where %1, no others";
        const char *const others = "all but those where %1";
        row(
            "> 0", [of](const PairHit &h) { return of(h) > 0.0; }, those, positive);
        if (*negative)
            row(
                "< 0", [of](const PairHit &h) { return of(h) < 0.0; }, those, negative);
        if (!*zero)
            return;
        row(
            "= 0", [of](const PairHit &h) { return of(h) == 0.0; }, those, zero);
        if (*negative)
            row(
                ">= 0", [of](const PairHit &h) { return of(h) >= 0.0; }, others, negative);
        if (*negative)
            row(
                "!= 0", [of](const PairHit &h) { return of(h) != 0.0; }, others, zero);
    };
    using Hit = const PairHit &;
    sign(
        "side", DivisionKind::Side, [](Hit h) { return lineOf(h).x; },
        "circle 2 is to the right of circle 1", "circle 2 is to the left of circle 1", "");
    sign(
        "height", DivisionKind::Side, [](Hit h) { return lineOf(h).y; },
        "circle 2 is above circle 1", "circle 2 is below circle 1", "");
    sign(
        "first comes", DivisionKind::Coming, [](Hit h) { return h.meeting.velocities.along1; },
        "circle 1 comes towards circle 2", "circle 1 moves away from circle 2",
        "circle 1 is at rest");
    sign(
        "second comes", DivisionKind::Coming, [](Hit h) { return -h.meeting.velocities.along2; },
        "circle 2 comes towards circle 1", "circle 2 moves away from circle 1",
        "circle 2 is at rest");
    sign(
        "both", DivisionKind::Coming,
        [](Hit h) { return h.meeting.velocities.along1 * h.meeting.velocities.along2; },
        "both move the same way along the line of centres", "both come towards each other",
        "one of them is at rest");
    sign(
        "faster along", DivisionKind::Coming,
        [](Hit h) {
            return std::abs(h.meeting.velocities.along1) - std::abs(h.meeting.velocities.along2);
        },
        "circle 1 is the faster one along the line of centres",
        "circle 2 is the faster one along the line of centres", "");
    sign(
        "faster", DivisionKind::Coming,
        [](Hit h) { return length(velocityOf(h, 1)) - length(velocityOf(h, 2)); },
        "circle 1 is the faster one", "circle 2 is the faster one", "");
    sign(
        "first in x", DivisionKind::Way, [](Hit h) { return velocityOf(h, 1).x; },
        "circle 1 moves to the right", "circle 1 moves to the left", "");
    sign(
        "first in y", DivisionKind::Way, [](Hit h) { return velocityOf(h, 1).y; },
        "circle 1 moves upward", "circle 1 moves downward", "");
    sign(
        "second in x", DivisionKind::Way, [](Hit h) { return velocityOf(h, 2).x; },
        "circle 2 moves to the right", "circle 2 moves to the left", "");
    sign(
        "second in y", DivisionKind::Way, [](Hit h) { return velocityOf(h, 2).y; },
        "circle 2 moves upward", "circle 2 moves downward", "");
    sign(
        "relative in x", DivisionKind::Way,
        [](Hit h) { return velocityOf(h, 1).x - velocityOf(h, 2).x; },
        "circle 1, seen from circle 2, moves to the right",
        "circle 1, seen from circle 2, moves to the left", "");
    sign(
        "relative in y", DivisionKind::Way,
        [](Hit h) { return velocityOf(h, 1).y - velocityOf(h, 2).y; },
        "circle 1, seen from circle 2, moves upward",
        "circle 1, seen from circle 2, moves downward", "");
    // From the places of both circles alike: of others it is not known which place counts.
    for (const double side : {-1.0, 1.0})
        sign(
            side < 0.0 ? "outward from circle 1" : "outward from circle 2", DivisionKind::Way,
            [side](Hit h) { return outwardFrom(h, side); },
            "circle 1, seen from circle 2, moves away from (0, 0)",
            "circle 1, seen from circle 2, moves towards (0, 0)", "");
    sign(
        "larger", DivisionKind::Size, [](Hit h) { return h.meeting.radius1 - h.meeting.radius2; },
        "circle 1 is the larger one", "circle 2 is the larger one", "both are equally large");
    sign(
        "heavier", DivisionKind::Size,
        [](Hit h) {
            return massOf(h.meeting.radius1, h.meeting.density1)
                   - massOf(h.meeting.radius2, h.meeting.density2);
        },
        "circle 1 is the heavier one", "circle 2 is the heavier one", "");
    sign(
        "denser", DivisionKind::Size, [](Hit h) { return h.meeting.density1 - h.meeting.density2; },
        "circle 1 is the denser one", "circle 2 is the denser one", "both are equally dense");
    sign(
        "with losses", DivisionKind::Size, [](Hit h) { return 1.0 - h.meeting.restitution; },
        "e is less than 1", "", "e is 1");
}

void TestMeetingDivision::whatDecidesIsTold()
{
    QFETCH(MeetingRule, rule);
    const auto found = divisionBy(manyMeetings(), rule);
    QVERIFY(found);
    QTEST(found->phrase, "phrase");
    QTEST(static_cast<int>(found->kind), "kind");
}

void TestMeetingDivision::limitsAreTold_data()
{
    QTest::addColumn<MeetingRule>("rule");
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("begin");
    const auto row = [](const char *begin, DivisionKind kind, const MeetingRule &rule) {
        QTest::newRow(begin) << rule << static_cast<int>(kind) << QString::fromUtf8(begin);
    };
    using Hit = const PairHit &;
    row("all with circle 1 at up to 1.", DivisionKind::Speed,
        [](Hit h) { return length(velocityOf(h, 1)) < 1.2; });
    row("all with circle 2 at 1.", DivisionKind::Speed,
        [](Hit h) { return length(velocityOf(h, 2)) > 1.2; });
    row("all with circle 1 at 1.", DivisionKind::Speed,
        [](Hit h) { return length(velocityOf(h, 1)) > 1.2; });
    row("all with circle 2 at up to 1.", DivisionKind::Speed,
        [](Hit h) { return length(velocityOf(h, 2)) < 1.2; });
    row("all up to 1.", DivisionKind::Place, [](Hit h) { return length(h.meeting.middle) < 2.0; });
    row("all from 2", DivisionKind::Place, [](Hit h) { return length(h.meeting.middle) > 2.0; });
    row("all with up to 1.", DivisionKind::Speed, [](Hit h) { return h.meeting.closing() < 2.0; });
    row("all at x = 1", DivisionKind::Place, [](Hit h) { return h.meeting.middle.x > 1.0; });
}

void TestMeetingDivision::limitsAreTold()
{
    QFETCH(MeetingRule, rule);
    QFETCH(QString, begin);
    const auto found = divisionBy(manyMeetings(), rule);
    QVERIFY(found);
    QVERIFY2(found->phrase.startsWith(begin), qPrintable(found->phrase));
    QTEST(static_cast<int>(found->kind), "kind");
}

void TestMeetingDivision::limitIsOfTheCircleThatWasThere()
{
    for (const int circle : {1, 2}) {
        const auto found = divisionBy(manyMeetings(), [circle](const PairHit &hit) {
            const double side = circle == 1 ? -0.5 : 0.5;
            return (hit.meeting.middle + side * hit.meeting.sum() * lineOf(hit)).x > 1.0;
        });
        QVERIFY(found);
        QVERIFY2(found->phrase.endsWith(QStringLiteral(", where circle %1 was").arg(circle)),
                 qPrintable(found->phrase));
    }
    const auto ofBoth =
        divisionBy(manyMeetings(), [](const PairHit &hit) { return hit.meeting.middle.x > 1.0; });
    QVERIFY(ofBoth && !ofBoth->phrase.contains(QLatin1String("where circle")));
}

/// Where most of those below a limit are at rest, it is no limit.
void TestMeetingDivision::slowOnesMayBeAtRest()
{
    const auto isSlow = [](const PairHit &hit) { return length(velocityOf(hit, 1)) < 0.3; };
    std::vector<PairHit> hits = manyMeetings();
    QVERIFY(!divisionBy(hits, isSlow));
    std::erase_if(hits, [](const PairHit &hit) { return velocityOf(hit, 1) == Vec2{}; });
    const auto found = divisionBy(hits, isSlow);
    QVERIFY(found && found->phrase.startsWith(QLatin1String("all with circle 1 at up to 0.")));
}

/// Of two things that divide them alike none is known to count.
void TestMeetingDivision::twoThingsAreNone()
{
    std::vector<PairHit> hits = manyMeetings();
    std::erase_if(hits, [](const PairHit &hit) {
        return (lineOf(hit).x > 0.0) != (velocityOf(hit, 1).y > 0.0);
    });
    QVERIFY(!divisionBy(hits, [](const PairHit &hit) { return lineOf(hit).x > 0.0; }));
    QVERIFY(divisionBy(hits, [](const PairHit &hit) { return lineOf(hit).y > 0.0; }));
    // The larger one is the heavier one where all are of one density.
    hits = manyMeetings();
    for (PairHit &hit : hits)
        hit.meeting.density1 = hit.meeting.density2 = 2.0;
    const auto found = divisionBy(
        hits, [](const PairHit &hit) { return hit.meeting.radius1 > hit.meeting.radius2; });
    QVERIFY(found);
    QCOMPARE(found->phrase, QStringLiteral("those where circle 1 is the larger one, no others"));
}

/// At 90° the line of centres points neither to the right nor to the left.
void TestMeetingDivision::roundingIsNoSide()
{
    std::vector<PairHit> hits = manyMeetings();
    for (std::size_t i = 0; i < 40; ++i)
        hits[i].meeting.degrees = i % 2 == 0 ? 90.0 : 270.0;
    const auto found = divisionBy(hits, [&](const PairHit &hit) {
        return std::abs(lineOf(hit).x) < 1e-9 ? &hit - hits.data() < 15 : lineOf(hit).x > 0.0;
    });
    QVERIFY(found);
    QCOMPARE(found->phrase,
             QStringLiteral("those where circle 2 is to the right of circle 1, no others"));
}

void TestMeetingDivision::fewAloneAreNoRule()
{
    std::vector<PairHit> hits = manyMeetings();
    const auto isRight = [](const PairHit &hit) { return lineOf(hit).x > 0.0; };
    const auto middle = std::partition(hits.begin(), hits.end(), isRight);
    for (const auto &[more, isRule] : {std::pair(2, false), std::pair(3, true)}) {
        std::vector<PairHit> few(middle - more, hits.end());
        QCOMPARE(divisionBy(few, isRight).has_value(), isRule);
        few.assign(hits.begin(), middle + more);
        QCOMPARE(divisionBy(few, isRight).has_value(), isRule);
    }
}

/// Those that stopped, or were only put back, are not counted; nor is a push askew no answer, but
/// where all are answered.
void TestMeetingDivision::whoseAnswerCounts()
{
    std::vector<PairHit> hits = manyMeetings();
    for (PairHit &hit : hits) {
        hit.answered = true;
        hit.before = hit.meeting.sum();
        hit.reached = hit.before - 0.01;
        hit.normal = hit.nextNormal = lineOf(hit);
        hit.left1 = -1.0 * (lineOf(hit).y > 0.0 ? hit.normal : perpendicular(hit.normal));
        hit.left2 = -1.0 * hit.left1;
    }
    QVERIFY(!divisionOf(hits, false));
    const auto askew = divisionOf(hits, true);
    QVERIFY(askew && askew->isOfDirection);
    QCOMPARE(askew->phrase, QStringLiteral("those where circle 2 is above circle 1, no others"));
    for (PairHit &hit : hits)
        hit.answered = lineOf(hit).x > 0.0;
    for (const bool isAlong : {false, true}) {
        const auto missed = divisionOf(hits, isAlong);
        QVERIFY(missed && !missed->isOfDirection);
        QCOMPARE(missed->phrase,
                 QStringLiteral("those where circle 2 is to the right of circle 1, no others"));
    }
    std::size_t odd = 0;
    for (PairHit &hit : hits) {
        if (lineOf(hit).x > 0.0 && ++odd < 8) {
            hit.answered = false;
            hit.stopped = true;
        }
    }
    QVERIFY(divisionOf(hits, false));
    // Who is put back and never answered comes out wrong.
    const auto held =
        std::find_if(hits.begin(), hits.end(), [](const PairHit &hit) { return hit.stopped; });
    held->stopped = false;
    held->moved1 = true;
    QVERIFY(!divisionOf(hits, false));
}

QTEST_APPLESS_MAIN(TestMeetingDivision)
#include "test_meeting_division.moc"
