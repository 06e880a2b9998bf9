// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/meeting_division.h"
#include "tasks/judging/pair_words.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// Where some meetings are answered and others are not, what divides them is told, and nothing
/// else.
class TestMissedMeetings : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatDividesThemIsTold_data();
    void whatDividesThemIsTold();
    void whatNothingDividesIsToldSo();
    void exampleIsOfTheWrongOnes();
    void fewAreNoRule();
    void allAroundIsThrown_data();
    void allAroundIsThrown();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

QString programOf(const char *step, const HitLaw &law, std::size_t form)
{
    HitLaw own = law;
    if (text(step).mid(4).toInt() < 14)
        own.mass = text("1");
    return written(withHit(hitOf(hitWays[form == 0 ? 0 : 2], own)), structures[form == 0 ? 3 : 1]);
}

const QString missedHits = QStringLiteral("Some hits of the two circles are not answered");

} // namespace

void TestMissedMeetings::whatDividesThemIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<HitLaw>("law");
    QTest::addColumn<QString>("phrase");
    const auto said = [](std::initializer_list<const char *> steps, const char *name,
                         const HitLaw &law, const QString &phrase) {
        for (const char *step : steps)
            QTest::addRow("%s, %s", name, step) << text(step) << law << phrase;
    };
    const auto rows = [&](std::initializer_list<const char *> steps, const char *name,
                          const HitLaw &law, const char *where) {
        said(steps, name, law, text(": those where %1, no others.").arg(text(where)));
    };
    const auto missed = [&](std::initializer_list<const char *> steps, const char *name,
                            const HitLaw &law, const char *where) {
        said(steps, name, law, text(": all but those where %1.").arg(text(where)));
    };
    const auto asked = [&](const char *name, const char *also, const char *where) {
        rows({"L42T12", "L42T14"}, name, {.approach = text("closing > 0 and ") + text(also)},
             where);
    };
    asked("side", "d.x > 0", "circle 2 is to the right of circle 1");
    asked("other side", "d.y < 0", "circle 2 is below circle 1");
    asked("own way", "p.velocity.x > 0", "circle 1 moves to the right");
    asked("way of circle 2", "q.velocity.y < 0", "circle 2 moves downward");
    asked("relative way", "p.velocity.x > q.velocity.x",
          "circle 1, seen from circle 2, moves to the right");
    asked("outward", "(p.velocity - q.velocity):dot(p.position) > 0",
          "circle 1, seen from circle 2, moves away from (0, 0)");
    asked("circle 1 comes", "p.velocity:dot(n) > 0", "circle 1 comes towards circle 2");
    asked("faster along", "math.abs(p.velocity:dot(n)) > math.abs(q.velocity:dot(n))",
          "circle 1 is the faster one along the line of centres");
    asked("faster", "p.velocity:length() < q.velocity:length()", "circle 2 is the faster one");
    rows({"L42T13", "L42T14"}, "larger",
         {.touch = text("d:length() < reach and "
                        "p.radius > q.radius")},
         "circle 1 is the larger one");
    rows({"L42T15", "L42T16"}, "heavier", {.approach = text("closing > 0 and m1 > m2")},
         "circle 1 is the heavier one");
    rows({"L42T16"}, "denser", {.approach = text("closing > 0 and p.density < q.density")},
         "circle 2 is the denser one");
    missed({"L42T12", "L42T14"}, "circle 2 comes or rests",
           {.approach = text("closing > 0 and q.velocity:dot(n) <= 0")},
           "circle 2 moves away from circle 1");
    missed(
        {"L42T10", "L42T12"}, "both move",
        {.approach = text("closing > 0 and p.velocity:length() > 0 and q.velocity:length() > 0")},
        "one of them is at rest");
    missed({"L42T9", "L42T12"}, "circle 2 moves",
           {.approach = text("closing > 0 and q.velocity:length() > 0")}, "circle 2 is at rest");
    missed({"L42T14"}, "as large", {.touch = text("d:length() < reach and p.radius <= q.radius")},
           "circle 1 is the larger one");
    missed({"L42T12", "L42T14"}, "up or level",
           {.approach = text("closing > 0 and p.velocity.y >= 0")}, "circle 1 moves downward");
    said({"L42T12"}, "near the middle",
         {.approach = text("closing > 0 and (p.position + q.position):length() < 4.4")},
         text(": all up to 2.18 m from (0, 0), none from 2.21 m on."));
    said({"L42T12"}, "circle 1 on the left", {.approach = text("closing > 0 and p.position.x < 0")},
         text(", where circle 1 was"));
    said({"L42T12"}, "circle 2 far down", {.approach = text("closing > 0 and q.position.y < -0.8")},
         text(", where circle 2 was"));
}

void TestMissedMeetings::whatDividesThemIsTold()
{
    QFETCH(QString, step);
    QFETCH(HitLaw, law);
    QFETCH(QString, phrase);
    const LawBench bench(task(step));
    for (const std::size_t form : {0U, 1U}) {
        const auto found = bench.contactFound(programOf(step.toUtf8().constData(), law, form));
        QCOMPARE(LawBench::headlines(found), QStringList(missedHits));
        QVERIFY2(found[0].message.contains(phrase), qPrintable(found[0].message));
    }
}

void TestMissedMeetings::whatNothingDividesIsToldSo()
{
    const LawBench bench(task(text("L42T12")));
    const HitLaw law{.approach = text("closing > 0 and p.velocity.x * q.velocity.y > 0.01")};
    const auto found = bench.contactFound(programOf("L42T12", law, 0));
    QCOMPARE(LawBench::headlines(found), QStringList(missedHits));
    QVERIFY2(!found[0].message.contains(text("those where")), qPrintable(found[0].message));
}

void TestMissedMeetings::exampleIsOfTheWrongOnes()
{
    const LawBench bench(task(text("L42T14")));
    const QString program =
        programOf("L42T14", {.approach = text("closing > 0 and p.radius > q.radius")}, 0);
    const MeasuredLaws own(&program, bench.ground);
    const auto found = contactDeviations(own.pair(), bench.right.pair(), bench.ground);
    const QString said = bodyOf(found, missedHits);
    const auto counts =
        numbersIn(said, "Of # meetings tried, # were answered in time: those where circle 1 is the "
                        "larger one, no others.");
    QVERIFY2(counts.size() == 2, qPrintable(said));
    QCOMPARE(counts[0], 36.0);
    QCOMPARE(static_cast<std::size_t>(counts[1]),
             static_cast<std::size_t>(std::count_if(
                 own.pair().varied.begin(), own.pair().varied.end(),
                 [](const PairHit &hit) { return hit.meeting.radius1 > hit.meeting.radius2; })));
    const auto missed =
        numbersIn(said, "This one came out wrong: circle 1 came with (#, #) m/s, circle 2 with (#, "
                        "#) m/s, their line of centres at #°, r₁ = #, r₂ = # m.");
    QVERIFY2(missed.size() == 7, qPrintable(said));
    QVERIFY(missed[5] <= missed[6]);
}

/// Of few any that lies at the edge could be told from the others.
void TestMissedMeetings::fewAreNoRule()
{
    const LawBench bench(task(text("L42T14")));
    const QString program = programOf("L42T14", {.approach = text("false")}, 0);
    const MeasuredLaws own(&program, bench.ground);
    std::vector<PairHit> hits = own.pair().varied;
    QCOMPARE(hits.size(), std::size_t{36});
    QVERIFY(!divisionOf(hits, true));
    const auto answer = [](PairHit &hit) {
        hit.answered = true;
        hit.before = hit.meeting.sum();
    };
    const auto isLarger = [](const PairHit &hit) {
        return hit.meeting.radius1 > hit.meeting.radius2;
    };
    answer(*std::find_if(hits.begin(), hits.end(), isLarger));
    QVERIFY(!divisionOf(hits, true));
    for (PairHit &hit : hits) {
        if (isLarger(hit))
            answer(hit);
    }
    QVERIFY(divisionOf(hits, true));
    QVERIFY(divisionOf(hits, true)->kind == MeetingDivision::Kind::Size);
}

void TestMissedMeetings::allAroundIsThrown_data()
{
    QTest::addColumn<QString>("step");
    for (const char *step : {"L42T9", "L42T10", "L42T11", "L42T12", "L42T14", "L42T16"})
        QTest::newRow(step) << text(step);
}

/// What a step never asks about is thrown in none of its meetings, and a right program answers
/// all.
void TestMissedMeetings::allAroundIsThrown()
{
    QFETCH(QString, step);
    const LawBench bench(task(step));
    const Ground::Pair &asked = bench.ground.pair;
    const QString never = programOf(step.toUtf8().constData(), {.approach = text("false")}, 0);
    const MeasuredLaws own(&never, bench.ground);
    int right = 0;
    for (const PairHit &hit : own.pair().varied) {
        const Meeting &m = hit.meeting;
        QVERIFY(m.closing() > 0.5);
        QVERIFY(asked.bothMove || (m.velocities.along2 == 0.0 && m.velocities.across2 == 0.0));
        QVERIFY(asked.oblique || m.velocities.across1 == m.velocities.across2);
        QVERIFY(asked.radii.low - 0.006 <= m.radius1 && m.radius2 <= asked.radii.high + 0.006);
        Probe probe(&bench.task.solution, hit.stage);
        for (int k = 0; k < 8; ++k)
            QVERIFY(probe.step());
        const Vec2 before = hit.stage.preset.circles[0].body.velocity;
        right += probe.circle(0).velocity != before
                 || probe.circle(1).velocity != hit.stage.preset.circles[1].body.velocity;
    }
    QCOMPARE(right, 36);
}

QTEST_GUILESS_MAIN(TestMissedMeetings)
#include "test_missed_meetings.moc"
