// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/floor_rest_words.h"
#include "tasks/judging/wall_together_words.h"

#include "tests/told_numbers.h"

using namespace cradle;
using namespace cradle::programs;
using namespace cradle::told;

/// What only stages of their own show: two circles at walls at once, circles that come to rest,
/// hits early and late in a step, and how a wall's answer hangs on what it should not.
class TestToldStages : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void partAlongAWallIsTold_data();
    void partAlongAWallIsTold();
    void fixedLossIsTold();
    void lateTurnIsTold();
    void hitHiddenByAnotherIsTold();
    void wallsOfTheirOwnHideNothing();
    void rubbingAtRestIsTold();
    void hangingInTheAirIsTold();
    void rightRestIsNotTold();
    void hitMissedLateInAStepIsTold();
    void distanceThatFewRadiiShowIsTold_data();
    void distanceThatFewRadiiShowIsTold();
    void tooLongNormalIsOfAllHits();

private:
    [[nodiscard]] std::vector<LawDeviation> ofWalls(const char *step, const QString &walls) const
    {
        const LawBench bench(task(QLatin1String(step)));
        const QString program = written({.walls = walls}, structures[0]);
        const MeasuredLaws own(&program, bench.ground);
        return wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    }
    [[nodiscard]] QString together(const char *step, const QString &program) const
    {
        const LawBench bench(task(QLatin1String(step)));
        const auto found = wallsTogether(program, bench.task.solution, bench.ground);
        return found ? found->message : QString();
    }
    [[nodiscard]] QString resting(const char *step, const QString &program) const
    {
        const LawBench bench(task(QLatin1String(step)));
        const auto found = restAtFloor(program, bench.task.solution, bench.ground);
        return found ? found->message : QString();
    }
};

namespace {

QString text(const char *utf8)
{
    return QString::fromUtf8(utf8);
}

} // namespace

void TestToldStages::partAlongAWallIsTold_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QString>("back");
    QTest::newRow("mean of both parts") << "L42T3"
                                        << "(v + math.abs(w)) / 2 / v";
    QTest::newRow("length") << "L42T8"
                            << "math.sqrt(v * v + w * w) / math.abs(v)";
    QTest::newRow("a tenth of it, with e") << "L42T17"
                                           << "restitution + 0.1 * math.abs(w / v)";
}

/// No share that one slant shows is told as that of the wall.
void TestToldStages::partAlongAWallIsTold()
{
    QFETCH(QString, step);
    QFETCH(QString, back);
    const auto found = ofWalls(step.toUtf8().constData(),
                               wallsOf(wallWays[1], "c.radius", back.toUtf8().constData()));
    QVERIFY(!found.empty());
    const QString body = bodyOf(found, text("At the walls the part along the wall comes into the "
                                            "rebound of "));
    const auto n = numbersIn(body, "With # m/s into the wall and # m/s along it, # times the part "
                                   "into it comes back; with # m/s along it # times.");
    QVERIFY2(n.size() == 5, qPrintable(found.front().message));
    QVERIFY(n[3] > 1.5 * n[1]);
    if (step == QLatin1String("L42T8")) {
        QVERIFY(isNear(n[2], std::hypot(n[0], n[1]) / n[0]));
        QVERIFY(isNear(n[4], std::hypot(n[0], n[3]) / n[0]));
    }
    // A share that no slant changes stays one.
    QCOMPARE(LawBench::headlines(ofWalls("L42T8", wallsOf(wallWays[1], "c.radius", "0.9"))),
             QStringList{text("Hits at the walls give both circles 0.9 times the speed back")});
}

void TestToldStages::fixedLossIsTold()
{
    for (const auto &[back, headline, amount] :
         {std::tuple("1 - 0.4 / math.abs(v)",
                     "Hits at the walls take a fixed amount of speed from both circles",
                     "From every speed tried it leaves with about # m/s too little."),
          std::tuple("1 + 0.4 / math.abs(v)",
                     "Hits at the walls add a fixed amount of speed to both circles",
                     "From every speed tried it leaves with about # m/s too much.")}) {
        const auto found = ofWalls("L42T8", wallsOf(wallWays[1], "c.radius", back));
        const auto n = numbersIn(bodyOf(found, text(headline)), amount);
        QCOMPARE(n, std::vector<double>{0.4});
    }
    // No number that stands for e, nor what counts the part along the wall.
    const auto n = numbersIn(
        bodyOf(ofWalls("L42T17", wallsOf(wallWays[1], "c.radius", "1 - 0.4 / math.abs(v)")),
               text("Hits at the walls take a fixed amount of speed from both circles")),
        "From every speed and with every e tried it leaves with about # m/s less than it came "
        "with.");
    QCOMPARE(n, std::vector<double>{0.4});
    QVERIFY(
        bodyOf(ofWalls("L42T8", wallsOf(wallWays[1], "c.radius", "1 - 0.4 / c.velocity:length()")),
               text("Hits at the walls take a fixed amount"))
            .isEmpty());
}

/// It stays in the wall for some steps, and is turned then: no sign is wrong.
void TestToldStages::lateTurnIsTold()
{
    const QString program = QStringLiteral(R"lua(
local held = 0
function on_load() end
function on_update(h)
  for _, c in ipairs(circles) do
    local p, v = c.position + c.velocity * h, c.velocity + gravity * h
    local out = p.y - c.radius < square.bottom and v.y < 0
    if out then
      held = held + 1
      if held < 4 then return end
      held = 0
      v = vec(v.x, -v.y)
    end
    if math.abs(p.x) + c.radius > square.right and p.x * v.x > 0 then
      out, v = true, vec(-v.x, v.y)
    end
    if p.y + c.radius > square.top and v.y > 0 then out, v = true, vec(v.x, -v.y) end
    if not out then c.position = p end
    c.velocity = v
  end
end
)lua");
    const LawBench bench(task(QStringLiteral("L42T3")));
    const MeasuredLaws own(&program, bench.ground);
    const auto found = wallDeviations(own.walls(), bench.right.walls(), bench.ground);
    const auto n = numbersIn(
        bodyOf(found, text("Hits at the floor turn the velocity of circle 1 round too late")),
        "Its velocity points away from the wall only # s later, in steps of #/# s.");
    QVERIFY2(n.size() == 3, qPrintable(LawBench::headlines(found).join(QLatin1Char('\n'))));
    QVERIFY(isNear(n[0], 3.0 * n[1] / n[2]));
}

namespace {

/// Circle 2 is asked in one chain with circle 1, or after an answer of circle 1 in no step.
const char *chained = R"lua(
function on_load() end
local function hit(c, old)
  local p, v, r = c.position, c.velocity, c.radius
  if math.abs(p.x) + r > square.right and p.x * v.x > 0 then
    c.position, c.velocity = old, vec(-v.x, v.y)
    return true
  end
  if math.abs(p.y) + r > square.top and p.y * v.y > 0 then
    c.position, c.velocity = old, vec(v.x, -v.y)
    return true
  end
end
function on_update(h)
  local old1, old2 = circle1.position, circle2.position
  for _, c in ipairs(circles) do
    c.position = c.position + c.velocity * h
    c.velocity = c.velocity + gravity * h
  end
  ASK
end
)lua";

} // namespace

void TestToldStages::hitHiddenByAnotherIsTold()
{
    const auto asking = [](const char *ask) {
        return QString::fromLatin1(chained).replace(QLatin1String("ASK"), QLatin1String(ask));
    };
    const QString first = together("L42T4", asking("if not hit(circle1, old1) then hit(circle2, "
                                                   "old2) end"));
    QVERIFY2(first.startsWith(text("In a step in which circle 1 hits a wall, circle 2 hits none")),
             qPrintable(first));
    QVERIFY2(first.contains(text("circle 1 was turned in it, and circle 2 was not.")),
             qPrintable(first));
    const QString second = together("L42T4", asking("if not hit(circle2, old2) then hit(circle1, "
                                                    "old1) end"));
    QVERIFY2(second.startsWith(text("In a step in which circle 2 hits a wall, circle 1 hits none")),
             qPrintable(second));
    QVERIFY(together("L42T4", asking("hit(circle1, old1) hit(circle2, old2)")).isEmpty());
    // Where the first lies on the floor, the second sinks.
    Submission submission(solution(QStringLiteral("L42T17")));
    submission.script =
        asking("if not hit(circle1, old1) then hit(circle2, old2) end")
            .replace(QLatin1String("-v.x, v.y"), QLatin1String("-restitution * v.x, v.y"))
            .replace(QLatin1String("v.x, -v.y"), QLatin1String("v.x, -restitution * v.y"))
            .replace(QLatin1String("    c.position = c.position + c.velocity * h\n"), QString())
            .replace(
                QLatin1String("+ gravity * h\n"),
                QLatin1String("+ gravity * h\n    c.position = c.position + c.velocity * h\n"));
    const auto findings = judgeTask(m_lab, task(QStringLiteral("L42T17")), submission, 1)->findings;
    QVERIFY(std::any_of(findings.begin(), findings.end(), [](const Finding &each) {
        return each.message.startsWith(QLatin1String("In a step in which circle 1 hits"));
    }));
    QVERIFY(std::none_of(findings.begin(), findings.end(), [](const Finding &each) {
        return each.message.startsWith(QLatin1String("The floor does not hold"));
    }));
}

/// Right walls of all kinds, with and without gravity.
void TestToldStages::wallsOfTheirOwnHideNothing()
{
    for (const char *step : {"L42T4", "L42T5", "L42T7", "L42T8", "L42T12", "L42T17"}) {
        for (const WallWay &way : wallWays) {
            const QString program = written({.walls = wallsOf(way)}, structures[1]);
            QVERIFY(together(step, program).isEmpty());
        }
    }
}

void TestToldStages::rubbingAtRestIsTold()
{
    const QString walls =
        wallsOf(wallWays[1], "c.radius", "restitution", "(math.abs(v) < 0.3 and 0.9 or 1)");
    const QString said = resting("L42T17", written({.walls = walls}, structures[0]));
    QVERIFY2(said.startsWith(text("On the floor the speed of both circles along it changes")),
             qPrintable(said));
    const auto n = numbersIn(said, "Circle # was let go # m above the floor with # m/s along it, "
                                   "and had # m/s along it # s later; # m/s is right.");
    QVERIFY2(n.size() == 6, qPrintable(said));
    QVERIFY(n[3] < n[2]);
    QCOMPARE(n[5], n[2]);
}

void TestToldStages::hangingInTheAirIsTold()
{
    const QString move = QStringLiteral(
        "c.still = c.still or (c.velocity:length() < 0.1 and c.position.y - c.radius < -3.95) "
        "if c.still then c.velocity = vec(0, 0) else c.velocity = c.velocity + gravity * h end "
        "c.position = c.position + c.velocity * h");
    const QString program =
        written({.start = QStringLiteral("for _, c in ipairs(circles) do c.still = false end"),
                 .move = move,
                 .walls = wallsOf(wallWays[0])},
                structures[0]);
    const QString said = resting("L42T17", program);
    QVERIFY2(said.startsWith(text("Above the floor gravity stops moving both circles")),
             qPrintable(said));
    const auto n = numbersIn(said, "Circle # was let go at rest # m above the floor, and from # s "
                                   "on it stood still # m above it");
    QVERIFY2(n.size() == 4, qPrintable(said));
    QVERIFY(n[3] > 0.0 && n[3] < n[1]);
}

void TestToldStages::rightRestIsNotTold()
{
    for (const WallWay &way : wallWays) {
        const QString program = written({.walls = wallsOf(way)}, structures[0]);
        QVERIFY(resting("L42T17", program).isEmpty());
        QVERIFY(resting("L42T8", program).isEmpty());
    }
}

/// The moment of contact is worked out to twice the time that is left.
void TestToldStages::hitMissedLateInAStepIsTold()
{
    const QString program = QStringLiteral(R"lua(
function on_load() end
local function left()
  local d, w = circle2.position - circle1.position, circle2.velocity - circle1.velocity
  local r = circle1.radius + circle2.radius
  local a, b, c = w:dot(w), d:dot(w), d:dot(d) - r * r
  if a == 0 or b >= 0 or b * b - 4 * a * c < 0 then return 2 end
  return (-b - math.sqrt(b * b - 4 * a * c)) / (2 * a)
end
function on_update(h)
  local t = left()
  local meets = t >= 0 and t <= h
  for _, c in ipairs(circles) do
    c.position = c.position + c.velocity * (meets and t or h)
    if meets then c.velocity = vec(0, 0) end
  end
end
)lua");
    const LawBench bench(task(QStringLiteral("L42T9")));
    const auto found = bench.contactFound(program);
    const QString body =
        bodyOf(found, text("Whether a hit is answered depends on where in a step they touch"));
    QVERIFY2(body.contains(text("after a quarter of a step of 1/60 s, they were answered; where "
                                "after two thirds, they ran into each other.")),
             qPrintable(LawBench::headlines(found).join(QLatin1Char('\n'))));
    QVERIFY(bench
                .contact(QString(program).replace(QLatin1String("d:dot(w), d:dot(d)"),
                                                  QLatin1String("2 * d:dot(w), d:dot(d)")))
                .isEmpty());
    // Who stops with an error in that hit did not run into anybody.
    const QString stopping = QString(program).replace(QLatin1String("local meets = t >= 0"),
                                                      QLatin1String("if t > h and t < 1.5 * h then "
                                                                    "error('late') end "
                                                                    "local meets = t >= 0"));
    QVERIFY(
        !LawBench::headlines(bench.contactFound(stopping))
             .contains(text("Whether a hit is answered depends on where in a step they touch")));
}

void TestToldStages::distanceThatFewRadiiShowIsTold_data()
{
    QTest::addColumn<QString>("touch");
    QTest::addColumn<QString>("headline");
    QTest::newRow("product") << "d:length_squared() < 4 * p.radius * q.radius"
                             << "Contact is tested at 2 √(r₁ r₂), not at r₁ + r₂";
    QTest::newRow("squares") << "d:length_squared() < p.radius ^ 2 + q.radius ^ 2"
                             << "Contact is tested at √(r₁² + r₂²), not at r₁ + r₂";
    QTest::newRow("none that is known") << "d:length() < 0.97 * (p.radius + q.radius)"
                                        << "Some meetings are answered too late";
}

void TestToldStages::distanceThatFewRadiiShowIsTold()
{
    QFETCH(QString, touch);
    QFETCH(QString, headline);
    const LawBench bench(task(QStringLiteral("L42T13")));
    const QString program = written(
        withHit(hitOf(hitWays[0], {.touch = touch, .mass = QStringLiteral("1")})), structures[0]);
    const auto found = bench.contactFound(program);
    const QString body = bodyOf(found, headline);
    QVERIFY2(!body.isEmpty(), qPrintable(LawBench::headlines(found).join(QLatin1Char('\n'))));
    QVERIFY(bench
                .contact(written(withHit(hitOf(hitWays[0], {.mass = QStringLiteral("1")})),
                                 structures[0]))
                .isEmpty());
}

/// Two laws of the length of the normal have one headline: it is the one that was found that holds
/// for all hits.
void TestToldStages::tooLongNormalIsOfAllHits()
{
    const QString program =
        written(withHit(hitOf(hitWays[0], {.normal = QStringLiteral("d / d:length_squared()"),
                                           .mass = QStringLiteral("1")})),
                structures[0]);
    const Task &step = task(QStringLiteral("L42T12"));
    Submission submission(solution(QStringLiteral("L42T12")));
    submission.script = QString(program).replace(
        QLatin1String("function on_load() "),
        QLatin1String("function on_load() gravity = vec(0, 0) "
                      "circle1.position, circle1.velocity = vec(-2, 2), vec(2, 0) "
                      "circle2.position, circle2.velocity = vec(2, -2), vec(0, 2) "));
    const CheckReport report = *judgeTask(m_lab, step, submission, 1);
    QVERIFY(!report.findings.empty());
    QVERIFY2(
        report.findings.front().message.startsWith(text("The normal does not have length 1\n")),
        qPrintable(report.findings.front().message));
}

QTEST_GUILESS_MAIN(TestToldStages)
#include "test_told_stages.moc"
