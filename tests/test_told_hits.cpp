// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/told_hit.h"

#include <cmath>
#include <functional>

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the hits of a program tell are those that its law makes.
class TestToldHits : public ToldHit
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void distanceOfAContactIsTold_data();
    void distanceOfAContactIsTold();
    void distanceIsNamedByTwoPairs_data();
    void distanceIsNamedByTwoPairs();
    void answerOfPartingsIsTold();
    void massOfOneInThePushIsTold_data();
    void massOfOneInThePushIsTold();
    void wholeVelocityTurnedRoundIsTold();
    void faultAcrossIsToldOnce();
    void sumOfThePlacesIsToldFarApart_data();
    void sumOfThePlacesIsToldFarApart();
    void reboundOfAHitIsTold_data();
    void reboundOfAHitIsTold();
    void pushOnOneAloneIsTold_data();
    void pushOnOneAloneIsTold();
    void wholeVelocityOfOneTimesEIsTold_data();
    void wholeVelocityOfOneTimesEIsTold();

private:
    using Law = std::function<double(double)>; ///< of e
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

const QString e = QStringLiteral("restitution");

} // namespace

void TestToldHits::distanceOfAContactIsTold_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<Vec2>("shares"); // of r₁ and r₂
    QTest::addColumn<double>("more"); // m
    QTest::newRow("r1") << "p.radius" << Vec2{1, 0} << 0.0;
    QTest::newRow("r2") << "q.radius" << Vec2{0, 1} << 0.0;
    QTest::newRow("half") << "(p.radius + q.radius) / 2" << Vec2{0.5, 0.5} << 0.0;
    QTest::newRow("farther") << "p.radius + q.radius + 0.06" << Vec2{1, 1} << 0.06;
    QTest::newRow("nearer") << "p.radius + q.radius - 0.06" << Vec2{1, 1} << -0.06;
    QTest::newRow("a number") << "0.55" << Vec2{0, 0} << 0.55;
}

void TestToldHits::distanceOfAContactIsTold()
{
    QFETCH(QString, reach);
    QFETCH(Vec2, shares);
    QFETCH(double, more);
    const QString body = bodyOf(foundOfHit({.reach = reach, .e = e}), {});
    const auto n = numbersIn(body, "With r₁ = # m and r₂ = # m, met at #°, they answered when "
                                   "their centres were between # and # m apart.");
    QVERIFY2(n.size() == 5, qPrintable(body));
    QVERIFY(n[0] != n[1] || more == 0.55); // it shows whose radius counts
    const double place = shares.x * n[0] + shares.y * n[1] + more;
    QVERIFY(n[3] <= place + 1e-3 && place - 1e-3 <= n[4]);
    QVERIFY(n[4] - n[3] > 0.005 && n[4] - n[3] < 0.04);
    const auto touching =
        numbersIn(body, "Rims touch where the centres are r₁ + r₂ apart, here # m.");
    if (more != 0.55) {
        QCOMPARE(touching.size(), std::size_t{1});
        QVERIFY(isNear(touching[0], n[0] + n[1]));
    } else {
        const auto same = numbersIn(body, "between # and # m.");
        QCOMPARE(same.size(), std::size_t{2});
        QVERIFY(same[0] <= 0.5501 && 0.5499 <= same[1] && same[1] - same[0] < 0.04);
    }
}

void TestToldHits::distanceIsNamedByTwoPairs_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<QString>("headline");
    QTest::newRow("difference") << "q.radius - p.radius"
                                << text("Contact is tested at r₂ − r₁, not at r₁ + r₂");
    QTest::newRow("either") << "math.abs(q.radius - p.radius)"
                            << text("Contact is tested at the difference of the radii, not at r₁ + "
                                    "r₂");
    QTest::newRow("a number for r2")
        << "p.radius + 0.2" << text("The test of contact acts as if a number stood for r₂");
    QTest::newRow("a number for r1")
        << "0.2 + q.radius" << text("The test of contact acts as if a number stood for r₁");
    // With the two radii that are answered at all, this is half of their sum, too.
    QTest::newRow("by chance") << "2 * math.abs(p.radius - q.radius)"
                               << text("The circles are answered too late, or not at all");
}

void TestToldHits::distanceIsNamedByTwoPairs()
{
    QFETCH(QString, reach);
    QFETCH(QString, headline);
    const auto found = foundOfHit({.reach = reach, .e = e});
    QVERIFY2(!bodyOf(found, headline).isEmpty(),
             qPrintable(found.empty() ? QString() : found.front().message));
}

/// Who answers only circles that move apart shows how, and nothing else where that is right.
void TestToldHits::answerOfPartingsIsTold()
{
    const QString parting = text("The circles answer when they part, not when they meet");
    const auto found = foundOfHit({.approach = text("closing < 0"),
                                   .e = e,
                                   .answer = text("p.velocity, q.velocity = q.velocity, "
                                                  "p.velocity")});
    QVERIFY(!bodyOf(found, parting).isEmpty());
    const QString body = bodyOf(found, text("The circles exchange their whole velocities"));
    QVERIFY2(body.contains(text("Seen of circles that move apart")), qPrintable(body));
    const auto n = numbersIn(body, "circle 1 came with # m/s and circle 2 with # m/s; they left "
                                   "with # and #; # and # are right.");
    QVERIFY2(n.size() == 6, qPrintable(body));
    QVERIFY(isNear(n[2], n[1]) && isNear(n[3], n[0]));
    QVERIFY(isNear(n[4], n[0]) && isNear(n[5], n[1])); // across the line of centres
    QCOMPARE(foundOfHit({.approach = text("closing < 0"), .e = e}).size(), std::size_t{1});
}

void TestToldHits::massOfOneInThePushIsTold_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<QString>("circle");
    QTest::newRow("1") << "m1"
                       << "1";
    QTest::newRow("2") << "m2"
                       << "2";
}

void TestToldHits::massOfOneInThePushIsTold()
{
    QFETCH(QString, mass);
    QFETCH(QString, circle);
    const auto found = foundOfHit({.e = e,
                                   .answer = text("local j = (1 + e) * closing / (1 / %1 + 1 / %1) "
                                                  "p.velocity = p.velocity - j / m1 * n "
                                                  "q.velocity = q.velocity + j / m2 * n")
                                                 .arg(mass)});
    const QString body = bodyOf(
        found, text("The size of the push hangs on the mass of circle %1 alone").arg(circle));
    const auto n = numbersIn(body, "With r₁ = # and r₂ = # m: Along the line of centres, from 1 to "
                                   "2, circle 1 came with # m/s and circle 2 with # m/s; they left "
                                   "with # and #; # and # are right.");
    QVERIFY2(n.size() == 8, qPrintable(found.empty() ? QString() : found.front().message));
    const double heavy = std::pow(n[1] / n[0], 3.0);
    const double times = 0.5 * (1.0 + (circle == QLatin1String("1") ? 1.0 / heavy : heavy));
    QVERIFY(std::abs((n[4] - n[2]) - times * (n[6] - n[2])) < 0.02 * times);
    QVERIFY(std::abs((n[5] - n[3]) - times * (n[7] - n[3])) < 0.02 * times);
}

void TestToldHits::wholeVelocityTurnedRoundIsTold()
{
    const auto found = foundOfHit(
        {.e = e,
         .answer = text("local m = (m1 * p.velocity + m2 * q.velocity) / (m1 + m2) "
                        "p.velocity, q.velocity = m - e * (p.velocity - m), m - e * (q.velocity - "
                        "m)")});
    QVERIFY(!bodyOf(found, text("The whole relative velocity is turned round")).isEmpty());
    QCOMPARE(found.size(), std::size_t{1});
}

/// Of two faults the numbers of one stand below its own headline alone.
void TestToldHits::faultAcrossIsToldOnce()
{
    const auto found =
        foundOfHit({.e = e,
                    .answer = QStringLiteral("local j = (1 + e ^ 2) * closing / (1 / m1 + 1 / m2) "
                                             "local u, w = p.velocity:dot(n), q.velocity:dot(n) "
                                             "p.velocity = e * p.velocity + (1 - e) * u * n "
                                             "q.velocity = e * q.velocity + (1 - e) * w * n "
                                             "p.velocity = p.velocity - j / m1 * n "
                                             "q.velocity = q.velocity + j / m2 * n")});
    const QString across = text("Across the line of centres circle 1 came");
    QVERIFY(bodyOf(found, text("e also shortens the parts across")).contains(across));
    const QString squared = bodyOf(found, text("e is squared in the hit of two circles"));
    QVERIFY2(squared.contains(text("they left with")) && !squared.contains(across),
             qPrintable(squared));
}

void TestToldHits::sumOfThePlacesIsToldFarApart_data()
{
    QTest::addColumn<QString>("normal");
    QTest::newRow("for contact") << "d:normalized()";
    QTest::newRow("for the normal, too") << "(p.position + q.position):normalized()";
}

/// Opposite each other about the origin the sum of two places is small.
void TestToldHits::sumOfThePlacesIsToldFarApart()
{
    QFETCH(QString, normal);
    const QString body =
        bodyOf(foundOfHit({.touch = QStringLiteral("(p.position + q.position):length() < reach"),
                           .approach = QStringLiteral("true"),
                           .normal = normal,
                           .e = e}),
               text("The circles are answered far apart, not where they touch"));
    const auto n = numbersIn(body, "At (#, #) and (#, #) m, opposite each other about the middle "
                                   "of the square, they were answered with their centres # m");
    QVERIFY2(n.size() == 5, qPrintable(body));
    QVERIFY(std::hypot(n[0] + n[2], n[1] + n[3]) < 0.4);
    QVERIFY(isNear(n[4], std::hypot(n[0] - n[2], n[1] - n[3])));
}

void TestToldHits::reboundOfAHitIsTold_data()
{
    QTest::addColumn<QString>("given"); // in place of e
    QTest::addColumn<QString>("headline");
    QTest::addColumn<Law>("law");
    const auto row = [](const char *name, const char *headline, const Law &law) {
        QTest::newRow(name) << text(name) << text(headline) << law;
    };
    row("restitution ^ 2", "", [](double r) { return r * r; });
    row("1 - restitution", "", [](double r) { return 1.0 - r; });
    row("0.6", "A number stands for e in the hit of two circles", [](double) { return 0.6; });
    row("1", "", [](double) { return 1.0; });
    row("-restitution", "The sign of e is wrong in the hit of two circles",
        [](double r) { return -r; });
}

/// Of two equal circles, at an e with which it comes out wrong.
void TestToldHits::reboundOfAHitIsTold()
{
    QFETCH(QString, given);
    QFETCH(QString, headline);
    QFETCH(Law, law);
    const auto all = foundOfHit({.e = given});
    QString body;
    for (const LawDeviation &each : all) {
        if (each.topic == Topic::Restitution)
            body = each.message;
    }
    QVERIFY2(body.startsWith(headline), qPrintable(body));
    const auto n =
        numbersIn(body, "With e = #: Along the line of centres, from 1 to 2, circle 1 came "
                        "with # m/s and circle 2 with # m/s; they left with # and #; # and # "
                        "are right.");
    QVERIFY2(n.size() == 7, qPrintable(body));
    const double closing = n[1] - n[2];
    QVERIFY(closing > 0.5);
    const auto isTold = [&](std::size_t at, double r) {
        const double push = 0.5 * (1.0 + r) * closing;
        return std::abs(n[at] - (n[1] - push)) < 0.02 && std::abs(n[at + 1] - (n[2] + push)) < 0.02;
    };
    QVERIFY2(isTold(3, law(n[0])), qPrintable(body));
    QVERIFY2(isTold(5, n[0]), qPrintable(body));
    // What they have across that line stays, and nothing is said of it.
    QVERIFY2(!body.contains(QLatin1String("Across")), qPrintable(body));
    QVERIFY(std::abs(law(n[0]) - n[0]) > 0.1);
}

void TestToldHits::pushOnOneAloneIsTold_data()
{
    QTest::addColumn<QString>("one"); // whose mass each is pushed with
    QTest::addColumn<QString>("two");
    QTest::addColumn<int>("right");
    QTest::newRow("circle 2 wrong") << "m1"
                                    << "m1" << 1;
    QTest::newRow("circle 1 wrong") << "m2"
                                    << "m2" << 2;
}

/// With the mass of the other, which shows where that is another.
void TestToldHits::pushOnOneAloneIsTold()
{
    QFETCH(QString, one);
    QFETCH(QString, two);
    QFETCH(int, right);
    const HitLaw law{.e = e,
                     .answer = QStringLiteral("local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
                                              "p.velocity = p.velocity - j / %1 * n "
                                              "q.velocity = q.velocity + j / %2 * n")
                                   .arg(one, two)};
    const QString body =
        bodyOf(foundOfHit(law), QStringLiteral("Where the masses differ, only circle %1 leaves as "
                                               "it should")
                                    .arg(right));
    const auto n =
        numbersIn(body, "circle 1 came with # m/s and circle 2 with # m/s; they left with # "
                        "and #; # and # are right.");
    QVERIFY2(n.size() == 6, qPrintable(body));
    // Elastic: they should part as fast as they came. The one that is right is told so.
    QVERIFY(std::abs((n[5] - n[4]) - (n[0] - n[1])) < 0.02);
    QCOMPARE(std::abs(n[2] - n[4]) < 0.02, right == 1);
    QCOMPARE(std::abs(n[3] - n[5]) < 0.02, right == 2);
    // The wrong one gets the push of the right one.
    QVERIFY(std::abs((n[0] - n[2]) - (n[3] - n[1])) < 0.02);
}

void TestToldHits::wholeVelocityOfOneTimesEIsTold_data()
{
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    const auto row = [](const char *name, const char *factor, const char *answer,
                        const char *headline) {
        QTest::newRow(name) << text("local j = (1 + ") + text(factor)
                                   + text(") * closing / (1 / m1 + 1 / m2) ") + text(answer)
                            << text(headline);
    };
    row("circle 1", "e",
        "p.velocity = e * (p.velocity - j / m1 * n) q.velocity = q.velocity + j / m2 * n",
        "e multiplies the whole velocity of circle 1 after the hit");
    row("circle 2, elastic", "1",
        "p.velocity = p.velocity - j / m1 * n q.velocity = e * (q.velocity + j / m2 * n)",
        "e multiplies the whole velocity of circle 2 after the hit");
    row("across alone", "e",
        "p.velocity = p.velocity - j / m1 * n "
        "p.velocity = p.velocity:dot(n) * n + e * (p.velocity - p.velocity:dot(n) * n) "
        "q.velocity = q.velocity + j / m2 * n",
        "e also shortens the part of circle 1 across the line of centres");
}

void TestToldHits::wholeVelocityOfOneTimesEIsTold()
{
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    const auto found = foundOfHit({.e = e, .answer = answer});
    QVERIFY(!found.empty());
    QCOMPARE(found.front().message.section(QLatin1Char('\n'), 0, 0), headline);
}

QTEST_GUILESS_MAIN(TestToldHits)
#include "test_told_hits.moc"
