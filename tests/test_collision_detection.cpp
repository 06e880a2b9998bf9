// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_paths.h"
#include "model/contacts/collision_detection.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

class TestCollisionDetection : public QObject
{
    Q_OBJECT
private slots:
    void touchingIsNotOverlapping_data();
    void touchingIsNotOverlapping();
    void pathIsTheQuadraticOfItsParts();
    void timeToLineMatchesHandWorkedCase_data();
    void timeToLineMatchesHandWorkedCase();
    void timeToLineKeepsItsDigitsWhereRootsCancel();
};

void TestCollisionDetection::touchingIsNotOverlapping_data()
{
    QTest::addColumn<Vec2>("place"); // of the second circle, r = ¼, beside one of r = ½ at (1, 1)
    QTest::addColumn<bool>("overlapping");
    const double bit = 0x1p-40;
    QTest::newRow("touching in x") << Vec2{1.75, 1} << false;
    QTest::newRow("touching in y") << Vec2{1, 0.25} << false;
    QTest::newRow("touching aslant, 3-4-5") << Vec2{1 + 0.45, 1 + 0.6 + bit} << false;
    QTest::newRow("a hair apart") << Vec2{1.75 + bit, 1} << false;
    QTest::newRow("a hair inside") << Vec2{1.75 - bit, 1} << true;
    QTest::newRow("boxes overlap, circles do not") << Vec2{1.6, 1.6} << false;
    QTest::newRow("centre in circle") << Vec2{1.25, 1} << true;
    QTest::newRow("the same centre") << Vec2{1, 1} << true;
}

void TestCollisionDetection::touchingIsNotOverlapping()
{
    QFETCH(Vec2, place);
    QFETCH(bool, overlapping);
    const Circle a{.position = {1, 1}, .radius = 0.5};
    const Circle b{.position = place, .radius = 0.25};
    QCOMPARE(overlap(a, b), overlapping);
    QCOMPARE(overlap(b, a), overlapping);
}

void TestCollisionDetection::pathIsTheQuadraticOfItsParts()
{
    const Path path{{1, 2}, {3, 4}, {5, 6}};
    QVERIFY(path.at(0.0) == (Vec2{1, 2}));
    QVERIFY(path.at(2.0) == (Vec2{27, 34}));
}

void TestCollisionDetection::timeToLineMatchesHandWorkedCase_data()
{
    QTest::addColumn<double>("gap");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("curve");
    QTest::addColumn<double>("end");
    QTest::addColumn<double>("time");
    QTest::newRow("straight towards") << 1.0 << 2.0 << 0.0 << 1.0 << 0.5;
    QTest::newRow("straight and slow") << 1.0 << 0.5 << 0.0 << 9.0 << 2.0;
    QTest::newRow("just at the end") << 1.0 << 2.0 << 0.0 << 0.5 << 0.5;
    QTest::newRow("after the end") << 1.0 << 2.0 << 0.0 << 0.49 << never;
    QTest::newRow("leaving") << 1.0 << -2.0 << 0.0 << 10.0 << never;
    QTest::newRow("standing") << 1.0 << 0.0 << 0.0 << 10.0 << never;
    QTest::newRow("falling from rest") << 1.0 << 0.0 << 4.0 << 1.0 << 0.5;
    QTest::newRow("falling with a push") << 1.0 << 1.0 << 2.0 << 1.0 << 0.5;    // ½ + 2/4
    QTest::newRow("leaving, curving back") << 1.0 << -2.0 << 3.0 << 2.0 << 1.0; // −2 + 3
    QTest::newRow("leaving, curving away") << 1.0 << -2.0 << -3.0 << 9.0 << never;
    QTest::newRow("turns before the line") << 1.0 << 1.0 << -1.0 << 9.0 << never;
    QTest::newRow("slowed but gets there") << 0.75 << 2.0 << -1.0 << 9.0 << 0.5; // 1 − ¼
    QTest::newRow("touching, going out") << 0.0 << 1.0 << 0.0 << 1.0 << 0.0;
    QTest::newRow("touching, going in") << 0.0 << -1.0 << 0.0 << 1.0 << never;
    QTest::newRow("touching, going in, comes back") << 0.0 << -2.0 << 4.0 << 1.0 << 0.5;
    QTest::newRow("touching, at rest") << 0.0 << 0.0 << 0.0 << 1.0 << never;
    QTest::newRow("touching, at rest, pressed out") << 0.0 << 0.0 << 1.0 << 1.0 << 0.0;
    QTest::newRow("touching, at rest, drawn in") << 0.0 << 0.0 << -1.0 << 1.0 << never;
    QTest::newRow("beyond, going out") << -0.1 << 1.0 << 0.0 << 1.0 << 0.0;
    QTest::newRow("beyond, going in") << -0.1 << -1.0 << 0.0 << 1.0 << never;
}

void TestCollisionDetection::timeToLineMatchesHandWorkedCase()
{
    QFETCH(double, gap);
    QFETCH(double, speed);
    QFETCH(double, curve);
    QFETCH(double, end);
    QFETCH(double, time);
    const std::optional<double> found = timeToLine(gap, speed, curve, end);
    QCOMPARE(found.has_value(), time != never);
    if (found)
        COMPARE_NEAR(*found, time, 1e-15);
}

void TestCollisionDetection::timeToLineKeepsItsDigitsWhereRootsCancel()
{
    // 1 = s + c s² with tiny c: s = 1 − c + 2 c² …
    const std::optional<double> s = timeToLine(1.0, 1.0, 1e-9, 2.0);
    QVERIFY(s.has_value());
    COMPARE_NEAR(*s, 1.0 - 1e-9 + 2e-18, 2e-16);
    // And with speed away: 1e-12 = −s·1 + s²·1 has the positive root 1 + 1e-12 − …
    const std::optional<double> back = timeToLine(1e-12, -1.0, 1.0, 2.0);
    QVERIFY(back.has_value());
    COMPARE_NEAR(*back, 1.0 + 1e-12, 3e-16);
}

QTEST_APPLESS_MAIN(TestCollisionDetection)
#include "test_collision_detection.moc"
