// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/world/vec2.h"

#include <QTest>

#include <limits>

using namespace cradle;

class TestVec2 : public QObject
{
    Q_OBJECT
private slots:
    void adds();
    void subtracts();
    void scalesFromBothSides();
    void dividesByANumber();
    void negates();
    void dotIsTheProjectionTimesTheLength();
    void crossIsTheSignedArea();
    void perpendicularTurnsLeft();
    void lengthOfThreeFourIsFive();
    void lengthDoesNotOverflow();
    void lengthOfTinyVectorIsNotZero();
    void quickLengthIsTheLength();
    void normalizedHasLengthOne();
    void normalizedZeroStaysZero();
    void isFiniteSeesBothComponents();
};

void TestVec2::adds()
{
    QVERIFY((Vec2{1, 2} + Vec2{3, -5}) == (Vec2{4, -3}));
    Vec2 v{1, 2};
    v += {0.5, 0.25};
    QVERIFY(v == (Vec2{1.5, 2.25}));
}

void TestVec2::subtracts()
{
    QVERIFY((Vec2{1, 2} - Vec2{3, -5}) == (Vec2{-2, 7}));
    Vec2 v{1, 2};
    v -= {0.5, 0.25};
    QVERIFY(v == (Vec2{0.5, 1.75}));
}

void TestVec2::scalesFromBothSides()
{
    QVERIFY(2.0 * (Vec2{1.5, -3}) == (Vec2{3, -6}));
    QVERIFY((Vec2{1.5, -3}) * 2.0 == (Vec2{3, -6}));
}

void TestVec2::dividesByANumber()
{
    QVERIFY((Vec2{3, -6}) / 4.0 == (Vec2{0.75, -1.5}));
}

void TestVec2::negates()
{
    QVERIFY(-(Vec2{3, -6}) == (Vec2{-3, 6}));
}

void TestVec2::dotIsTheProjectionTimesTheLength()
{
    QCOMPARE(dot({3, 4}, {1, 0}), 3.0);
    QCOMPARE(dot({3, 4}, {-4, 3}), 0.0);
    QCOMPARE(dot({3, 4}, {2, 5}), 26.0);
}

void TestVec2::crossIsTheSignedArea()
{
    QCOMPARE(cross({2, 0}, {0, 3}), 6.0);
    QCOMPARE(cross({0, 3}, {2, 0}), -6.0);
    QCOMPARE(cross({2, 4}, {1, 2}), 0.0);
}

void TestVec2::perpendicularTurnsLeft()
{
    QVERIFY(perpendicular({1, 0}) == (Vec2{0, 1}));
    QVERIFY(perpendicular({0, 1}) == (Vec2{-1, 0}));
    QVERIFY(perpendicular({3, 4}) == (Vec2{-4, 3}));
}

void TestVec2::lengthOfThreeFourIsFive()
{
    QCOMPARE(length({3, 4}), 5.0);
    QCOMPARE(length({-3, 4}), 5.0);
    QCOMPARE(lengthSquared({3, 4}), 25.0);
    QCOMPARE(length({}), 0.0);
}

void TestVec2::lengthDoesNotOverflow()
{
    QCOMPARE(length({3e200, 4e200}), 5e200);
}

void TestVec2::lengthOfTinyVectorIsNotZero()
{
    QCOMPARE(length({3e-200, 4e-200}), 5e-200);
}

/// Also of what has a square that is no number any more.
void TestVec2::quickLengthIsTheLength()
{
    QCOMPARE(quickLength({3, -4}), 5.0);
    QCOMPARE(quickLength({}), 0.0);
    QCOMPARE(quickLength({3e200, 4e200}), 5e200);
    QCOMPARE(quickLength({3e-200, -4e-200}), 5e-200);
    QCOMPARE(quickLength({std::numeric_limits<double>::infinity(), 1}),
             std::numeric_limits<double>::infinity());
    QVERIFY(std::isnan(quickLength({std::numeric_limits<double>::quiet_NaN(), 1})));
    QVERIFY(std::abs(quickLength({0.1, 0.7}) - length({0.1, 0.7})) <= 2e-16);
}

void TestVec2::normalizedHasLengthOne()
{
    QVERIFY(normalized({3, 4}) == (Vec2{0.6, 0.8}));
    QVERIFY(normalized({0, -7}) == (Vec2{0, -1}));
    QVERIFY(normalized({1e-300, 0}) == (Vec2{1, 0}));
}

void TestVec2::normalizedZeroStaysZero()
{
    QVERIFY(normalized({}) == Vec2{});
}

void TestVec2::isFiniteSeesBothComponents()
{
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(isFinite({1, -1e308}));
    QVERIFY(!isFinite({infinity, 0}));
    QVERIFY(!isFinite({0, -infinity}));
    QVERIFY(!isFinite({nan, 0}));
    QVERIFY(!isFinite({0, nan}));
}

QTEST_APPLESS_MAIN(TestVec2)
#include "test_vec2.moc"
