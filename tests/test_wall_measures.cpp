// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/reading/lab_list.h"

using namespace cradle;
using namespace cradle::programs;

/// What is measured of the walls of a program is what the program does at them.
class TestWallMeasures : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void lawIsMeasured_data();
    void lawIsMeasured();
    void wallsThatActAlikeAreAlike();
};

void TestWallMeasures::lawIsMeasured_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<double>("radii");
    QTest::addColumn<double>("power");
    QTest::addColumn<double>("along");
    struct Law {
        const char *name;
        const char *reach;
        const char *back;
        const char *along;
        double radii; ///< of the circle, from its centre to the wall where it turns
        double power; ///< p in back = e^p
        double kept;
    };
    const Law laws[] = {{"right", "c.radius", "restitution", "1", 1.0, 1.0, 1.0},
                        {"centre", "0", "restitution", "1", 0.0, 1.0, 1.0},
                        {"diameter", "2 * c.radius", "restitution", "1", 2.0, 1.0, 1.0},
                        {"far side", "-c.radius", "restitution", "1", -1.0, 1.0, 1.0},
                        {"e squared", "c.radius", "restitution ^ 2", "1", 1.0, 2.0, 1.0},
                        {"elastic", "c.radius", "1", "1", 1.0, 0.0, 1.0},
                        {"friction", "c.radius", "restitution", "0.8", 1.0, 1.0, 0.8},
                        {"along turned", "c.radius", "restitution", "-1", 1.0, 1.0, -1.0}};
    for (const Law &law : laws) {
        for (std::size_t i = 0; i < std::size(wallWays); ++i)
            QTest::addRow("%s, %s, %s", law.name, wallWays[i].name, structures[i].name)
                << written(withWalls(wallsOf(wallWays[i], law.reach, law.back, law.along)),
                           structures[i])
                << law.radii << law.power << law.kept;
    }
}

void TestWallMeasures::lawIsMeasured()
{
    QFETCH(QString, program);
    QFETCH(double, radii);
    QFETCH(double, power);
    QFETCH(double, along);
    const LawBench step(task(QStringLiteral("L42T17")));
    const MeasuredLaws own(&program, step.ground);
    const MeasuredWalls &walls = own.walls();
    QCOMPARE(walls.judged, (std::vector<int>{0, 1}));
    QVERIFY(walls.hits.size() >= 16);
    for (const WallHit &hit : walls.hits) {
        // A circle that loses all its speed may lie where it turned.
        QVERIFY(hit.turned && !hit.missed);
        QVERIFY(hit.fits(radii * hit.radius));
        QVERIFY(std::abs(hit.back - std::pow(hit.restitution, power)) < 1e-6);
        QVERIFY(std::abs(hit.along - along) < 1e-6);
        QVERIFY(!hit.disturbs && hit.again == 0);
    }
}

/// However they are written; and one that lets circles sink is not.
void TestWallMeasures::wallsThatActAlikeAreAlike()
{
    const LawBench step(task(QStringLiteral("L42T17")));
    const auto program = [](std::size_t structure, const char *back) {
        return written(withWalls(wallsOf(wallWays[1], "c.radius", back)), structures[structure]);
    };
    const QString first = program(0, "restitution");
    const QString second = program(3, "restitution");
    const QString other = program(3, "restitution ^ 2");
    const MeasuredLaws a(&first, step.ground);
    const MeasuredLaws b(&second, step.ground);
    const MeasuredLaws c(&other, step.ground);
    QVERIFY(!a.walls().drops.empty());
    QVERIFY(a.walls().isLike(b.walls()));
    QVERIFY(b.walls().isLike(a.walls()));
    QVERIFY(!a.walls().isLike(c.walls()));
}

QTEST_GUILESS_MAIN(TestWallMeasures)
#include "test_wall_measures.moc"
