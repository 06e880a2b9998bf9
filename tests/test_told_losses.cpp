// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/condition_words.h"

using namespace cradle;
using namespace cradle::programs;

/// What is found of hits with one e, or that come in one way, is told of no others.
class TestToldLosses : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void restitutionIsToldOfSome_data();
    void restitutionIsToldOfSome();
    void restitutionIsToldOfAll_data();
    void restitutionIsToldOfAll();
    void massesAreToldOfTheirE();
    void massesAreToldBesideRestitution_data();
    void massesAreToldBesideRestitution();
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

/// A hit that is answered as with the factor \p k in place of e.
HitLaw withFactor(const char *k)
{
    return {.e = text("restitution"),
            .answer = text("local k = %1 local j = (1 + k) * closing / (1 / m1 + 1 / m2) "
                           "p.velocity = p.velocity - j / m1 * n "
                           "q.velocity = q.velocity + j / m2 * n")
                          .arg(text(k))};
}

/// What is said in step 16 of the response of a program with that hit.
std::vector<LawDeviation> toldIn(const Task &task, const HitLaw &law)
{
    const LawBench bench(task);
    const QString program =
        written({.walls = wallsOf(wallWays[1], "c.radius", "1"), .hit = hitOf(hitWays[1], law)},
                structures[1]);
    const MeasuredLaws own(&program, bench.ground);
    return conditioned(Aspect::Response,
                       responseDeviations(own.pair(), bench.right.pair(), bench.ground), own,
                       bench.right, bench.ground, {})
        .deviations;
}

QString headlineOf(const LawDeviation &one)
{
    return one.message.section(QLatin1Char('\n'), 0, 0);
}

} // namespace

void TestToldLosses::restitutionIsToldOfSome_data()
{
    QTest::addColumn<QByteArray>("factor");
    QTest::addColumn<QString>("those");
    const auto row = [](const char *name, const char *factor, const char *those) {
        QTest::addRow("%s", name) << QByteArray(factor) << text(those);
    };
    row("squared where they are slow", "closing > 2 and e or e ^ 2", " m/s or more, ");
    row("elastic where they are slow", "closing > 2 and e or 1", " m/s or more, ");
    row("a number on one side", "d.x < 0 and e or 0.3", "circle 2 is to the left of circle 1");
}

/// All that are thrown with a velocity and along a line come out wrong, others do not.
void TestToldLosses::restitutionIsToldOfSome()
{
    QFETCH(QByteArray, factor);
    QFETCH(QString, those);
    const auto found = toldIn(task(text("L42T16")), withFactor(factor.constData()));
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(headlineOf(found.front()), text("Some hits of the two circles come out wrong"));
    QVERIFY(found.front().isConditional);
    QVERIFY2(found.front().message.contains(those), qPrintable(found.front().message));
}

void TestToldLosses::restitutionIsToldOfAll_data()
{
    QTest::addColumn<QByteArray>("answer");
    QTest::addColumn<QString>("headline");
    const auto row = [](const char *name, const char *answer, const char *headline) {
        QTest::addRow("%s", name) << QByteArray(answer) << text(headline);
    };
    row("whole velocities",
        "local j = 2 * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = e * (p.velocity - j / m1 * n), e * (q.velocity + j / m2 * n)",
        "e multiplies the whole velocities after the hit");
    row("across, too",
        "local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
        "local u, w = p.velocity:dot(n), q.velocity:dot(n) "
        "p.velocity, q.velocity = e * p.velocity + (1 - e) * u * n - j / m1 * n, "
        "e * q.velocity + (1 - e) * w * n + j / m2 * n",
        "e also shortens the parts across the line of centres");
    row("the heavier one alone",
        "local one, two = m1 > m2 and e or 1, m2 > m1 and e or 1 "
        "local j = closing / (1 / m1 + 1 / m2) "
        "p.velocity = p.velocity - (1 + one) * j / m1 * n "
        "q.velocity = q.velocity + (1 + two) * j / m2 * n",
        "e changes nothing in the hits tried (equal circles)");
    row("the whole push",
        "local j = e * (1 + e) * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "The push is multiplied by e (1 + e) instead of 1 + e");
    row("one more",
        "local j = (2 + e) * closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - j / m1 * n, q.velocity + j / m2 * n",
        "The push is multiplied by 2 + e instead of 1 + e");
    row("one circle alone",
        "local j = closing / (1 / m1 + 1 / m2) "
        "p.velocity, q.velocity = p.velocity - (1 + e) * j / m1 * n, q.velocity + 2 * j / m2 * n",
        "Along the normal only circle 1 feels e");
}

/// With opposite momenta, or nothing across, what is wrong does not show: that is no exception.
void TestToldLosses::restitutionIsToldOfAll()
{
    QFETCH(QByteArray, answer);
    QFETCH(QString, headline);
    const auto found = toldIn(task(text("L42T16")),
                              {.e = text("restitution"), .answer = text(answer.constData())});
    QVERIFY(!found.empty());
    QCOMPARE(headlineOf(found.front()), headline);
}

/// With e = 1 equal masses, with less those of the circles.
void TestToldLosses::massesAreToldOfTheirE()
{
    const auto found = toldIn(task(text("L42T16")),
                              {.e = text("restitution"),
                               .answer = text("if e == 1 then m1, m2 = 1, 1 end "
                                              "local j = (1 + e) * closing / (1 / m1 + 1 / m2) "
                                              "p.velocity = p.velocity - j / m1 * n "
                                              "q.velocity = q.velocity + j / m2 * n")});
    QVERIFY(!found.empty());
    for (const LawDeviation &one : found)
        QVERIFY2(headlineOf(one).endsWith(text(" (with e = 1)")), qPrintable(one.message));
}

void TestToldLosses::massesAreToldBesideRestitution_data()
{
    QTest::addColumn<QString>("mass");
    QTest::addColumn<QByteArray>("factor");
    QTest::addColumn<QStringList>("headlines");
    const auto row = [](const char *name, const char *mass, const char *factor,
                        std::initializer_list<const char *> headlines) {
        QStringList all;
        for (const char *headline : headlines)
            all.append(text(headline));
        QTest::addRow("%s", name) << text(mass) << QByteArray(factor) << all;
    };
    row("exchanged, e twice", "1 / (c.density * c.radius ^ 3)", "2 * e",
        {"Each circle answers as if it had the mass of the other",
         "The push is multiplied by 1 + 2 e instead of 1 + e"});
    row("of discs, half of e", "c.density * c.radius ^ 2", "e / 2",
        {"The mass grows with r to the power of 2, not 3",
         "The push is multiplied by 1 + 0.5 e instead of 1 + e"});
    row("of discs, e squared", "c.density * c.radius ^ 2", "e ^ 2",
        {"The mass grows with r to the power of 2, not 3",
         "e is squared in the hit of two circles"});
}

/// A push that is wrong with e = 1, too, tells the masses that share it none the less.
void TestToldLosses::massesAreToldBesideRestitution()
{
    QFETCH(QString, mass);
    QFETCH(QByteArray, factor);
    QFETCH(QStringList, headlines);
    HitLaw law = withFactor(factor.constData());
    law.mass = mass;
    QStringList all;
    for (const LawDeviation &one : toldIn(task(text("L42T16")), law))
        all.append(headlineOf(one));
    QCOMPARE(all, headlines);
}

QTEST_GUILESS_MAIN(TestToldLosses)
#include "test_told_losses.moc"
