// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/circle.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

class TestCircle : public QObject
{
    Q_OBJECT
private slots:
    void massMatchesHandWorkedCase_data();
    void massMatchesHandWorkedCase();
    void massGrowsWithTheCubeOfTheRadius();
    void doubledDensityIsNearlyTheVolumeOfRadius252();
    void circlesAreEqualByValue();
};

void TestCircle::massMatchesHandWorkedCase_data()
{
    QTest::addColumn<double>("radius");  // m
    QTest::addColumn<double>("density"); // 1000 kg/m³
    QTest::addColumn<double>("kilograms");
    // 4/3 π = 4.18879020478639098…
    QTest::newRow("unit ball of water") << 1.0 << 1.0 << 4188.79020478639098;
    QTest::newRow("the lab's steel ball") << 0.2 << 7.8 << 261.380508778670797;
    QTest::newRow("half the radius") << 0.1 << 7.8 << 32.6725635973338496;
    QTest::newRow("the lab's larger ball") << 0.252 << 7.8 << 522.859296628642;
}

void TestCircle::massMatchesHandWorkedCase()
{
    QFETCH(double, radius);
    QFETCH(double, density);
    QFETCH(double, kilograms);
    COMPARE_NEAR(mass({.radius = radius, .density = density}), kilograms, 1e-12 * kilograms);
}

void TestCircle::massGrowsWithTheCubeOfTheRadius()
{
    const double small = mass({.radius = 0.25, .density = 2.0});
    QCOMPARE(mass({.radius = 0.5, .density = 2.0}), 8.0 * small);
    QCOMPARE(mass({.radius = 0.25, .density = 4.0}), 2.0 * small);
}

void TestCircle::doubledDensityIsNearlyTheVolumeOfRadius252()
{
    // (0.252/0.2)³ = 1.26³ = 2.000376
    const double ratio = mass({.radius = 0.252}) / mass({.radius = 0.2});
    COMPARE_NEAR(ratio, 2.000376, 1e-12);
}

void TestCircle::circlesAreEqualByValue()
{
    const Circle c{.position = {1, 2}, .velocity = {3, 4}, .radius = 0.5, .density = 2.0};
    Circle d = c;
    QVERIFY(c == d);
    d.velocity.y = 4.5;
    QVERIFY(!(c == d));
}

QTEST_APPLESS_MAIN(TestCircle)
#include "test_circle.moc"
