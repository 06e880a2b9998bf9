// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/pair_words.h"

#include "tests/told_hit.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings on the masses in a hit tell are those that its law makes.
class TestToldMasses : public ToldHit
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void massesOfAHitAreTold_data();
    void massesOfAHitAreTold();
    void massesThatAreExchangedAndWrongAreToldApart();
    void massesAreToldBesideAnotherFault_data();
    void massesAreToldBesideAnotherFault();
};

namespace {

const QString e = QStringLiteral("restitution");

} // namespace

void TestToldMasses::massesOfAHitAreTold_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<double>("radius"); // exponents
    QTest::addColumn<double>("density");
    QTest::newRow("discs") << "c.density * c.radius ^ 2" << 2.0 << 1.0;
    QTest::newRow("no density") << "c.radius ^ 3" << 3.0 << 0.0;
    QTest::newRow("no radius") << "c.density" << 0.0 << 1.0;
    QTest::newRow("root of the density") << "c.density ^ 0.5 * c.radius ^ 3" << 3.0 << 0.5;
    QTest::newRow("exchanged") << "1 / (c.density * c.radius ^ 3)" << -3.0 << -1.0;
    QTest::newRow("none") << "1" << 0.0 << 0.0;
}

void TestToldMasses::massesOfAHitAreTold()
{
    QFETCH(QString, mass);
    QFETCH(double, radius);
    QFETCH(double, density);
    const QString body = bodyOf(foundOfHit({.mass = mass, .e = e}), {});
    const auto n = numbersIn(body, "With r₁ = # and r₂ = # m, ρ₁ = # and ρ₂ = # (e = #), the "
                                   "change of v₁ was # times that of v₂; m₂/m₁ = # is right.");
    QVERIFY2(n.size() == 7, qPrintable(body));
    const double radii = n[1] / n[0];
    const double densities = n[3] / n[2];
    QVERIFY(isNear(n[5], std::pow(radii, radius) * std::pow(densities, density)));
    QVERIFY(isNear(n[6], std::pow(radii, 3.0) * densities));
    QVERIFY(!isNear(n[5], n[6]));
}

/// Two faults make the ratio of the masses: what each makes of it has its own number.
void TestToldMasses::massesThatAreExchangedAndWrongAreToldApart()
{
    const auto found =
        foundOfHit({.mass = QStringLiteral("1 / (c.density * c.radius ^ 2)"), .e = e});
    const QString exchanged =
        bodyOf(found, QStringLiteral("Each circle answers as if it had the mass of the other"));
    const auto one = numbersIn(exchanged, "With r₁ = # and r₂ = # m, ρ₁ = # and ρ₂ = # (e = #), "
                                          "the change of v₁ was # times that of v₂");
    const QString body = bodyOf(found, QStringLiteral("The mass grows with r to the power of 2"));
    const auto two =
        numbersIn(body, "With r₁ = # and r₂ = # m, ρ₁ = # and ρ₂ = # (e = #) the masses, whichever "
                        "stands where, are as 1 to #; 1 to # is right.");
    QVERIFY2(one.size() == 6 && two.size() == 7, qPrintable(exchanged + body));
    const double radii = two[1] / two[0];
    QVERIFY(isNear(one[5], std::pow(radii, -2.0)));
    QVERIFY(isNear(two[5], std::pow(radii, 2.0)));
    QVERIFY(isNear(two[6], std::pow(radii, 3.0)));
}

void TestToldMasses::massesAreToldBesideAnotherFault_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<int>("circle"); // that tells; 0: nothing is said of masses
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("density"); // exponents
    const QString disc = QStringLiteral("c.density * c.radius ^ 2");
    const QString half = QStringLiteral("p.velocity = p.velocity - 0.5 * j / m1 * n "
                                        "q.velocity = q.velocity + j / m2 * n");
    QTest::newRow("half a push") << disc << half << "The mass grows with r to the power of 2" << 2
                                 << 2.0 << 1.0;
    QTest::newRow("a part across lost")
        << disc
        << QStringLiteral("p.velocity = p.velocity - j / m1 * n "
                          "q.velocity = (q.velocity:dot(n) + j / m2) * n")
        << "The mass grows with r to the power of 2" << 1 << 2.0 << 1.0;
    QTest::newRow("masses exchanged")
        << "1 / (c.density * c.radius ^ 3)" << half
        << "Circle 2 answers as if it had the mass of the other" << 2 << -3.0 << -1.0;
    QTest::newRow("right masses") << "c.density * c.radius ^ 3" << half << "" << 0 << 3.0 << 1.0;
    QTest::newRow("neither tells") << disc
                                   << QStringLiteral("p.velocity = p.velocity - 0.5 * j / m1 * n "
                                                     "q.velocity = q.velocity + 0.7 * j / m2 * n")
                                   << "" << 0 << 2.0 << 1.0;
}

void TestToldMasses::massesAreToldBesideAnotherFault()
{
    QFETCH(QString, mass);
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    QFETCH(int, circle);
    QFETCH(double, radius);
    QFETCH(double, density);
    const auto found = foundOfHit(
        {.mass = mass,
         .e = e,
         .answer = QStringLiteral("local j = (1 + e) * closing / (1 / m1 + 1 / m2) ") + answer});
    if (circle == 0) {
        QVERIFY(std::none_of(found.begin(), found.end(), [](const LawDeviation &each) {
            return each.message.contains(QLatin1String("as if m"));
        }));
        return;
    }
    QVERIFY(found.size() > 1);
    const QString body = bodyOf(found, headline);
    const auto n = numbersIn(body, "With r₁ = # and r₂ = # m, ρ₁ = # and ρ₂ = # (e = #), circle # "
                                   "leaves as if m₂/m₁ were #; # is right.");
    QVERIFY2(n.size() == 8, qPrintable(body));
    QCOMPARE(n[5], double(circle));
    QVERIFY(isNear(n[6], std::pow(n[1] / n[0], radius) * std::pow(n[3] / n[2], density)));
    QVERIFY(isNear(n[7], std::pow(n[1] / n[0], 3.0) * n[3] / n[2]));
}

QTEST_GUILESS_MAIN(TestToldMasses)
#include "test_told_masses.moc"
