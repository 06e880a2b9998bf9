// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// Walls that take speed and put nothing back leave circles outside, and are told so.
class TestWallsOutside : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whoLosesAllSpeedIsLeftOutside();
    void whoIsPutBackIsNot_data();
    void whoIsPutBackIsNot();
    void whoLosesNothingComesBack();

private:
    /// What is said of walls that turn one part, and put a circle back by \p back at the sides.
    [[nodiscard]] std::vector<LawDeviation> said(const QString &back, const char *share,
                                                 const char *step = "L42T17") const
    {
        const LawBench bench(task(QLatin1String(step)));
        const QString walls =
            QStringLiteral(
                "local x, y, r = c.position.x, c.position.y, c.radius "
                "local vx, vy = c.velocity.x, c.velocity.y "
                "if x - r < square.left and vx < 0 or x + r > square.right and vx > 0 then "
                "vx = -vx * %2 %1 end "
                "if y - r < square.bottom and vy < 0 or y + r > square.top and vy > 0 then "
                "vy = -vy * %2 y = old.y end "
                "c.position, c.velocity = vec(x, y), vec(vx, vy)")
                .arg(back, QLatin1String(share));
        const QString program = written({.walls = walls}, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    }
};

/// In numbers that follow from the stage: the depth is what of the way of a step is beyond the
/// wall, and nothing of the velocity is left where e is 0.
void TestWallsOutside::whoLosesAllSpeedIsLeftOutside()
{
    const std::vector<LawDeviation> found = said({}, "restitution");
    QCOMPARE(found.size(), std::size_t{1});
    const LawDeviation &one = found.front();
    QVERIFY2(one.message.startsWith(
                 QLatin1String("Hits at the left wall and right wall leave both circles outside")),
             qPrintable(one.message));
    const Preset &scene = one.moment.stage.preset;
    const Circle &start = scene.circles[0].body;
    const double room = scene.halfWidth - start.radius;
    const double way = std::abs(start.velocity.x) * scene.timestep;
    const double gap = room - std::abs(start.position.x);
    const double deep = std::ceil(gap / way) * way - gap;
    QVERIFY2(one.message.contains(QStringLiteral("circle 1 is %1 m past the ").arg(brief(deep))),
             qPrintable(one.message + QString::number(deep)));
    QVERIFY2(one.message.contains(
                 QLatin1String("takes it back by %1 m a step").arg(brief(scene.restitution * way))),
             qPrintable(one.message));
}

void TestWallsOutside::whoIsPutBackIsNot_data()
{
    QTest::addColumn<QString>("back");
    QTest::newRow("to where it was") << "x = old.x";
    QTest::newRow("to the wall") << "x = x > 0 and square.right - r or square.left + r";
}

void TestWallsOutside::whoIsPutBackIsNot()
{
    QFETCH(const QString, back);
    QVERIFY(said(back, "restitution").empty());
}

/// The next step brings it in again, as fast as it came.
void TestWallsOutside::whoLosesNothingComesBack()
{
    QVERIFY(said({}, "1", "L42T3").empty());
}

QTEST_GUILESS_MAIN(TestWallsOutside)
#include "test_walls_outside.moc"
