// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/measured_wall.h"

#include "tests/law_programs.h"

using namespace cradle;
using namespace cradle::programs;

/// What of a shot at a wall counts as the wall's answer, and what it does to the others.
class TestWallWatch : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatHappensOnTheWayIsNoAnswer_data();
    void whatHappensOnTheWayIsNoAnswer();
    void roundingDisturbsNobody_data();
    void roundingDisturbsNobody();
    void whoGoesBackAgainstItsVelocityIsSeen_data();
    void whoGoesBackAgainstItsVelocityIsSeen();
    void whatIsKeptTurnsNoneAnew_data();
    void whatIsKeptTurnsNoneAnew();
};

void TestWallWatch::whatHappensOnTheWayIsNoAnswer_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<QString>("back"); // share of the speed that comes back; < 0: it flies on
    QTest::addColumn<bool>("moved");   // and it is put elsewhere
    QTest::addColumn<bool>("missed");
    QTest::addColumn<bool>("turned");
    const QString far = QStringLiteral("2 * c.radius");    // met on the way
    const QString atOnce = QStringLiteral("4 * c.radius"); // where it starts
    QTest::newRow("stopped") << far << QStringLiteral("0") << false << false << true;
    QTest::newRow("slowed down") << far << QStringLiteral("-0.5") << false << true << false;
    QTest::newRow("slowed down, put back")
        << far << QStringLiteral("-0.5") << true << false << true;
    QTest::newRow("put back") << far << QStringLiteral("-1") << true << false << false;
    QTest::newRow("slowed down at once")
        << atOnce << QStringLiteral("-0.5") << false << true << false;
    QTest::newRow("slowed down, put back at once")
        << atOnce << QStringLiteral("-0.5") << true << true << false;
    QTest::newRow("put back at once") << atOnce << QStringLiteral("-1") << true << false << false;
    QTest::newRow("turned round at once")
        << atOnce << QStringLiteral("1") << false << false << true;
}

/// A circle that flies on towards a wall, more than a step before its rim is there, has not been
/// answered, unless it was put elsewhere on its way.
void TestWallWatch::whatHappensOnTheWayIsNoAnswer()
{
    QFETCH(QString, reach);
    QFETCH(QString, back);
    QFETCH(bool, moved);
    QFETCH(bool, missed);
    QFETCH(bool, turned);
    const LawBench step(task(QStringLiteral("L42T12")));
    const WallWay way{"", moved ? "s = s - (s > 0 and 0.05 or -0.05)" : "s = s"};
    const QString program =
        written({.walls = wallsOf(way, reach.toUtf8().constData(), back.toUtf8().constData())},
                structures[0]);
    const MeasuredLaws own(&program, step.ground);
    QVERIFY(!own.walls().hits.empty());
    for (const WallHit &hit : own.walls().hits) {
        QCOMPARE(hit.missed, missed);
        QCOMPARE(hit.turned, turned);
        QCOMPARE(hit.held, !missed && !turned);
    }
}

void TestWallWatch::roundingDisturbsNobody_data()
{
    QTest::addColumn<double>("kick");  // m/s
    QTest::addColumn<double>("shift"); // m
    QTest::addColumn<bool>("kicks");
    QTest::addColumn<bool>("disturbs");
    QTest::newRow("nothing") << 0.0 << 0.0 << false << false;
    QTest::newRow("hardly a kick") << 3e-7 << 0.0 << false << false;
    QTest::newRow("a kick") << 3e-6 << 0.0 << true << true;
    // Of a way of some 9 mm in a step.
    QTest::newRow("hardly a shift") << 0.0 << 7e-4 << false << false;
    QTest::newRow("a shift") << 0.0 << 1.3e-3 << false << true;
}

/// What the other circle is given when one is turned at a wall.
void TestWallWatch::roundingDisturbsNobody()
{
    QFETCH(double, kick);
    QFETCH(double, shift);
    QFETCH(bool, kicks);
    QFETCH(bool, disturbs);
    const LawBench step(task(QStringLiteral("L42T12")));
    const QString program = QStringLiteral("function on_update(h) local other "
                                           "for i = 1, 2 do local c = circles[i] "
                                           "local old, came = c.position, c.velocity "
                                           "c.position = c.position + c.velocity * h %1 "
                                           "if (c.velocity - came):length() > 0 then "
                                           "other = circles[3 - i] end end "
                                           "if other then "
                                           "other.velocity = other.velocity + vec(%2, 0) "
                                           "other.position = other.position + vec(%3, 0) end end")
                                .arg(wallsOf(wallWays[1], "c.radius", "1"))
                                .arg(kick, 0, 'g', 17)
                                .arg(shift, 0, 'g', 17);
    const MeasuredLaws own(&program, step.ground);
    QVERIFY(!own.walls().hits.empty());
    for (const WallHit &hit : own.walls().hits) {
        QVERIFY(hit.turned);
        QCOMPARE(hit.kicks, kicks);
        QCOMPARE(hit.disturbs, disturbs);
    }
}

void TestWallWatch::whoGoesBackAgainstItsVelocityIsSeen_data()
{
    QTest::addColumn<QString>("shown"); // of the own y, m/s
    QTest::addColumn<bool>("goesBack");
    QTest::newRow("written") << QStringLiteral("v.y") << false;
    QTest::newRow("not written") << QStringLiteral("circle1.velocity.y") << true;
}

void TestWallWatch::whoGoesBackAgainstItsVelocityIsSeen()
{
    QFETCH(QString, shown);
    QFETCH(bool, goesBack);
    const LawBench step(task(QStringLiteral("L42T2")));
    const QString program = QStringLiteral(R"lua(
        local v
        function on_load()
          circle1.velocity = vec(2, 0)
          v = circle1.velocity
        end
        function on_update(h)
          local p = circle1.position + v * h
          local room = square.half_width - circle1.radius
          if math.abs(p.x) > room and p.x * v.x > 0 then v = vec(-v.x, v.y) end
          if math.abs(p.y) > room and p.y * v.y > 0 then v = vec(v.x, -v.y) end
          circle1.position = p
          circle1.velocity = vec(v.x, %1)
        end)lua")
                                .arg(shown);
    const MeasuredLaws own(&program, step.ground);
    QVERIFY(!own.walls().hits.empty());
    for (const WallHit &hit : own.walls().hits)
        QCOMPARE(hit.goesBack, goesBack && outwardNormal(hit.wall).y != 0.0);
}

void TestWallWatch::whatIsKeptTurnsNoneAnew_data()
{
    QTest::addColumn<QString>("asked");
    QTest::addColumn<bool>("isAnew");
    QTest::newRow("what is beyond") << QStringLiteral("c.position.x > room") << true;
    QTest::newRow("what was beyond") << QStringLiteral("kept") << false;
}

void TestWallWatch::whatIsKeptTurnsNoneAnew()
{
    QFETCH(QString, asked);
    QFETCH(bool, isAnew);
    const LawBench step(task(QStringLiteral("L42T2")));
    const QString program = QStringLiteral(R"lua(
        local kept = false
        function on_load()
          circle1.velocity = vec(2, 0)
        end
        function on_update(h)
          local c = circle1
          c.position = c.position + c.velocity * h
          local room = square.half_width - c.radius
          if %1 then
            c.velocity = vec(-c.velocity.x, c.velocity.y)
            c.position = vec(room + 0.1, c.position.y)
          elseif c.position.x > room and c.velocity.x > 0 then
            c.velocity = vec(-c.velocity.x, c.velocity.y)
            kept = true
          end
        end)lua")
                                .arg(asked);
    const MeasuredLaws own(&program, step.ground);
    int again = 0;
    for (const WallHit &hit : own.walls().hits) {
        again += hit.again > 0;
        QVERIFY(hit.again == 0 || hit.isAgainAnew == isAnew);
    }
    QVERIFY(again > 0);
}

QTEST_GUILESS_MAIN(TestWallWatch)
#include "test_wall_watch.moc"
