// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/rebound_reading.h"
#include "tasks/judging/response_reading.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// What is read from hits of two circles that were worked out by conserved momentum and Newton's
/// law of restitution.
class TestPairReading : public QObject
{
    Q_OBJECT
private slots:
    void massesAreReadFromThePushes();
    void massesAreReadFromOnePush();
    void pushesThatAreNotOppositeTellNoMasses_data();
    void pushesThatAreNotOppositeTellNoMasses();
    void exponentsAreReadFromUnlikeCircles_data();
    void exponentsAreReadFromUnlikeCircles();
    void exponentsThatDisagreeAreNone();
    void exponentsAreRoundedToFiftieths();
    void equalCirclesMayHaveAFixedRatio_data();
    void equalCirclesMayHaveAFixedRatio();
    void reboundIsReadOfEachCircle();
    void laterHitMayBeOdd_data();
    void laterHitMayBeOdd();
    void headOnMeansNothingAcross();
    void lineIsTheOneThatWasAskedFor();
    void answerFitsFromReachedToAStepLater();

private:
    const Vec2 n{0.6, 0.8};
    const Vec2 t{-0.8, 0.6};

    /// Circle 1 comes with 1.2 m/s along the line of centres and 0.4 m/s across it, circle 2 with
    /// −0.3 m/s and 0.1 m/s: they come nearer by 1.5 m/s.
    [[nodiscard]] PairHit hit(double mass1, double mass2, double e) const
    {
        PairHit made;
        made.meeting.restitution = e;
        made.answered = true;
        made.normal = n;
        made.came1 = 1.2 * n + 0.4 * t;
        made.came2 = -0.3 * n + 0.1 * t;
        const double impulse = (1.0 + e) * 1.5 * mass1 * mass2 / (mass1 + mass2);
        made.left1 = made.came1 - impulse / mass1 * n;
        made.left2 = made.came2 + impulse / mass2 * n;
        return made;
    }
    /// Of circles of so many metres and 1000 kg/m³, with masses r^p ρ^s.
    [[nodiscard]] PairHit unlike(Vec2 radii, Vec2 densities, double p, double s) const
    {
        PairHit made = hit(std::pow(radii.x, p) * std::pow(densities.x, s),
                           std::pow(radii.y, p) * std::pow(densities.y, s), 1.0);
        made.meeting.radius1 = radii.x;
        made.meeting.radius2 = radii.y;
        made.meeting.density1 = densities.x;
        made.meeting.density2 = densities.y;
        return made;
    }
    /// Of which nothing was measured.
    static MeasuredPair nothing()
    {
        const Ground ground(Task{}, Preset{});
        const MeasuredFlight flight(nullptr, ground);
        return MeasuredPair(nullptr, ground, flight);
    }
};

namespace {

void compare(double is, double expected, double tolerance = 1e-12)
{
    QVERIFY2(std::abs(is - expected) <= tolerance, QByteArray::number(is, 'g', 17).constData());
}

Vec2 turned(Vec2 v, double radians)
{
    return {std::cos(radians) * v.x - std::sin(radians) * v.y,
            std::sin(radians) * v.x + std::cos(radians) * v.y};
}

} // namespace

void TestPairReading::massesAreReadFromThePushes()
{
    compare(massRatio(hit(1.0, 1.0, 1.0)).value(), 1.0);
    compare(massRatio(hit(2.0, 3.0, 1.0)).value(), 1.5);
    compare(massRatio(hit(3.0, 2.0, 0.0)).value(), 2.0 / 3.0);
}

/// Of (1 + e) u one gets the share of the other in both masses.
void TestPairReading::massesAreReadFromOnePush()
{
    for (const double e : {1.0, 0.5}) {
        PairHit made = hit(2.0, 3.0, e);
        QVERIFY(!isOnePushed(made));
        PairHit first = made;
        first.left2 = first.came2;
        QVERIFY(isOnePushed(first));
        compare(massRatio(first).value(), 1.5);
        made.left1 = made.came1;
        compare(massRatio(made).value(), 1.5);
    }
}

void TestPairReading::pushesThatAreNotOppositeTellNoMasses_data()
{
    QTest::addColumn<double>("turn");  // of the push on circle 2, rad
    QTest::addColumn<double>("first"); // how large the pushes are, m/s
    QTest::addColumn<double>("second");
    QTest::addColumn<bool>("tells");
    QTest::newRow("opposite") << 0.0 << 1.0 << 1.0 << true;
    QTest::newRow("nearly") << 0.018 << 1.0 << 1.0 << true;
    QTest::newRow("askew") << 0.022 << 1.0 << 1.0 << false;
    QTest::newRow("the same way") << 3.14159 << 1.0 << 1.0 << false;
    QTest::newRow("small") << 0.0 << 2e-6 << 2e-6 << true;
    QTest::newRow("one alone, more than all") << 0.0 << 5e-7 << 9.0 << false;
}

/// The sum of their directions is as long as the angle between them and opposite ones: 0.02.
void TestPairReading::pushesThatAreNotOppositeTellNoMasses()
{
    QFETCH(double, turn);
    QFETCH(double, first);
    QFETCH(double, second);
    QFETCH(bool, tells);
    PairHit made = hit(1.0, 1.0, 1.0);
    made.left1 = made.came1 - first * n;
    made.left2 = made.came2 + second * turned(n, turn);
    QCOMPARE(massRatio(made).has_value(), tells);
    for (bool PairHit::*unmet : {&PairHit::parting, &PairHit::late}) {
        PairHit other = made;
        other.*unmet = true;
        QVERIFY(!massRatio(other));
    }
}

void TestPairReading::exponentsAreReadFromUnlikeCircles_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("density");
    QTest::newRow("balls") << 3.0 << 1.0;
    QTest::newRow("discs") << 2.0 << 1.0;
    QTest::newRow("all alike") << 0.0 << 0.0;
    QTest::newRow("the other way") << -1.0 << 0.5;
}

void TestPairReading::exponentsAreReadFromUnlikeCircles()
{
    QFETCH(double, radius);
    QFETCH(double, density);
    MeasuredPair pair = nothing();
    // The third pair is alike, and tells nothing.
    for (const Vec2 radii : {Vec2{0.2, 0.35}, Vec2{0.35, 0.2}, Vec2{0.35, 0.35}})
        pair.radii.push_back(unlike(radii, {7.8, 7.8}, radius, density));
    for (const Vec2 densities : {Vec2{2.0, 7.0}, Vec2{7.0, 2.0}, Vec2{7.0, 7.0}})
        pair.densities.push_back(unlike({0.2, 0.2}, densities, radius, density));
    const MassExponents read(pair);
    compare(read.radius.value(), radius, 1e-9);
    compare(read.density.value(), density, 1e-9);
    const Meeting other{.radius1 = 0.1, .radius2 = 0.3, .density1 = 4.0, .density2 = 2.0};
    compare(read.ratioOf(other), std::pow(3.0, radius) * std::pow(0.5, density), 1e-9);
    // What was not asked for is as it is of balls.
    const MassExponents unknown(nothing());
    QVERIFY(!unknown.radius && !unknown.density);
    compare(unknown.ratioOf(other), 13.5, 1e-9);
}

/// Two exponents may differ by 0.03 (1 + |p|), as much as steps and roundings blur them.
void TestPairReading::exponentsThatDisagreeAreNone()
{
    for (const auto &[other, agree] : {std::pair(3.11, true), std::pair(3.14, false),
                                       std::pair(2.89, true), std::pair(2.86, false)}) {
        MeasuredPair pair = nothing();
        pair.radii = {unlike({0.2, 0.35}, {7.8, 7.8}, 3.0, 1.0),
                      unlike({0.35, 0.2}, {7.8, 7.8}, other, 1.0)};
        pair.densities = {unlike({0.2, 0.2}, {2.0, 7.0}, 3.0, 1.0)};
        const MassExponents read(pair);
        QCOMPARE(read.radius.has_value(), agree);
        QVERIFY(read.density);
        pair.radii[1].answered = false;
        QVERIFY(!MassExponents(pair).radius);
    }
}

void TestPairReading::exponentsAreRoundedToFiftieths()
{
    compare(roundedExponent(2.997), 3.0);
    compare(roundedExponent(2.989), 2.98);
    compare(roundedExponent(-0.515), -0.52);
    compare(roundedExponent(0.009), 0.0);
}

void TestPairReading::equalCirclesMayHaveAFixedRatio_data()
{
    QTest::addColumn<double>("first"); // m₂ / m₁ of one hit and of another
    QTest::addColumn<double>("second");
    QTest::addColumn<bool>("fixed");
    QTest::newRow("none") << 1.0 << 1.0 << false;
    QTest::newRow("hardly") << 1.025 << 1.025 << false;
    QTest::newRow("a little") << 1.035 << 1.035 << true;
    QTest::newRow("twice") << 2.0 << 2.0 << true;
    QTest::newRow("half") << 0.5 << 0.5 << true;
    QTest::newRow("twice, but for roundings") << 2.0 << 2.018 << true;
    QTest::newRow("not the same") << 2.0 << 2.022 << false;
}

void TestPairReading::equalCirclesMayHaveAFixedRatio()
{
    QFETCH(double, first);
    QFETCH(double, second);
    QFETCH(bool, fixed);
    MeasuredPair pair = nothing();
    PairHit unmet = hit(1.0, 5.0, 1.0);
    unmet.late = true;
    pair.equals = {hit(1.0, first, 1.0), unmet, hit(1.0, second, 1.0)};
    QCOMPARE(fixedMassRatio(pair).has_value(), fixed);
    if (fixed)
        compare(*fixedMassRatio(pair), second, 1e-9);
    // Two pushes of such masses that are not those of an elastic hit: 1 % is borne.
    for (const auto &[share, borne] : {std::pair(1.008, true), std::pair(1.012, false),
                                       std::pair(0.992, true), std::pair(0.988, false)}) {
        MeasuredPair blurred = pair;
        for (PairHit &made : blurred.equals) {
            made.left1 = made.came1 + share * made.push1();
            made.left2 = made.came2 + share * made.push2();
        }
        QCOMPARE(fixedMassRatio(blurred).has_value(), fixed && borne);
    }
}

void TestPairReading::reboundIsReadOfEachCircle()
{
    for (const double e : {0.0, 0.4, 1.0}) {
        const PairHit made = hit(1.0, 1.0, e);
        const Rebound read = reboundOf(made);
        compare(read.e, e);
        compare(read.first, e);
        compare(read.second, e);
        compare(read.across1, 1.0);
        compare(read.across2, 1.0);
        compare(read.sum, 1.0); // of 0.9 m/s
        compare(made.rebound(), e);
    }
    PairHit odd = hit(1.0, 1.0, 1.0);
    odd.left1 = 0.3 * n - 0.2 * t;
    odd.left2 = 0.9 * n + 0.05 * t;
    const Rebound read = reboundOf(odd);
    compare(read.first, 2.0 * 0.9 / 1.5 - 1.0);
    compare(read.second, 2.0 * 1.2 / 1.5 - 1.0);
    compare(read.across1, -0.5);
    compare(read.across2, 0.5);
    compare(read.sum, 1.2 / 0.9);
    odd.answered = false;
    compare(reboundOf(odd).first, -1.0);
    compare(reboundOf(odd).second, -1.0);
}

void TestPairReading::laterHitMayBeOdd_data()
{
    QTest::addColumn<double>("first"); // e of the two hits; 0.5 is right
    QTest::addColumn<double>("second");
    QTest::addColumn<bool>("odd");
    QTest::newRow("right") << 0.5 << 0.5 << false;
    QTest::newRow("first a little off") << 0.528 << 0.5 << false;
    QTest::newRow("first off") << 0.532 << 0.5 << true;
    QTest::newRow("first elastic") << 1.0 << 0.508 << true;
    QTest::newRow("both off") << 1.0 << 0.512 << false;
    QTest::newRow("second off") << 0.5 << 1.0 << false;
}

void TestPairReading::laterHitMayBeOdd()
{
    QFETCH(double, first);
    QFETCH(double, second);
    QFETCH(bool, odd);
    LaterHit later{hit(1.0, 1.0, first), hit(1.0, 1.0, second)};
    later.first.meeting.restitution = later.second.meeting.restitution = 0.5;
    QCOMPARE(later.isFirstOdd(), odd);
}

void TestPairReading::headOnMeansNothingAcross()
{
    PairHit made = hit(1.0, 1.0, 1.0);
    QVERIFY(!isHeadOn(made));
    made.came1 = 1.2 * n;
    QVERIFY(!isHeadOn(made));
    made.came2 = -0.3 * n;
    QVERIFY(isHeadOn(made));
    made.came2 = -0.3 * n + 1e-9 * t; // of 1.5 m/s
    QVERIFY(isHeadOn(made));
    made.came1 = 1.2 * n - 1e-9 * t;
    QVERIFY(!isHeadOn(made));
}

void TestPairReading::lineIsTheOneThatWasAskedFor()
{
    PairHit made = hit(1.0, 1.0, 1.0);
    made.meeting.degrees = std::atan2(n.y, n.x) * 45.0 / std::atan(1.0);
    QVERIFY(made.isAligned());
    for (const double side : {-1.0, 1.0}) {
        made.normal = turned(n, side * 0.0018);
        QVERIFY(made.isAligned());
        made.normal = turned(n, side * 0.0022);
        QVERIFY(!made.isAligned());
    }
}

void TestPairReading::answerFitsFromReachedToAStepLater()
{
    PairHit made;
    made.before = 0.42;
    made.reached = 0.38;
    QVERIFY(made.fits(0.38) && made.fits(0.4) && made.fits(0.42) && made.fits(0.46));
    QVERIFY(made.fits(0.38 - 0.8e-9) && made.fits(0.46 + 0.8e-9));
    QVERIFY(!made.fits(0.38 - 1.2e-9) && !made.fits(0.46 + 1.2e-9));
}

QTEST_GUILESS_MAIN(TestPairReading)
#include "test_pair_reading.moc"
