// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/judgement.h"
#include "tasks/report/report_json.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What is said of programs in which the other circle has a part: or none, where they never meet.
class TestToldCompany : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void contactAlongOneAxisIsNoFaultOfTheWalls_data();
    void contactAlongOneAxisIsNoFaultOfTheWalls();
    void circlesThatNeverMeetAreTold_data();
    void circlesThatNeverMeetAreTold();
    void whoIsHeldBeforeIsNotSaidToMiss();

private:
    [[nodiscard]] QStringList toldOf(const char *step, const QString &program) const
    {
        const Task &of = task(QLatin1String(step));
        const CheckReport report = *judgeTask(m_lab, of, Submission(of.preset, program), 1);
        QStringList told;
        for (const Finding &finding : report.findings)
            told.append(aspectName(finding.aspect) + QLatin1Char(':') + finding.message);
        return told;
    }
};

void TestToldCompany::contactAlongOneAxisIsNoFaultOfTheWalls_data()
{
    QTest::addColumn<QString>("touch");
    QTest::addColumn<QString>("answer");
    for (const char *touch : {"math.abs(d.x) < reach", "d.y ^ 2 < reach ^ 2"}) {
        QTest::addRow("%s, stop", touch)
            << touch << "p.velocity, q.velocity = vec(0, 0), vec(0, 0)";
        QTest::addRow("%s, put back", touch) << touch << "p.position, q.position = oldp, oldq";
    }
}

/// A circle that stands over another's x comes to its wall: a hit of the two, if it is one.
void TestToldCompany::contactAlongOneAxisIsNoFaultOfTheWalls()
{
    QFETCH(QString, touch);
    QFETCH(QString, answer);
    for (const Structure &structure : structures) {
        const QString program = written(
            {.start = QStringLiteral("circle1.position, circle1.velocity = vec(-2, 2), "
                                     "vec(2, 0) circle2.position, circle2.velocity = "
                                     "vec(2, 2), vec(0, 0)"),
             .walls = wallsOf(wallWays[0], "c.radius", "1"),
             .hit = hitOf(hitWays[1],
                          {.touch = touch, .approach = QStringLiteral("true"), .answer = answer})},
            structure);
        const QStringList told = toldOf("L42T9", program);
        QVERIFY2(!told.isEmpty(), structure.name);
        for (const QString &finding : told)
            QVERIFY2(!finding.startsWith(QLatin1String("walls:")), qPrintable(finding));
    }
}

void TestToldCompany::circlesThatNeverMeetAreTold_data()
{
    QTest::addColumn<QString>("start");
    QTest::addColumn<QString>("numbers"); ///< of what is told; empty where they meet
    // Side by side to the right wall and back, 1 m from centre to centre, with 0.2 m and 0.4 m.
    QTest::newRow("side by side")
        << "circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
           "circle2.position, circle2.velocity = vec(-2, 1), vec(2, 0)"
        << "In its first 4 s their rims come no nearer than 0.4 m, at 0 s.";
    QTest::newRow("towards each other")
        << "circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
           "circle2.position, circle2.velocity = vec(2, 2), vec(0, 0)"
        << "";
}

void TestToldCompany::circlesThatNeverMeetAreTold()
{
    QFETCH(QString, start);
    QFETCH(QString, numbers);
    const QString radius = QStringLiteral("circle2.radius = 0.4 ");
    for (const Structure &structure : structures) {
        const QString program = written({.start = radius + start,
                                         .walls = wallsOf(wallWays[0], "c.radius", "1"),
                                         .hit = hitOf(hitWays[0])},
                                        structure);
        const QStringList told = toldOf("L42T13", program);
        QCOMPARE(told.filter(QStringLiteral("do not meet")).size(), numbers.isEmpty() ? 0 : 1);
        QVERIFY2(numbers.isEmpty() || told.front().contains(numbers), qPrintable(told.value(0)));
    }
}

/// Circle 1 is put back in every step that would bring it nearer: it is no matter of the start.
void TestToldCompany::whoIsHeldBeforeIsNotSaidToMiss()
{
    const HitLaw held{.touch = QStringLiteral("d:length() < reach + 0.3"),
                      .answer = QStringLiteral("q.velocity = vec(0, 0)")};
    for (const Structure &structure : structures) {
        const QString program = written(
            {.start = QStringLiteral("circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
                                     "circle2.position, circle2.velocity = vec(2, 2), vec(0, 0) "
                                     "circle2.radius = 0.4"),
             .walls = wallsOf(wallWays[0], "c.radius", "1"),
             .hit = hitOf(hitWays[0], held)},
            structure);
        const QStringList told = toldOf("L42T13", program);
        QVERIFY(!told.isEmpty());
        QCOMPARE(told.filter(QStringLiteral("do not meet")), QStringList());
    }
}

QTEST_GUILESS_MAIN(TestToldCompany)
#include "test_told_company.moc"
