// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/measured_pair.h"

using namespace cradle;
using namespace cradle::programs;

/// Whatever distance a program asks about, it is seen along the line that is meant, and exactly.
class TestThrownPairs : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void hitsAreSeenAlongTheLineThatIsMeant_data();
    void hitsAreSeenAlongTheLineThatIsMeant();
    void halfTheDistanceIsMissedByNone_data();
    void halfTheDistanceIsMissedByNone();
    void obliqueHitsComeFromBothSidesAlike();
    void meetingThatTakesStepsIsOne();
    void pushThatHardlyIsOneIsNone();
    void answersAreAlikeWhereAllAre_data();
    void answersAreAlikeWhereAllAre();
    void laterHitIsAnother();
};

namespace {

/// A program for one of the steps 12 (masses alike) to 16 (with e).
QString hitting(const QString &step, HitLaw law, int way = 1)
{
    const int number = step.mid(4).toInt();
    if (number < 14)
        law.mass = QStringLiteral("1");
    if (number == 16)
        law.e = QStringLiteral("restitution");
    return written(
        {.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hitOf(hitWays[way], law)},
        structures[1]);
}

std::vector<PairHit> exactHits(const MeasuredPair &pair)
{
    std::vector<PairHit> all = pair.equals;
    for (const auto *more : {&pair.radii, &pair.densities, &pair.rebounds})
        all.insert(all.end(), more->begin(), more->end());
    return all;
}

} // namespace

void TestThrownPairs::hitsAreSeenAlongTheLineThatIsMeant_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("reach");
    for (const char *step : {"L42T12", "L42T14", "L42T16"}) {
        for (const char *reach : {"p.radius + q.radius", "p.radius + q.radius + 0.037",
                                  "0.83 * (p.radius + q.radius)", "0.6 * (p.radius + q.radius)"})
            QTest::addRow("%s, %s", step, reach)
                << QString::fromLatin1(step) << QString::fromLatin1(reach);
    }
}

/// In steps of a ten thousandth of a second, so between two places 0.3 mm apart.
void TestThrownPairs::hitsAreSeenAlongTheLineThatIsMeant()
{
    QFETCH(QString, step);
    QFETCH(QString, reach);
    const LawBench bench(task(step));
    const QString program = hitting(step, {.reach = reach});
    const MeasuredLaws own(&program, bench.ground);
    QVERIFY(own.pair().isJudged);
    const std::vector<PairHit> hits = exactHits(own.pair());
    QVERIFY(hits.size() >= 4);
    for (const PairHit &hit : hits) {
        QVERIFY(hit.isMet());
        QVERIFY2(hit.isAligned(), QByteArray::number(hit.meeting.degrees).constData());
        QVERIFY(0.0 < hit.before - hit.reached && hit.before - hit.reached < 3e-4);
    }
}

void TestThrownPairs::halfTheDistanceIsMissedByNone_data()
{
    QTest::addColumn<QString>("step");
    for (const Task &each : m_lab.tasks) {
        if (Ground(each, each.preset).pair.asked)
            QTest::newRow(qPrintable(each.id)) << each.id;
    }
}

/// Circles that meet obliquely come as near as half the sum of their radii, or they would be told
/// to miss each other.
void TestThrownPairs::halfTheDistanceIsMissedByNone()
{
    QFETCH(QString, step);
    const LawBench bench(task(step));
    const QString program = hitting(step, {.reach = QStringLiteral("0.5 * (p.radius + q.radius)")});
    const MeasuredLaws own(&program, bench.ground);
    for (const PairHit &hit : exactHits(own.pair()))
        QVERIFY(hit.isMet());
    for (const PairHit &hit : own.pair().contacts)
        QVERIFY(hit.isMet());
}

/// Where circle 2 rests: one straight, and two a third aside, one to either side, with different
/// speeds.
void TestThrownPairs::obliqueHitsComeFromBothSidesAlike()
{
    int steps = 0;
    for (const Task &each : m_lab.tasks) {
        const LawBench bench(each);
        const Ground::Pair &pair = bench.ground.pair;
        if (!pair.asked || !pair.oblique || pair.bothMove)
            continue;
        ++steps;
        const std::vector<PairHit> &modes = bench.right.pair().modes;
        QCOMPARE(modes.size(), 3U);
        const auto slope = [&](std::size_t i) {
            const PairVelocities &v = modes[i].meeting.velocities;
            return v.along2 == 0.0 && v.across2 == 0.0 ? v.across1 / v.along1 : 1.0;
        };
        QCOMPARE(slope(0), 0.0);
        QVERIFY(std::abs(slope(1) - 1.0 / 3.0) < 1e-9);
        QVERIFY(std::abs(slope(1) + slope(2)) < 1e-9);
        QVERIFY(modes[2].meeting.closing() - modes[1].meeting.closing() > 0.2);
    }
    QVERIFY(steps > 0);
}

/// Of the closing speed three tenths are answered in every step that they are in touch: one
/// meeting, and another one when the wall sends circle 2 back.
void TestThrownPairs::meetingThatTakesStepsIsOne()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    HitLaw law;
    law.answer = QStringLiteral("local j = 0.3 * closing p.velocity = p.velocity - j * n "
                                "q.velocity = q.velocity + j * n");
    const QString program = hitting(QStringLiteral("L42T12"), law);
    const MeasuredLaws own(&program, bench.ground);
    QVERIFY(own.pair().isJudged);
    QCOMPARE(own.pair().ownContacts, 2);
    QVERIFY(!own.pair().ranThrough);
}

/// From 0.1 m/s on a push counts as the answer to a meeting.
void TestThrownPairs::pushThatHardlyIsOneIsNone()
{
    const LawBench bench(task(QStringLiteral("L42T12")));
    for (const auto &[push, contacts] : {std::pair("0.12", 1), std::pair("0.08", 0)}) {
        HitLaw law{.approach = QStringLiteral("closing > 0 and not done")};
        law.answer = QStringLiteral("p.velocity = p.velocity - %1 * n "
                                    "q.velocity = q.velocity + %1 * n done = true")
                         .arg(QLatin1String(push));
        law.mass = QStringLiteral("1");
        LawProgram once{.walls = wallsOf(wallWays[1], "c.radius", "1"),
                        .hit = hitOf(hitWays[1], law)};
        once.start = QStringLiteral("done = false");
        const QString program = written(once, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        QCOMPARE(own.pair().ownContacts, contacts);
    }
}

void TestThrownPairs::answersAreAlikeWhereAllAre_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<bool>("alike");
    QTest::newRow("another unit") << "1000 * c.density * c.radius ^ 3" << true;
    QTest::newRow("radii alone") << "c.density * c.radius ^ 2" << false;
    QTest::newRow("densities alone") << "c.radius ^ 3" << false;
}

/// Equal circles are answered alike by all of them.
void TestThrownPairs::answersAreAlikeWhereAllAre()
{
    QFETCH(QString, mass);
    QFETCH(bool, alike);
    const LawBench bench(task(QStringLiteral("L42T16")));
    const QString right = hitting(QStringLiteral("L42T16"), {});
    const QString other = hitting(QStringLiteral("L42T16"), {.mass = mass});
    const MeasuredLaws a(&right, bench.ground);
    const MeasuredLaws b(&other, bench.ground);
    QCOMPARE(a.pair().responseIsLike(b.pair()), alike);
    QCOMPARE(b.pair().responseIsLike(a.pair()), alike);
}

/// Two hits of the same circles with lines of centres that differ by more than a quarter of a turn,
/// the second one as fast as the first within a half.
void TestThrownPairs::laterHitIsAnother()
{
    const LawBench bench(task(QStringLiteral("L42T16")));
    for (const int way : {0, 1, 2, 3}) {
        const QString program = hitting(QStringLiteral("L42T16"), {}, way);
        const MeasuredLaws own(&program, bench.ground);
        QVERIFY(own.pair().later);
        const LaterHit &later = *own.pair().later;
        QVERIFY(!later.isFirstOdd());
        QVERIFY(later.first.step < later.second.step);
        QVERIFY(std::abs(later.first.rebound() - later.first.meeting.restitution) < 0.01);
        QVERIFY(std::abs(later.second.rebound() - later.second.meeting.restitution) < 0.01);
        QVERIFY(std::abs(later.first.normal.x) > 0.9);
        QVERIFY(dot(later.first.normal, later.second.normal) < 0.95);
    }
}

QTEST_GUILESS_MAIN(TestThrownPairs)
#include "test_thrown_pairs.moc"
