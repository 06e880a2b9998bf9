// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/wall_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// The numbers that findings tell of where walls turn circles are those that the program's law
/// makes.
class TestToldReach : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void reachOfAWallIsTold_data();
    void reachOfAWallIsTold();
    void lengthForTheRadiusIsTold();
    void numberForTheRadiusIsTold();
    void numberIsNoOtherRadius();
    void whoIsLiftedAtAWallIsNotLetThrough();

private:
    /// In a step with walls that turn a circle at the distance \p reach.
    [[nodiscard]] QString bodyOfReach(const char *reach, const QString &headline = {},
                                      const char *step = "L42T17") const
    {
        const LawBench bench(task(QLatin1String(step)));
        const QString program = written({.walls = wallsOf(wallWays[1], reach)}, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return bodyOf(wallDeviations(own.walls(), bench.right.walls(), bench.ground), headline);
    }
};

void TestToldReach::reachOfAWallIsTold_data()
{
    QTest::addColumn<QString>("reach");
    QTest::addColumn<double>("more"); // than the radius, m
    QTest::newRow("too early") << "c.radius + 0.07" << 0.07;
    QTest::newRow("too late") << "c.radius - 0.06" << -0.06;
    QTest::newRow("past the wall") << "c.radius - 0.6" << -0.6;
}

/// Between two places as far apart as it goes in a step.
void TestToldReach::reachOfAWallIsTold()
{
    QFETCH(QString, reach);
    QFETCH(double, more);
    const QString body = bodyOfReach(reach.toUtf8().constData());
    auto n = numbersIn(body, "The radius of circle # is # m, and at the * it turned when its "
                             "centre was between # and # m from the wall.");
    double sign = 1.0;
    if (n.empty()) {
        sign = -1.0;
        n = numbersIn(body, "The radius of circle # is # m, and at the * it turned when its "
                            "centre was between # and # m past the wall.");
    }
    QVERIFY2(n.size() == 4, qPrintable(body));
    QCOMPARE(sign, more < -0.5 ? -1.0 : 1.0);
    QCOMPARE(n[0], 1.0);
    const double place = n[1] + more;
    // The smaller number comes first, also of those past the wall.
    QVERIFY(n[2] <= sign * place + 1e-3 && sign * place - 1e-3 <= n[3]);
    QVERIFY(n[3] - n[2] > 0.01 && n[3] - n[2] < 0.06); // 1.07 to 2.9 m/s
}

void TestToldReach::lengthForTheRadiusIsTold()
{
    const QString body = bodyOfReach("2 * c.radius");
    const auto n = numbersIn(
        body, "The radius of circle # is # m, and it turns when its centre is # m from the wall");
    QVERIFY2(n.size() == 3, qPrintable(body));
    QCOMPARE(n[0], 1.0);
    QVERIFY(isNear(n[2], 2.0 * n[1]));
}

/// Of circle 2 alone: between two places, whichever of its two sizes it has.
void TestToldReach::numberForTheRadiusIsTold()
{
    const auto n = numbersIn(
        bodyOfReach("(c.index == 2 and 0.31 or c.radius)",
                    QStringLiteral("At the walls a number stands for the radius of circle 2"),
                    "L42T13"),
        "Circle # turned when its centre was between # and # m from the wall, with the radius # m "
        "as with # m.");
    QCOMPARE(n.size(), std::size_t{5});
    QCOMPARE(n[0], 2.0);
    QVERIFY(n[1] <= 0.31 && 0.31 <= n[2] && n[2] - n[1] < 0.06);
    QVERIFY(n[3] < 0.2 && n[4] > 0.31);
    // A margin goes with the radius.
    QCOMPARE(bodyOfReach("c.radius + 0.1",
                         QStringLiteral("At the walls a number stands for the radius of"),
                         "L42T13"),
             QString());
}

/// Of the size that the smaller circle has where the two differ.
void TestToldReach::numberIsNoOtherRadius()
{
    const QString number =
        QStringLiteral("At the walls a number stands for the radius of circle 1");
    for (const char *reach : {"0.12", "0.1", "0.368", "0.4"}) {
        const QByteArray own = QByteArray("(c.index == 1 and ") + reach + " or c.radius)";
        QVERIFY2(!bodyOfReach(own.constData(), number).isEmpty(), reach);
    }
    for (const char *which : {"smaller", "larger"}) {
        const QString other =
            QStringLiteral("At the walls the %1 radius stands for that of both circles")
                .arg(QLatin1String(which));
        const char *reach = *which == 's' ? "math.min(circle1.radius, circle2.radius)"
                                          : "math.max(circle1.radius, circle2.radius)";
        QVERIFY2(!bodyOfReach(reach, other).isEmpty(), which);
    }
}

/// A floor that stands 2 m too high lifts a circle that comes to a side wall below it: there no
/// wall lets it through.
void TestToldReach::whoIsLiftedAtAWallIsNotLetThrough()
{
    const QString program =
        QStringLiteral("function on_load() circle1.velocity = vec(2, 0) end\n"
                       "local function turned(p, v, r, low, high)\n"
                       "  if p - r < low then return low + r, math.abs(v) end\n"
                       "  if p + r > high then return high - r, -math.abs(v) end\n"
                       "  return p, v\n"
                       "end\n"
                       "function on_update(h)\n"
                       "  local c = circle1\n"
                       "  local p, v = c.position + c.velocity * h, c.velocity\n"
                       "  local x, vx = turned(p.x, v.x, c.radius, square.left, square.right)\n"
                       "  local y, vy = turned(p.y, v.y, c.radius, square.bottom + 2, square.top)\n"
                       "  c.position, c.velocity = vec(x, y), vec(vx, vy)\n"
                       "end\n");
    const Task &step = task(QStringLiteral("L42T2"));
    const CheckReport report = *judgeTask(m_lab, step, Submission(step.preset, program), 1);
    QCOMPARE(report.findings.size(), std::size_t{1});
    const auto n = numbersIn(report.findings.front().message,
                             "The radius of circle 1 is # m, and at the floor it turned when its "
                             "centre was between # and # m from the wall.");
    QCOMPARE(n.size(), std::size_t{3});
    QVERIFY(n[1] <= 2.0 + n[0] && n[2] >= 2.0 + n[0] && n[2] - n[1] < 0.1);
}

QTEST_GUILESS_MAIN(TestToldReach)
#include "test_told_reach.moc"
