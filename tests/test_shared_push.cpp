// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/response_law_words.h"
#include "tasks/judging/response_reading.h"

#include "tests/made_hits.h"

#include <QTest>

using namespace cradle;
using namespace cradle::made;

/// What is said of pushes that are not those of one impulse, and of the size of one, of hits that
/// were made up.
class TestSharedPush : public QObject
{
    Q_OBJECT
private slots:
    void circleThatLeavesRightlyIsTold_data();
    void circleThatLeavesRightlyIsTold();
    void onlyHitsOfOneECount();
    void exchangedSharesAreTold_data();
    void exchangedSharesAreTold();
    void ratioThatHangsOnEIsTold_data();
    void ratioThatHangsOnEIsTold();
    void sizeThatHangsOnTheTimestepIsTold();
    void noiseIsNoPartOfAHit();
};

namespace {

QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

MeasuredPair ofBalls()
{
    return pairOfPowers(3.0, 1.0);
}

QString headlineOf(const std::optional<LawDeviation> &said)
{
    return said ? headlinesOf({*said}).front() : QString();
}

/// In which each gets the other's share of the rebound, for 1.5 m/s, and circle 1 that much more.
void exchangeShares(PairHit &hit, double off = 0.0)
{
    const Meeting &m = hit.meeting;
    const double m1 = m.density1 * std::pow(m.radius1, 3.0);
    const double m2 = m.density2 * std::pow(m.radius2, 3.0);
    const double e = m.restitution;
    const double share = 1.5 / (m1 + m2);
    hit.left1 = (1.2 - share * (m2 + e * m1) + off) * normal + 0.4 * tangent;
    hit.left2 = (-0.3 + share * (m1 + e * m2)) * normal + 0.1 * tangent;
}

} // namespace

void TestSharedPush::circleThatLeavesRightlyIsTold_data()
{
    QTest::addColumn<double>("off1"); // of the velocity that circle 1 leaves with, relative
    QTest::addColumn<double>("off2");
    QTest::addColumn<double>("equal"); // and in a hit of equal circles
    QTest::addColumn<int>("circle");   // that leaves rightly; 0: not told
    QTest::newRow("neither") << 0.0 << 0.0 << 0.0 << 0;
    QTest::newRow("circle 2 off") << 0.0 << 0.1 << 0.0 << 1;
    QTest::newRow("circle 1 off") << 0.1 << 0.0 << 0.0 << 2;
    QTest::newRow("circle 2 a little off") << 0.0 << 0.011 << 0.0 << 1;
    QTest::newRow("circle 1 a little off") << 0.011 << 0.0 << 0.0 << 2;
    QTest::newRow("blurred") << 0.009 << 0.009 << 0.0 << 0;
    QTest::newRow("circle 2 off, circle 1 blurred") << 0.009 << 0.1 << 0.0 << 1;
    QTest::newRow("both off") << 0.1 << 0.1 << 0.0 << 0;
    QTest::newRow("equal ones blurred") << 0.0 << 0.1 << 0.009 << 1;
    QTest::newRow("equal ones off") << 0.0 << 0.1 << 0.011 << 0;
}

/// Relative to the sum of both speeds.
void TestSharedPush::circleThatLeavesRightlyIsTold()
{
    QFETCH(double, off1);
    QFETCH(double, off2);
    QFETCH(double, equal);
    QFETCH(int, circle);
    const MeasuredPair right = ofBalls();
    MeasuredPair own = right;
    const auto spoil = [](PairHit &hit, double one, double two) {
        const double sum = length(hit.left1) + length(hit.left2);
        hit.left1 += one * sum * tangent;
        hit.left2 += two * sum * tangent;
    };
    spoil(own.equals.front(), 0.0, equal);
    for (auto *hits : {&own.radii, &own.densities}) {
        for (PairHit &hit : *hits)
            spoil(hit, off1, off2);
    }
    const auto found = sharedPushDeviation(own, right);
    QCOMPARE(headlineOf(found),
             circle == 0
                 ? QString()
                 : utf8("Where the masses differ, only circle %1 leaves as it should").arg(circle));
    if (found)
        QCOMPARE(found->moment.circles, std::vector<int>{2 - circle});
    // In one hit it is the other one that leaves rightly.
    spoil(own.radii[1], off2 - off1, off1 - off2);
    QVERIFY(!sharedPushDeviation(own, right));
}

void TestSharedPush::onlyHitsOfOneECount()
{
    const MeasuredPair right = ofBalls();
    MeasuredPair own = right;
    own.densities.front().left2 += 0.5 * tangent;
    own.densities.front().meeting.restitution = 0.5;
    QVERIFY(!sharedPushDeviation(own, right));
    own.densities.front().meeting.restitution = 1.0;
    QVERIFY(sharedPushDeviation(own, right));
    own.densities.front().late = true;
    QVERIFY(!sharedPushDeviation(own, right));
}

void TestSharedPush::exchangedSharesAreTold_data()
{
    QTest::addColumn<Vec2>("densities");
    QTest::addColumn<double>("e");
    QTest::addColumn<double>("off"); // m/s, of one of them
    QTest::addColumn<bool>("told");
    QTest::newRow("half") << Vec2{2, 7} << 0.5 << 0.0 << true;
    QTest::newRow("the other way") << Vec2{7, 2} << 0.5 << 0.0 << true;
    QTest::newRow("blurred") << Vec2{2, 7} << 0.5 << 0.024 << true;
    QTest::newRow("off") << Vec2{2, 7} << 0.5 << 0.026 << false;
    QTest::newRow("little e") << Vec2{2, 7} << 0.12 << 0.0 << true;
    QTest::newRow("less e") << Vec2{2, 7} << 0.08 << 0.0 << false;
    QTest::newRow("much e") << Vec2{2, 7} << 0.88 << 0.0 << true;
    QTest::newRow("more e") << Vec2{2, 7} << 0.92 << 0.0 << false;
    QTest::newRow("of equal ones") << Vec2{2, 2} << 0.5 << 0.0 << false;
}

/// 0.025 m/s of 1.5 m/s is borne.
void TestSharedPush::exchangedSharesAreTold()
{
    QFETCH(Vec2, densities);
    QFETCH(double, e);
    QFETCH(double, off);
    QFETCH(bool, told);
    MeasuredPair right = ofBalls();
    MeasuredPair own = right;
    right.densities = {hitOfUnlike({0.2, 0.2}, densities, 3.0, 1.0, e)};
    own.densities = right.densities;
    exchangeShares(own.densities.front(), off);
    for (PairHit &hit : own.radii)
        exchangeShares(hit);
    const auto exchanged = [&] {
        return headlineOf(sharedPushDeviation(own, right))
               == utf8("In the rebound the two shares are exchanged");
    };
    QCOMPARE(exchanged(), told);
    std::swap(own.radii, own.densities);
    std::swap(right.radii, right.densities);
    QCOMPARE(exchanged(), told);
    own.radii.push_back(own.radii.front());
    right.radii.push_back(right.radii.front());
    QCOMPARE(exchanged(), told);
    own.radii.back() = right.radii.back();
    QVERIFY(!exchanged());
    own.radii.back().answered = false;
    QVERIFY(!exchanged());
    own.radii.front().answered = false;
    QVERIFY(!exchanged());
}

void TestSharedPush::ratioThatHangsOnEIsTold_data()
{
    QTest::addColumn<double>("ratio"); // m₂/m₁ of the pushes with e = 0.5, of that with e = 1
    QTest::addColumn<bool>("told");
    QTest::newRow("the same") << 1.0 << false;
    QTest::newRow("nearly") << 1.04 << false;
    QTest::newRow("more") << 1.06 << true;
    QTest::newRow("nearly, less") << 0.965 << false;
    QTest::newRow("less") << 0.94 << true;
}

void TestSharedPush::ratioThatHangsOnEIsTold()
{
    QFETCH(double, ratio);
    QFETCH(bool, told);
    MeasuredPair right = ofBalls();
    right.densities = {hitOfUnlike({0.2, 0.2}, {2.0, 6.0}, 3.0, 1.0, 1.0),
                       hitOfUnlike({0.2, 0.2}, {6.0, 2.0}, 3.0, 1.0, 1.0),
                       hitOfUnlike({0.2, 0.2}, {2.0, 6.0}, 3.0, 1.0, 0.5)};
    MeasuredPair own = right;
    // With 2 and 6 both velocities are wrong where e is 1, and of another ratio where it is less.
    own.densities[0].left1 = own.densities[0].came1 - 2.0 * normal;
    own.densities[0].left2 = own.densities[0].came2 + 1.0 * normal;
    own.densities[2].left1 = own.densities[2].came1 - 2.0 * ratio * normal;
    own.densities[2].left2 = own.densities[2].came2 + 1.0 * normal;
    const QString headline = utf8("Where the masses differ, the total momentum is not kept");
    const auto found = sharedPushDeviation(own, right);
    QCOMPARE(headlineOf(found), told ? headline : QString());
    if (found)
        QVERIFY2(found->message.contains(
                     utf8("With ρ₁ = 2 and ρ₂ = 6 the change of v₁ was 2 times that of v₂ where e "
                          "is 1, and %1 times where it is 0.5; m₂/m₁ = 3 is right")
                         .arg(brief(2.0 * ratio))),
                 qPrintable(found->message));
    // Equal circles come out wrong with that e, too: another law.
    right.rebounds = {hitOfMasses(1.0, 1.0, 0.5)};
    own.rebounds = right.rebounds;
    const double sum =
        length(right.rebounds[0].left1) + length(right.rebounds[0].left2); // m/s, of both
    own.rebounds[0].left1 += 0.009 * sum * normal;
    QCOMPARE(sharedPushDeviation(own, right).has_value(), told);
    own.rebounds[0].left1 += 0.002 * sum * normal;
    QVERIFY(!sharedPushDeviation(own, right));
}

/// From three times on: a long step blurs what is less.
void TestSharedPush::sizeThatHangsOnTheTimestepIsTold()
{
    const auto pushed = [](double factor) {
        return hitThatLeaves({1.2 - 1.5 * factor, 0.4, -0.3 + 1.5 * factor, 0.1});
    };
    MeasuredPair right = noHits();
    right.equals = right.contacts = {pushed(1.0)};
    MeasuredPair own = right;
    own.equals = {pushed(0.5)};
    const auto headline = [&](double inStep) {
        own.contacts = {pushed(inStep)};
        return sizeOfPush(own, right, own.equals[0], right.equals[0]).headline;
    };
    const QString depends = utf8("The push has a wrong size that depends on the timestep");
    const QString half = utf8("Equal circles get 0.5 times the right push");
    QCOMPARE(headline(0.5), half);
    QCOMPARE(headline(1.48), half);
    QCOMPARE(headline(1.52), depends);
    QCOMPARE(headline(0.17), half);
    QCOMPARE(headline(0.16), depends);
    own.contacts.clear();
    // With another e another factor.
    right.rebounds = {hitOfMasses(1.0, 1.0, 0.5)};
    const auto isOfEveryE = [&](double factor) {
        own.rebounds = {
            hitThatLeaves({1.2 - 1.125 * factor, 0.4, -0.3 + 1.125 * factor, 0.1}, 0.5)};
        return sizeOfPush(own, right, own.equals[0], right.equals[0]).isOfEveryE;
    };
    QVERIFY(isOfEveryE(0.5) && isOfEveryE(0.514));
    QVERIFY(!isOfEveryE(0.516) && !isOfEveryE(0.48));
}

/// Below two thousandths of the speed, here of 1.26 m/s, a part is the one that is known.
void TestSharedPush::noiseIsNoPartOfAHit()
{
    const PairHit right = hitThatLeaves({-0.3, 0.4, 1.2, 0.1});
    const auto told = [&](double off) {
        return describeHit(hitThatLeaves({-0.3 + off, 0.4, 1.2, 0.1}), right);
    };
    QVERIFY(told(2.4e-3).contains(utf8("they left with -0.3 and 1.2; -0.3 and 1.2 are right")));
    QVERIFY(told(2.6e-3).contains(utf8("they left with -0.297 and 1.2; -0.3 and 1.2 are right")));
    const PairHit askew = hitThatLeaves({-0.3, 0.2, 1.2, 0.1});
    QVERIFY(describeHit(askew, right).startsWith(utf8("Across the line of centres")));
    QVERIFY(!describeHit(askew, right).contains(utf8("Along")));
    QVERIFY(describeHit(askew, right, true).startsWith(utf8("Along the line of centres")));
    QVERIFY(!describeHit(askew, right, true).contains(utf8("Across")));
}

QTEST_GUILESS_MAIN(TestSharedPush)
#include "test_shared_push.moc"
