// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/pair_words.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is told of the size of a push holds for circles and timesteps that were tried.
class TestPushSize : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void whatItDependsOnIsTold_data();
    void whatItDependsOnIsTold();
    void factorOfTheRadiusIsTold();
    void partsOfOneCircleAreTold_data();
    void partsOfOneCircleAreTold();

private:
    [[nodiscard]] std::vector<LawDeviation> found(const QString &step, const QString &answer) const
    {
        const LawBench bench(task(step));
        const HitLaw law{.mass = step.mid(4).toInt() < 14 ? QStringLiteral("1") : HitLaw().mass,
                         .answer = answer};
        const QString program = written(withHit(hitOf(hitWays[0], law)), structures[3]);
        const MeasuredLaws own(&program, bench.ground);
        return responseDeviations(own.pair(), bench.right.pair(), bench.ground);
    }
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

QString pushOf(const char *factor)
{
    return text("local j = 2 * closing / (1 / m1 + 1 / m2) * %1 "
                "p.velocity = p.velocity - j / m1 * n q.velocity = q.velocity + j / m2 * n")
        .arg(text(factor));
}

} // namespace

void TestPushSize::whatItDependsOnIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("factor");
    QTest::addColumn<QString>("headline");
    for (const char *step : {"L42T12", "L42T14", "L42T15"}) {
        const auto row = [&](const char *factor, const char *headline) {
            QTest::addRow("%s, %s", step, factor) << text(step) << text(factor) << text(headline);
        };
        row("0.7", "Equal circles get 0.7 times the right push");
        row("p.radius * 3", "The push has a wrong size that depends on the radius");
        row("h * 60 * 0.7", "The push has a wrong size that depends on the timestep");
    }
    QTest::addRow("density") << text("L42T15") << text("p.density / 8")
                             << text("The push has a wrong size that depends on the circles");
    QTest::addRow("speed") << text("L42T12") << text("closing")
                           << text("The push has the wrong size");
}

void TestPushSize::whatItDependsOnIsTold()
{
    QFETCH(QString, step);
    QFETCH(QString, factor);
    QFETCH(QString, headline);
    const QStringList said = LawBench::headlines(found(step, pushOf(factor.toUtf8().constData())));
    QCOMPARE(said, QStringList(headline));
}

void TestPushSize::factorOfTheRadiusIsTold()
{
    for (const char *step : {"L42T12", "L42T14"}) {
        const QString said = bodyOf(found(text(step), pushOf("p.radius * 3")), text("The push"));
        const auto n = numbersIn(said, "With r = # m for both the push is # times as large as it "
                                       "should be, with r = # m it is # times.");
        QVERIFY2(n.size() == 4, qPrintable(said));
        QVERIFY(n[0] < n[2]);
        QVERIFY(isNear(n[1], 3.0 * n[0]) && isNear(n[3], 3.0 * n[2]));
    }
}

void TestPushSize::partsOfOneCircleAreTold_data()
{
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<std::vector<double>>("parts");
    const QString one = text("Only circle 2 leaves a hit as it should");
    const QString two = text("Only circle 1 leaves a hit as it should");
    QTest::newRow("nothing for it")
        << text("local a = p.velocity:dot(n) p.velocity = p.velocity - a * n "
                "q.velocity = q.velocity + closing * n")
        << one << std::vector<double>{1, 0, 0, 0, 1};
    QTest::newRow("half of it") << text(
        "p.velocity = p.velocity - closing * n q.velocity = q.velocity + closing / 2 * n")
                                << two << std::vector<double>{2, 0.5, 0.5, 1, 0};
    // What is made of x and y is no law of the line of centres.
    QTest::newRow("x alone") << text("p.velocity = p.velocity - closing * n "
                                     "q.velocity = q.velocity + closing * vec(n.x, 0)")
                             << two << std::vector<double>{};
}

void TestPushSize::partsOfOneCircleAreTold()
{
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    QFETCH(std::vector<double>, parts);
    const auto all = found(text("L42T12"), answer);
    QCOMPARE(LawBench::headlines(all), QStringList(headline));
    QCOMPARE(numbersIn(bodyOf(all, headline),
                       "In all these hits the new part of circle # along that line was # times "
                       "that of circle 1 before the hit and # times that of circle 2; right is # "
                       "and # times."),
             parts);
}

QTEST_GUILESS_MAIN(TestPushSize)
#include "test_push_size.moc"
