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
    void contactFarApartIsNoFaultOfTheWalls_data();
    void contactFarApartIsNoFaultOfTheWalls();
    void stopFarApartIsOneOfTheContact_data();
    void stopFarApartIsOneOfTheContact();
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

void TestToldCompany::contactFarApartIsNoFaultOfTheWalls_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("touch");
    QTest::addColumn<std::size_t>("way");
    QTest::newRow("doubled, put back") << "L42T11"
                                       << "math.sqrt(d.x ^ 2 + d.y * 2) < reach" << std::size_t{0};
    QTest::newRow("doubled, in place") << "L42T12"
                                       << "d.x ^ 2 + 2 * d.y < reach ^ 2" << std::size_t{1};
    QTest::newRow("no square") << "L42T12"
                               << "d.x ^ 2 + d.y < reach ^ 2" << std::size_t{1};
}

/// They push each other as one comes to a wall, by chance.
void TestToldCompany::contactFarApartIsNoFaultOfTheWalls()
{
    QFETCH(QString, step);
    QFETCH(QString, touch);
    QFETCH(std::size_t, way);
    const bool isGlancing = step == QLatin1String("L42T11");
    for (const std::size_t wall : {std::size_t{0}, std::size_t{1}}) {
        const QString program = written(
            {.start = isGlancing ? QStringLiteral("circle1.position, circle1.velocity = "
                                                  "vec(-2, 2.3), vec(2, 0) circle2.position, "
                                                  "circle2.velocity = vec(2, 2), vec(0, 0)")
                                 : QStringLiteral("circle1.position, circle1.velocity = "
                                                  "vec(-2, 2), vec(2, 0) circle2.position, "
                                                  "circle2.velocity = vec(2, -2), vec(0, 2)"),
             .walls = wallsOf(wallWays[wall], "c.radius", "1"),
             .hit = hitOf(hitWays[way], {.touch = touch, .mass = QStringLiteral("1")})},
            structures[1]);
        const QStringList told = toldOf(step.toUtf8().constData(), program);
        QVERIFY(!told.isEmpty());
        for (const QString &finding : told)
            QVERIFY2(!finding.startsWith(QLatin1String("walls:")), qPrintable(finding));
    }
}

void TestToldCompany::stopFarApartIsOneOfTheContact_data()
{
    QTest::addColumn<QString>("touch");
    for (const char *touch : {"p.position:length() - q.position:length() < reach",
                              "p.position.x - q.position.x < reach", "d.y < reach"})
        QTest::addRow("%s", touch) << touch;
}

/// Where they stand decides, not how fast they are.
void TestToldCompany::stopFarApartIsOneOfTheContact()
{
    QFETCH(QString, touch);
    const QString program = written(
        {.start = QStringLiteral("circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
                                 "circle2.position, circle2.velocity = vec(2, 2), vec(0, 0)"),
         .walls = wallsOf(wallWays[2], "c.radius", "1"),
         .hit = hitOf(hitWays[1],
                      {.touch = touch,
                       .approach = QStringLiteral("true"),
                       .answer = QStringLiteral("p.velocity, q.velocity = vec(0, 0), vec(0, 0)")})},
        structures[0]);
    const QString told = toldOf("L42T9", program).value(0);
    QVERIFY2(told.startsWith(QLatin1String("motion:The circles answer each other although they "
                                           "are far apart")),
             qPrintable(told));
    const auto n =
        numbersIn(told, "they have (0, 0) and (0, 0) m/s one step of 1/60 s later; "
                        "where circle # starts at (#, #) m, circle # keeps its velocity");
    QVERIFY2(n.size() == 4 && n[0] + n[3] == 3.0, qPrintable(told));
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
