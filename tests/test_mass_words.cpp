// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_reading.h"

#include "tests/made_hits.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// What is said of masses, of hits that were worked out with masses r^p ρ^s; r³ ρ is right.
class TestMassWords : public QObject
{
    Q_OBJECT
private slots:
    void powersAreTold_data();
    void powersAreTold();
    void largerOneAnswersAsTheLighter();
    void besideOtherFaultsOnlyClearPowersAreTold();
    void sharesThatNoMassesMakeAreTold();
    void pushesOfTheWrongSignAreTold();
    void numbersInPlaceOfMassesAreTold_data();
    void numbersInPlaceOfMassesAreTold();
    void oneCircleAloneTells_data();
    void oneCircleAloneTells();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

/// As it is right.
MeasuredPair ofBalls()
{
    return pairOfPowers(3.0, 1.0);
}

const char *const other = "Each circle answers as if it had the mass of the other";
const char *const twoWays = "The two masses are not worked out in the same way";

} // namespace

void TestMassWords::powersAreTold_data()
{
    QTest::addColumn<double>("radius"); // p
    QTest::addColumn<double>("density");
    QTest::addColumn<QStringList>("said");
    const auto row = [](double p, double s, std::initializer_list<const char *> said) {
        QStringList all;
        for (const char *each : said)
            all.append(utf8(each));
        QTest::addRow("r^%g, density^%g", p, s) << p << s << all;
    };
    row(3.0, 1.0, {});
    row(2.0, 1.0, {"The mass grows with r to the power of 2, not 3"});
    row(2.035, 1.0, {"The mass grows with r to the power of 2.04, not 3"});
    row(2.045, 1.0, {"The masses do not follow the radii as those of balls do"});
    row(3.025, 1.0, {});
    row(3.035, 1.0, {"The mass grows with r to the power of 3.04, not 3"});
    row(0.0, 1.0, {"The hits do not depend on the radii"});
    row(0.003, 1.0, {"The hits do not depend on the radii"});
    row(0.0045, 1.0, {"The hits hardly depend on the radii"});
    row(-0.0045, 1.0, {"The hits hardly depend on the radii"});
    row(0.027, 1.0, {"The hits hardly depend on the radii"});
    row(0.033, 1.0, {"The mass grows with r to the power of 0.04, not 3"});
    row(3.0, 0.5, {"The mass grows with the density to the power of 0.5, not 1"});
    row(3.0, 0.975, {});
    row(3.0, 0.965, {"The mass grows with the density to the power of 0.96, not 1"});
    row(3.0, 0.0, {"The hits do not depend on the densities"});
    row(3.0, 0.7, {"The masses do not follow the densities"});
    row(0.0, 0.0, {"Both velocities change equally much, whatever the masses are"});
    row(0.028, 0.028, {"Both velocities change equally much, whatever the masses are"});
    row(0.0, 0.033,
        {"The hits do not depend on the radii",
         "The mass grows with the density to the power of 0.04, not 1"});
    row(2.0, 2.0,
        {"The mass grows with r to the power of 2, not 3",
         "The mass grows with the density to the power of 2, not 1"});
    row(-3.0, -1.0, {other});
    row(-2.0, -1.0, {other, "The mass grows with r to the power of 2, not 3"});
    row(-2.3, -1.0, {"The heavier circle is pushed away faster"});
    row(-3.025, -1.0, {other});
    row(-3.0, 1.0, {"Each circle answers as if it had the other's radius"});
    row(3.0, -1.0, {"Each circle answers as if it had the other's density"});
}

void TestMassWords::powersAreTold()
{
    QFETCH(double, radius);
    QFETCH(double, density);
    QTEST(headlinesOf(massDeviations(pairOfPowers(radius, density), ofBalls(), true)), "said");
}

/// Where densities are not varied, nothing is known of them.
void TestMassWords::largerOneAnswersAsTheLighter()
{
    MeasuredPair own = pairOfPowers(-3.0, 1.0);
    MeasuredPair right = ofBalls();
    own.densities.clear();
    right.densities.clear();
    const auto found = massDeviations(own, right, true);
    QCOMPARE(headlinesOf(found),
             QStringList(utf8("The larger of two circles answers as the lighter one")));
    QCOMPARE(found.front().suspect, Suspect::Formula);
    // As 1 to 1.75³ = 5.36, taken the other way round.
    QVERIFY(found.front().message.contains(
        utf8("the change of v₁ was 0.187 times that of v₂; m₂/m₁ = 5.36 is right")));
    QVERIFY(massDeviations(noHits(), right, true).empty());
}

void TestMassWords::besideOtherFaultsOnlyClearPowersAreTold()
{
    for (const auto &[p, isTold] : {std::pair(2.0, true), std::pair(2.5, true),
                                    std::pair(2.035, true), std::pair(2.045, false)}) {
        QCOMPARE(!massDeviations(pairOfPowers(p, 1.0), ofBalls(), false).empty(), isTold);
        QVERIFY(!massDeviations(pairOfPowers(p, 1.0), ofBalls(), true).empty());
        QCOMPARE(!massDeviations(pairOfPowers(3.0, p), ofBalls(), false).empty(), isTold);
    }
}

/// m₂/m₁ and m₁/m₂ for the shares of the two: the pushes are as those of masses that grow with r⁶,
/// but together they are no share of what parts the circles.
void TestMassWords::sharesThatNoMassesMakeAreTold()
{
    MeasuredPair own = pairOfPowers(6.0, 2.0);
    const auto lengthen = [](PairHit &hit, double factor) {
        hit.left1 = hit.came1 + factor * hit.push1();
        hit.left2 = hit.came2 + factor * hit.push2();
    };
    const double ratio = std::pow(0.35 / 0.2, 3.0);
    lengthen(own.radii[0], (ratio + 1.0 / ratio) / 2.0);
    const auto found = massDeviations(own, ofBalls(), true);
    QCOMPARE(headlinesOf(found),
             QStringList(utf8("The shares of the two circles do not add up to 1")));
    // Closing speed 1.5 m/s: m₂/m₁ = 5.36 and 0.187 times it.
    QVERIFY2(found.front().message.contains(
                 utf8("Circle 1 changed its velocity by 8.04 m/s and circle 2 by 0.28, together "
                      "8.32 m/s; (1 + e) u = 3 m/s is right.")),
             qPrintable(found.front().message));
    // Where equal circles are pushed wrongly by the same factor, masses may still be told.
    QVERIFY(massDeviations(own, ofBalls(), false).empty());
    MeasuredPair stronger = pairOfPowers(2.0, 1.0);
    for (auto *hits : {&stronger.equals, &stronger.radii, &stronger.densities}) {
        for (PairHit &hit : *hits)
            lengthen(hit, 1.1);
    }
    QCOMPARE(headlinesOf(massDeviations(stronger, ofBalls(), false)),
             QStringList(utf8("The mass grows with r to the power of 2, not 3")));
}

/// Equal circles part as they should; where one is larger, both pushes have the other sign.
void TestMassWords::pushesOfTheWrongSignAreTold()
{
    MeasuredPair own = ofBalls();
    PairHit &hit = own.radii[0];
    hit.left1 = hit.came1 - hit.push1();
    hit.left2 = hit.came2 - hit.push2();
    const auto found = massDeviations(own, ofBalls(), true);
    QCOMPARE(headlinesOf(found),
             QStringList(utf8("Some hits drive the circles towards each other")));
    // Of 3 m/s the smaller one, 5.36 times as light, takes the larger share.
    QVERIFY2(found.front().message.contains(utf8(
                 "the velocity of circle 1 changed by 2.53 m/s and that of circle 2 by -0.472 m/s, "
                 "so that they come nearer still faster. A hit takes (1 + e) u = 3 m/s of that")),
             qPrintable(found.front().message));
}

void TestMassWords::numbersInPlaceOfMassesAreTold_data()
{
    QTest::addColumn<double>("radii"); // m₂/m₁ of hits in which these differ; it is 2 in others
    QTest::addColumn<double>("densities");
    QTest::addColumn<double>("denser"); // where both are denser
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("body");
    const QString same = utf8("The two masses have the same ratio in all hits tried");
    const QString ways = utf8(twoWays);
    const QString always = utf8("as if circle 2 were 2 times as heavy as circle 1. Work each");
    QTest::newRow("numbers") << 2.0 << 2.0 << 2.0 << same << always;
    QTest::newRow("but for roundings") << 2.056 << 1.944 << 2.016 << same << always;
    QTest::newRow("denser ones a little otherwise")
        << 2.0 << 2.0 << 2.024 << ways << utf8("with another density that both have 2.02 times");
    QTest::newRow("denser ones") << 2.0 << 2.0 << 1.0 << ways
                                 << utf8("with another density that both have 1 times");
    QTest::newRow("radii") << 2.064 << 2.0 << 2.0 << ways
                           << utf8("with r₁ = 0.2 and r₂ = 0.35 m as if it were 2.06 times");
    QTest::newRow("densities") << 2.0 << 1.936 << 2.0 << ways
                               << utf8("with ρ₁ = 2 and ρ₂ = 7 as if it were 1.94 times");
}

void TestMassWords::numbersInPlaceOfMassesAreTold()
{
    QFETCH(double, radii);
    QFETCH(double, densities);
    QFETCH(double, denser);
    QFETCH(QString, body);
    MeasuredPair own = ofBalls();
    const auto give = [](PairHit &hit, double ratio) {
        const PairHit made = hitOfMasses(1.0, ratio, 1.0);
        hit.left1 = made.left1;
        hit.left2 = made.left2;
    };
    give(own.equals.front(), 2.0);
    for (PairHit &hit : own.radii)
        give(hit, radii);
    for (PairHit &hit : own.densities)
        give(hit, hit.meeting.density1 == hit.meeting.density2 ? denser : densities);
    const auto found = massDeviations(own, ofBalls(), false);
    QCOMPARE(found.size(), std::size_t{1});
    QTEST(headlinesOf(found).front(), "headline");
    QVERIFY2(found.front().message.contains(body), qPrintable(found.front().message));
    QVERIFY(found.front().isOfSome);
    QCOMPARE(found.front().suspect, Suspect::Masses);
}

void TestMassWords::oneCircleAloneTells_data()
{
    QTest::addColumn<int>("circle"); // that leaves as masses r^p ρ^s make it; the other one is odd
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("density");
    QTest::addColumn<double>("off"); // by how much, m/s, equal circles leave it
    QTest::addColumn<QStringList>("said");
    const QStringList discs{utf8("The mass grows with r to the power of 2, not 3")};
    for (const int circle : {1, 2}) {
        const auto row = [&](const char *name, double p, double s, double off, QStringList said) {
            QTest::addRow("circle %d, %s", circle, name) << circle << p << s << off << said;
        };
        row("discs", 2.0, 1.0, 0.0, discs);
        row("discs, blurred", 2.0, 1.0, 4.9e-3, discs);
        row("discs, and equal ones wrong", 2.0, 1.0, 5.1e-3, {});
        row("right", 3.0, 1.0, 0.0, {});
        row("a root", 0.5, 1.0, 0.0, {utf8("The mass grows with r to the power of 0.5, not 3")});
        row("exchanged", -3.0, -1.0, 0.0,
            {utf8("Circle %1 answers as if it had the mass of the other").arg(circle)});
        row("no radius", 0.0, 1.0, 0.0, {});
        row("no power", 2.3, 1.0, 0.0, {});
        row("no power of the density", 3.0, 0.7, 0.0, {});
        row("no density", 2.0, 0.0, 0.0, {});
    }
}

void TestMassWords::oneCircleAloneTells()
{
    QFETCH(int, circle);
    QFETCH(double, radius);
    QFETCH(double, density);
    QFETCH(double, off);
    MeasuredPair own = pairOfPowers(radius, density);
    for (auto *hits : {&own.equals, &own.radii, &own.densities}) {
        for (PairHit &hit : *hits) {
            Vec2 &odd = circle == 1 ? hit.left2 : hit.left1;
            odd += 0.3 * normal;
        }
    }
    (circle == 1 ? own.equals.front().left1 : own.equals.front().left2) += off * normal;
    const auto found = massDeviationsBeside(own, ofBalls());
    QTEST(headlinesOf(found), "said");
    for (const LawDeviation &each : found)
        QVERIFY2(each.message.contains(utf8("circle %1 leaves as if").arg(circle)),
                 qPrintable(each.message));
    own.equals.front().answered = false;
    QVERIFY(massDeviationsBeside(own, ofBalls()).empty());
}

QTEST_GUILESS_MAIN(TestMassWords)
#include "test_mass_words.moc"
