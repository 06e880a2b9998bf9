// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/told_numbers.h"

#include "tasks/judging/pair_words.h"
#include "tasks/judging/response_law_words.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is told of the size of a push holds for circles and timesteps that were tried.
class TestPushSize : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void stepThatItDependsOnIsTold_data();
    void stepThatItDependsOnIsTold();
    void whatItDependsOnIsTold_data();
    void whatItDependsOnIsTold();
    void otherLineIsNoDepth();
    void factorOfTheRadiusIsTold();
    void roundedPushIsTold();
    void partsOfOneCircleAreTold_data();
    void partsOfOneCircleAreTold();

private:
    static QString programOf(const QString &step, const QString &answer)
    {
        const HitLaw law{.mass = step.mid(4).toInt() < 14 ? QStringLiteral("1") : HitLaw().mass,
                         .answer = answer};
        return written(withHit(hitOf(hitWays[0], law)), structures[3]);
    }
    [[nodiscard]] std::vector<LawDeviation> found(const QString &step, const QString &answer) const
    {
        const LawBench bench(task(step));
        const QString program = programOf(step, answer);
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
    // Too small for another size to stand out but by what it is of the first.
    QTest::addRow("tiny") << text("L42T14") << text("1e-4 * p.radius ^ 4")
                          << text("The push has a wrong size that depends on the radius");
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

/// Read from single steps of the usual length, in which the rims touch early or late, and from a
/// short one: worked by hand from 1.2 and −0.4 m/s, which come 0.027 m nearer in 1/60 s.
void TestPushSize::stepThatItDependsOnIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("answer");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<QString>("said");
    const QString timestep = text("The push has a wrong size that depends on the timestep");
    const QString depth = text("What a hit does depends on where in a step they touch");
    const auto push = [](const char *j) {
        return text("local j = %1 p.velocity = p.velocity - j / m1 * n "
                    "q.velocity = q.velocity + j / m2 * n")
            .arg(text(j));
    };
    QTest::newRow("e times the timestep")
        << text("L42T16") << push("(1 + e * h) * closing / (1 / m1 + 1 / m2)") << timestep
        << text("became 0.387 and 0.413 m/s with a timestep of 1/60 s, and 0.4 and 0.4 m/s with "
                "1/10000 s");
    QTest::newRow("right with one timestep alone")
        << text("L42T16") << push("(1 + e * h * 60) * closing / (1 / m1 + 1 / m2)") << timestep
        << text("became -0.4 and 1.2 m/s with a timestep of 1/60 s, and 0.395 and 0.405 m/s with "
                "1/10000 s");
    QTest::newRow("one circle alone")
        << text("L42T12") << text("p.velocity = p.velocity - closing * h * n")
        << text("What a hit does depends on the timestep")
        << text("became 1.17 and -0.4 m/s with a timestep of 1/60 s, and 1.2 and -0.4 m/s with "
                "1/10000 s");
    QTest::newRow("the overlap over the timestep")
        << text("L42T12") << push("(reach - d:length()) / h") << depth
        << text("left with 0 and 0.8 m/s; where after two thirds, with 0.667 and 0.133 m/s");
    QTest::newRow("the overlap beside the exchange")
        << text("L42T12") << push("closing + 3 * (reach - d:length())") << depth
        << text("left with -0.46 and 1.26 m/s; where after two thirds, with -0.427 and 1.23 m/s");
}

void TestPushSize::stepThatItDependsOnIsTold()
{
    QFETCH(QString, step);
    QFETCH(QString, answer);
    QFETCH(QString, headline);
    QFETCH(QString, said);
    const LawBench bench(task(step));
    const QString program = programOf(step, answer);
    const MeasuredLaws own(&program, bench.ground);
    const auto told = steppedDeviation(own.pair(), bench.right.pair(), true);
    QVERIFY(told);
    QCOMPARE(LawBench::headlines({*told}), QStringList(headline));
    QVERIFY2(told->message.contains(said), qPrintable(told->message));
    // What is right in very short steps is no other law of theirs.
    const auto all = responseDeviations(own.pair(), bench.right.pair(), bench.ground);
    QVERIFY(all.empty() || LawBench::headlines(all) == QStringList(headline));
}

/// Of a normal whose y is not divided by its length: another line, which hangs on the place, too.
void TestPushSize::otherLineIsNoDepth()
{
    const QStringList said = LawBench::headlines(found(
        text("L42T12"), text("local m = vec(n.x, q.position.y - p.position.y) "
                             "local u = p.velocity:dot(m) - q.velocity:dot(m) "
                             "p.velocity = p.velocity - u * m q.velocity = q.velocity + u * m")));
    QVERIFY2(said.size() == 1 && said[0].startsWith(text("The push is not along the line")),
             qPrintable(said.join(u'|')));
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

void TestPushSize::roundedPushIsTold()
{
    const QString rounded = text("by whole numbers of m/s");
    for (const char *step : {"L42T12", "L42T14"}) {
        const QString said = bodyOf(found(text(step), text("local j = closing // 1 "
                                                           "p.velocity = p.velocity - j * n "
                                                           "q.velocity = q.velocity + j * n")),
                                    text("The push has the wrong size"));
        QVERIFY2(said.contains(rounded), qPrintable(said));
    }
    const QString other =
        bodyOf(found(text("L42T12"), pushOf("closing")), text("The push has the wrong size"));
    QVERIFY2(!other.isEmpty() && !other.contains(rounded), qPrintable(other));
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
