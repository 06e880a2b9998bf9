// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_flight.h"

#include "tasks/judging/judgement.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// A wall that answers far from where it is looks like a fault of the motion, and is told as a
/// wall.
class TestToldStrayWalls : public ToldFlight
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatIsTrueEverywhereIsTold_data();
    void whatIsTrueEverywhereIsTold();
    void whereItBeginsIsTold();
    void whatIsNoWallIsNotCalledOne_data();
    void whatIsNoWallIsNotCalledOne();
    void aLineOfTheFloorIsNoFaultOfTheMotion();
    void aDirectionThatIsNotTakenOverIsNoWall();

private:
    [[nodiscard]] QString said(const char *step, const QString &walls, const char *headline) const
    {
        return bodyOfProgram(step, written({.walls = walls}, structures[0]), headline);
    }
};

void TestToldStrayWalls::whatIsTrueEverywhereIsTold_data()
{
    QTest::addColumn<QString>("walls");
    QTest::addColumn<QString>("wall");
    QTest::newRow("velocity alone")
        << "if c.velocity.x < 0 then c.velocity = vec(-c.velocity.x, c.velocity.y) end"
        << "left wall";
    QTest::newRow("without a question") << "c.velocity = vec(-math.abs(c.velocity.x), c.velocity.y)"
                                        << "right wall";
    QTest::newRow("put there") << "if c.velocity.y > 0 and c.position.y > square.bottom then "
                                  "c.position = vec(c.position.x, square.top - c.radius) "
                                  "c.velocity = vec(c.velocity.x, -c.velocity.y) end"
                               << "ceiling";
}

void TestToldStrayWalls::whatIsTrueEverywhereIsTold()
{
    QFETCH(QString, walls);
    QFETCH(QString, wall);
    for (const char *step : {"L42T8", "L42T12", "L42T17"}) {
        const QString body = said(
            step, walls,
            qPrintable(
                QStringLiteral("Far from the %1 something turns both circles round").arg(wall)));
        const auto n = numbersIn(body, "with (#, #) m/s from (#, #) m, circle 1 has (#, #) m/s");
        QVERIFY2(n.size() == 6, qPrintable(body));
        QVERIFY(n[0] * n[4] < 0.0 || n[1] * n[5] < 0.0);
        QVERIFY(body.contains(QLatin1String("from all places tried; thrown the other way")));
        QCOMPARE(body.contains(QLatin1String("3.8) m then.")), wall == QLatin1String("ceiling"));
    }
}

/// Its sign is lost: the rim is asked for in the middle.
void TestToldStrayWalls::whereItBeginsIsTold()
{
    const QString body = said("L42T17",
                              QStringLiteral("if c.position.y - c.radius < 0.3 then c.velocity = "
                                             "vec(c.velocity.x, math.abs(c.velocity.y)) end"),
                              "Far from the floor something turns both circles round");
    const auto n = numbersIn(
        body, "where its centre comes to y = # m or farther, and its rim to y = # m; the wall is "
              "at y = # m.");
    QVERIFY2(n.size() == 3, qPrintable(body));
    QVERIFY(isNear(n[0], 0.5));
    QVERIFY(isNear(n[1], 0.3));
    QVERIFY(isNear(n[2], -4.0));
}

void TestToldStrayWalls::whatIsNoWallIsNotCalledOne_data()
{
    QTest::addColumn<QString>("walls");
    QTest::newRow("both ways") << "c.velocity = vec(-c.velocity.x, c.velocity.y)";
    QTest::newRow("a band") << "if math.abs(c.position.x) < 1 then "
                               "c.velocity = vec(-c.velocity.x, c.velocity.y) end";
    QTest::newRow("stopped") << "if c.velocity.x < 0 then c.velocity = vec(0, 0) end";
    QTest::newRow("none") << "";
}

void TestToldStrayWalls::whatIsNoWallIsNotCalledOne()
{
    QFETCH(QString, walls);
    QCOMPARE(said("L42T12", walls, "Far from the "), QString());
}

/// Turned that way by the wall opposite it goes on.
void TestToldStrayWalls::aDirectionThatIsNotTakenOverIsNoWall()
{
    const QString body = bodyOfProgram("L42T2", QStringLiteral(R"lua(
            local way_x, way_y = 1, 1
            local speed
            function on_load()
              circle1.velocity = vec(2, 0)
              speed = vec(math.abs(circle1.velocity.x), math.abs(circle1.velocity.y))
            end
            function on_update(h)
              local room = square.half_width - circle1.radius
              local p = circle1.position + vec(way_x * speed.x, way_y * speed.y) * h
              if math.abs(p.x) > room then way_x = p.x > 0 and -1 or 1 end
              if math.abs(p.y) > room then way_y = p.y > 0 and -1 or 1 end
              circle1.position = p
              circle1.velocity = vec(way_x * speed.x, way_y * speed.y)
            end)lua"),
                                       "A start towards the left wall turns circle 1 round");
    QVERIFY2(body.contains(QLatin1String("by the wall opposite, it goes on")), qPrintable(body));
}

/// A floor one metre too high comes into the places where free flight is looked at.
void TestToldStrayWalls::aLineOfTheFloorIsNoFaultOfTheMotion()
{
    const Task &of = task(QStringLiteral("L42T2"));
    const auto report = judgeTask(m_lab, of, Submission(of.preset, QStringLiteral(R"lua(
            function on_load()
              circle1.velocity = vec(2, 0)
            end
            function on_update(h)
              local c = circle1
              local old = c.position
              c.position = c.position + c.velocity * h
              local p, v = c.position, c.velocity
              if math.abs(p.x) + c.radius > 4 then
                c.position = old
                c.velocity = vec(p.x > 0 and -math.abs(v.x) or math.abs(v.x), v.y)
              elseif p.y + c.radius > 4 then
                c.position = old
                c.velocity = vec(v.x, -math.abs(v.y))
              elseif p.y - c.radius < -3 then
                c.position = old
                c.velocity = vec(v.x, math.abs(v.y))
              end
            end)lua")),
                                  1);
    QCOMPARE(report->findings.size(), std::size_t{1});
    QCOMPARE(report->findings[0].aspect, Aspect::Walls);
    QVERIFY(report->findings[0].message.startsWith(
        QStringLiteral("Hits at the floor turn circle 1 round too early")));
}

QTEST_GUILESS_MAIN(TestToldStrayWalls)
#include "test_told_stray_walls.moc"
