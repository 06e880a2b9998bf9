// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/own_wall_words.h"

#include "tasks/judging/judgement.h"
#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is said of walls that are right in every scene but the student's own.
class TestOwnWalls : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void copyOfEIsTold();
    void whatIsNoCopyIsNotCalledOne();
    void rightWallsAreNotBlamed();
    void copyOfARadiusIsTold_data();
    void copyOfARadiusIsTold();
    void otherRadiusIsNoCopy();

private:
    /// Of steps 13 and 14, with circle 2 in its own scene of another radius than before.
    [[nodiscard]] CheckReport reportOfRadius(const QString &step, const char *reach,
                                             const Structure &structure) const
    {
        const bool hasMasses = step == QLatin1String("L42T14");
        const LawProgram program{
            .start = QStringLiteral("kept = {} for i, c in ipairs(circles) do kept[i] = c.radius "
                                    "end gravity = vec(0, 0) ")
                     + (hasMasses ? QStringLiteral("circle1.position, circle1.velocity = "
                                                   "vec(-2.5, 2), vec(1, 0) "
                                                   "circle2.position, circle2.velocity = "
                                                   "vec(0, 2), vec(-1, 0) "
                                                   "circle1.radius, circle2.radius = 0.2, 0.252 "
                                                   "circle1.density, circle2.density = 7.8, 7.8 ")
                                  : QStringLiteral("circle1.position, circle1.velocity = "
                                                   "vec(-2, 2), vec(2, 0) "
                                                   "circle2.position, circle2.velocity = "
                                                   "vec(2, -2), vec(0, 2) "
                                                   "circle1.radius, circle2.radius = 0.2, 0.4 ")),
            .walls = wallsOf(wallWays[1], reach, "1"),
            .hit = hitOf(hitWays[0], {.mass = hasMasses ? HitLaw().mass : QStringLiteral("1")})};
        const Task &of = task(step);
        return *judgeTask(m_lab, of, Submission(of.preset, written(program, structure)), 1);
    }

    /// Of step 17, with its own scene.
    [[nodiscard]] CheckReport reportOf(const QString &start, const LawProgram &pieces,
                                       const Structure &structure) const
    {
        LawProgram program = pieces;
        program.start = start
                        + QStringLiteral("gravity = vec(0, -9.81) "
                                         "circle1.position, circle1.velocity = "
                                         "vec(-2.5, 2), vec(1, 0) "
                                         "circle2.position, circle2.velocity = "
                                         "vec(0, 2), vec(-1, 0) "
                                         "circle1.radius, circle2.radius = 0.2, 0.2 "
                                         "circle1.density, circle2.density = 1, 2 ");
        const Task &of = task(QLatin1String("L42T17"));
        return *judgeTask(m_lab, of, Submission(of.preset, written(program, structure)), 1);
    }
    [[nodiscard]] static QString bodyIn(const CheckReport &report)
    {
        for (const Finding &finding : report.findings) {
            if (finding.message.startsWith(
                    QLatin1String("In your own scene the walls do not use the e that it has")))
                return finding.message.section(QLatin1String("\n\n"), 1);
        }
        return {};
    }
};

void TestOwnWalls::copyOfEIsTold()
{
    const QString start = QStringLiteral("kept = restitution restitution = 0.75 ");
    for (const int structure : {0, 3}) {
        for (const WallWay &way : {wallWays[0], wallWays[1]}) {
            const LawProgram pieces{.walls = wallsOf(way, "c.radius", "kept"),
                                    .hit = hitOf(hitWays[0], {.e = QStringLiteral("restitution")})};
            const QString body = bodyIn(reportOf(start, pieces, structures[structure]));
            const auto n = numbersIn(
                body,
                "Circle # came to the * with # m/s and left it with # m/s, which is about # times "
                "as much, and `restitution` is #. Other scenes come out right.");
            QVERIFY2(n.size() == 5, qPrintable(body));
            QVERIFY(std::abs(n[3] - task(QLatin1String("L42T17")).preset.restitution) < 0.003);
            QVERIFY(isNear(n[2], n[3] * n[1]));
            QCOMPARE(n[4], 0.75);
        }
    }
}

/// Under gravity, and in other scenes with it, a number stands for e.
void TestOwnWalls::whatIsNoCopyIsNotCalledOne()
{
    const LawProgram pieces{
        .walls = wallsOf(wallWays[1], "c.radius", "(gravity.y < 0 and 0.5 or restitution)"),
        .hit = hitOf(hitWays[0], {.e = QStringLiteral("restitution")})};
    const CheckReport report =
        reportOf(QStringLiteral("restitution = 0.75 "), pieces, structures[0]);
    QCOMPARE(bodyIn(report), QString());
    QCOMPARE(report.findings.size(), std::size_t{1});
    const auto n = numbersIn(
        report.findings.front().message,
        "In your own scene walls give another share of the speed back than e\n\nCircle # came to "
        "the * with # m/s and left it with # m/s, which is about # times as much, and "
        "`restitution` is #. Of # fast hits in that run, # came out right.");
    QVERIFY2(n.size() == 7, qPrintable(report.findings.front().message));
    QVERIFY(std::abs(n[3] - 0.5) < 0.02);
    QCOMPARE(n[4], 0.75);
    QVERIFY(n[5] > 0.0);
    QCOMPARE(n[6], 0.0);
}

void TestOwnWalls::rightWallsAreNotBlamed()
{
    const LawProgram pieces{.walls = wallsOf(wallWays[1], "c.radius", "kept"),
                            .hit = hitOf(hitWays[0], {.e = QStringLiteral("1")})};
    const CheckReport report =
        reportOf(QStringLiteral("restitution = 0.75 kept = restitution "), pieces, structures[0]);
    QVERIFY(!report.passed);
    QCOMPARE(bodyIn(report), QString());
}

void TestOwnWalls::copyOfARadiusIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("headline");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("old");
    QTest::newRow("larger now") << QStringLiteral(
        "L42T13") << QStringLiteral("In your own scene circle 2 turns too late at the walls")
                                << 0.4 << 0.2;
    QTest::newRow("smaller now") << QStringLiteral(
        "L42T14") << QStringLiteral("In your own scene circle 2 turns too early at the walls")
                                 << 0.252 << 0.4;
}

void TestOwnWalls::copyOfARadiusIsTold()
{
    QFETCH(QString, step);
    QFETCH(QString, headline);
    QFETCH(double, radius);
    QFETCH(double, old);
    for (const Structure &structure : {structures[0], structures[3]}) {
        const CheckReport report = reportOfRadius(step, "kept[c.index]", structure);
        QCOMPARE(report.findings.size(), std::size_t{1});
        const QString &said = report.findings.front().message;
        QCOMPARE(said.section(QLatin1Char('\n'), 0, 0), headline);
        const auto n =
            numbersIn(said, "Its radius is # m, and at the * it turned in a step that "
                            "would have brought its centre from # to # m from the wall.");
        QVERIFY2(n.size() == 3, qPrintable(said));
        QCOMPARE(n[0], radius);
        QVERIFY(n[2] <= old && old <= n[1]);
    }
    QVERIFY(reportOfRadius(step, "c.radius", structures[0]).passed);
}

/// In other scenes no circle has that radius.
void TestOwnWalls::otherRadiusIsNoCopy()
{
    const CheckReport report = reportOfRadius(QStringLiteral("L42T13"),
                                              "c.radius == 0.4 and 0.3 or c.radius", structures[0]);
    QVERIFY(!report.passed);
    for (const Finding &finding : report.findings)
        QVERIFY2(!finding.message.startsWith(QLatin1String("In your own scene circle")),
                 qPrintable(finding.message));
}

QTEST_GUILESS_MAIN(TestOwnWalls)
#include "test_own_walls.moc"
