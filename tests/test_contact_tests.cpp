// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/contact_tests.h"

#include <QTest>

using namespace cradle;

/// The tests of contact that a wrong one is compared with, and at which distance each answers:
/// radii of 0.3 m and 0.2 m, whose line of centres lies along (0.8, −0.6) and then along (0.96,
/// −0.28).
class TestContactTests : public QObject
{
    Q_OBJECT
private slots:
    void distancesAreAsTold_data();
    void distancesAreAsTold();
};

namespace {

PairHit hit()
{
    PairHit hit;
    hit.meeting.radius1 = 0.3;
    hit.meeting.radius2 = 0.2;
    hit.normal = {0.8, -0.6};
    hit.nextNormal = {0.96, -0.28};
    return hit;
}

} // namespace

void TestContactTests::distancesAreAsTold_data()
{
    QTest::addColumn<QString>("headline");
    QTest::addColumn<double>("distance"); // m
    const auto row = [](const char *headline, double distance) {
        QTest::newRow(headline) << QString::fromUtf8(headline) << distance;
    };
    row("The circles answer only when their centres have met", 0.0);
    // The larger part of the line is 0.8 and 0.96, the sum of both 1.4 and 1.24.
    row("Boxes are compared, not circles", 0.625);
    row("|Δx| + |Δy| is not the distance", 0.5 / 1.24);
    row("A squared distance is compared with a length", std::sqrt(0.5));
    row("Only half of r₁ + r₂ counts in the test of contact", 0.25);
    const auto at = [&](const char *what, double distance) {
        row(QStringLiteral("Contact is tested at %1, not at r₁ + r₂")
                .arg(QString::fromUtf8(what))
                .toUtf8()
                .constData(),
            distance);
    };
    at("2 r₁", 0.6);
    at("2 r₂", 0.4);
    at("r₁", 0.3);
    at("r₂", 0.2);
    at("the larger radius", 0.3);
    at("the smaller radius", 0.2);
    at("twice the smaller radius", 0.4);
    at("the difference of the radii", 0.1);
    at("twice the larger radius", 0.6);
    at("the sum of the diameters", 1.0);
}

void TestContactTests::distancesAreAsTold()
{
    QFETCH(QString, headline);
    QFETCH(double, distance);
    int told = 0;
    for (const ContactTest &test : contactTests()) {
        if (test.headline != headline)
            continue;
        ++told;
        QVERIFY(std::abs(test.distance(hit()) - distance) < 1e-12);
    }
    QCOMPARE(told, 1);
}

QTEST_APPLESS_MAIN(TestContactTests)
#include "test_contact_tests.moc"
