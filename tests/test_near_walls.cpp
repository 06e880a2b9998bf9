// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lab_test.h"

#include "tasks/judging/judgement.h"

using namespace cradle;

/// What goes wrong on the way to a wall, after it or in the first step is not blamed on the wall.
class TestNearWalls : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void stepsNearWallsAreTold();
    void whatCountsStepsIsNotNearAWall();
    void aVelocityOfItsOwnIsTold_data();
    void aVelocityOfItsOwnIsTold();
    void gravityLeftOutAtTheFloorIsTold();
    void anOddFirstStepHidesTheWalls();
    void anOddFirstStepIsNoKnownMistake();
    void stepsInPartsAreNoFaultOfTheWalls();
    void aHundredthThatIsLostIsTold();
    void whatGoesWrongOneWayIsTold_data();
    void whatGoesWrongOneWayIsTold();
    void aCircleThatIsNearIsTold();

private:
    [[nodiscard]] std::vector<Finding> findings(const char *step, const QString &program) const
    {
        const Task &of = task(QLatin1String(step));
        return judgeTask(m_lab, of, Submission(of.preset, program), 1)->findings;
    }
    [[nodiscard]] static bool isOfWalls(const Finding &each)
    {
        return each.aspect == Aspect::Walls;
    }
};

namespace {

/// Turns circle \c c at every wall, and puts it back to \c old.
const QString restoring = QStringLiteral(R"lua(
local function walls(c, old)
  local p, v, r = c.position, c.velocity, c.radius
  if (p.x + r > square.right and v.x > 0) or (p.x - r < square.left and v.x < 0) then
    c.position = old
    v = vec(-LOSS * v.x, v.y)
  end
  if (p.y + r > square.top and v.y > 0) or (p.y - r < square.bottom and v.y < 0) then
    c.position = old
    v = vec(v.x, -LOSS * v.y)
  end
  c.velocity = v
end
)lua");

const QString falling = QStringLiteral(R"lua(
function on_load()
  gravity = vec(0, -9.81)
  for i = 1, #circles do
    circles[i].position = vec(-2, 2)
    circles[i].velocity = vec(2, 0)
  end
end
)lua");

QString losing(const char *share)
{
    QString walls = restoring;
    return walls.replace(QLatin1String("LOSS"), QLatin1String(share));
}

/// Free of gravity, with \p step in each step before the walls.
QString drifting(const QString &step, const QString &names = {})
{
    return losing("1") + names
           + QStringLiteral("function on_load() circle1.velocity = vec(2, 0) end\n"
                            "function on_update(dt) local c = circle1 local old = c.position\n")
           + step + QStringLiteral("\nwalls(c, old) end");
}

} // namespace

void TestNearWalls::stepsNearWallsAreTold()
{
    const auto all =
        findings("L42T2", drifting(QStringLiteral(
                              "local near = math.abs(c.position.x) > 3.4\n"
                              "c.position = c.position + c.velocity * dt * (near and 0.5 or 1)")));
    QCOMPARE(all.size(), std::size_t{1});
    const QString message = all.front().message;
    QVERIFY2(
        message.startsWith(QStringLiteral(
            "Near the left wall and right wall the steps of circle 1 are made in another way")),
        qPrintable(message));
    QVERIFY(message.contains(QLatin1String("went (-0.0242, -0.00894) m in a step of 1/60 s; in "
                                           "free flight it goes (-0.0483, -0.0179) m")));
    QVERIFY(all.front().mistake.isEmpty());
}

/// The third step is odd wherever it is made.
void TestNearWalls::whatCountsStepsIsNotNearAWall()
{
    const auto all = findings(
        "L42T2", drifting(QStringLiteral("n = n + 1\n"
                                         "c.position = c.position + c.velocity * dt * (n == 5 and "
                                         "0.5 or 1)"),
                          QStringLiteral("local n = 0\n")));
    for (const Finding &each : all)
        QVERIFY2(!each.message.startsWith(QLatin1String("Near the ")), qPrintable(each.message));
}

void TestNearWalls::aVelocityOfItsOwnIsTold_data()
{
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("why");
    const QString kept = QStringLiteral("A velocity or an old place that your program keeps in a "
                                        "variable of its own must change at a hit, too.");
    QTest::newRow("goes on outward")
        << "local own\n"
           "function on_load() circle1.velocity = vec(2, 0) own = circle1.velocity end\n"
           "function on_update(dt)\n"
           "  local c = circle1\n"
           "  c.position = c.position + own * dt\n"
           "  local p, v, r = c.position, c.velocity, c.radius\n"
           "  if p.x + r > square.right or p.x - r < square.left then\n"
           "    c.velocity = vec(-v.x, v.y)\n"
           "  end\n"
           "  if p.y + r > square.top or p.y - r < square.bottom then\n"
           "    c.velocity = vec(c.velocity.x, -v.y)\n"
           "  end\n"
           "end"
        << kept;
    QTest::newRow("is put back for ever")
        << drifting(QStringLiteral("own = own or c.velocity\nc.position = c.position + own * dt\n"
                                   "c.velocity = own"),
                    QStringLiteral("local own\n"))
        << kept;
    // Without any: whoever moves away from a wall beside it does.
    QTest::newRow("goes on outward in every run")
        << drifting(QStringLiteral("local v = c.velocity\n"
                                   "if math.abs(c.position.x) > 3.7 and c.position.x * v.x < 0 "
                                   "then v = vec(-v.x, v.y) end\n"
                                   "c.position = c.position + v * dt"))
        << "So it goes in a run that begins there, too: look at what your program does with a "
           "circle that is at a wall and moves away from it.";
}

void TestNearWalls::aVelocityOfItsOwnIsTold()
{
    QFETCH(QString, program);
    QFETCH(QString, why);
    const auto all = findings("L42T2", program);
    QCOMPARE(all.size(), std::size_t{1});
    const QString &message = all.front().message;
    QVERIFY2(message.startsWith(QLatin1String("After hits at the ")), qPrintable(message));
    QVERIFY2(message.contains(QStringLiteral(" the way of circle 1 is not v Δt\n")),
             qPrintable(message));
    QVERIFY2(message.endsWith(why), qPrintable(message));
}

void TestNearWalls::gravityLeftOutAtTheFloorIsTold()
{
    const auto all = findings("L42T5", losing("1") + falling + QStringLiteral(R"lua(
local function fall(c, dt)
  if c.position.y - c.radius > square.bottom + 0.01 then
    c.velocity = c.velocity + gravity * dt
  end
end
function on_update(dt)
  local old1, old2 = circle1.position, circle2.position
  circle1.position = circle1.position + circle1.velocity * dt
  fall(circle1, dt)
  fall(circle2, dt)
  circle2.position = circle2.position + circle2.velocity * dt
  walls(circle1, old1)
  walls(circle2, old2)
end)lua"));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY2(all.front().message.startsWith(
                 QLatin1String("Gravity leaves out steps of both circles at the floor")),
             qPrintable(all.front().message));
}

void TestNearWalls::anOddFirstStepHidesTheWalls()
{
    const auto all = findings("L42T5", losing("1") + falling + QStringLiteral(R"lua(
local started = false
function on_update(dt)
  local old1, old2 = circle1.position, circle2.position
  circle1.position = circle1.position + circle1.velocity * dt
  circle1.velocity = circle1.velocity + gravity * dt
  local v = circle2.velocity
  circle2.velocity = v + gravity * dt
  circle2.position = circle2.position + (started and circle2.velocity or v) * dt
  started = true
  walls(circle1, old1)
  walls(circle2, old2)
end)lua"));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(all.front().message.startsWith(
        QLatin1String("The first step of circle 2 is made in another way")));
    QVERIFY(all.front().message.endsWith(
        QLatin1String("Until this is right, no more can be said of the walls.")));
}

/// A known mistake that speaks of every step is not true of it.
void TestNearWalls::anOddFirstStepIsNoKnownMistake()
{
    const auto all = findings("L42T3", losing("1") + falling + QStringLiteral(R"lua(
local started = false
function on_update(dt)
  local old, v = circle1.position, circle1.velocity
  circle1.velocity = v + gravity * dt
  circle1.position = old + (started and circle1.velocity or v) * dt
  started = true
  walls(circle1, old)
end)lua"));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY(all.front().mistake.isEmpty());
    QVERIFY2(all.front().message.contains(
                 QLatin1String("The first step of a run is made in another way.")),
             qPrintable(all.front().message));
}

void TestNearWalls::stepsInPartsAreNoFaultOfTheWalls()
{
    const auto all = findings("L42T3", losing("1") + falling + QStringLiteral(R"lua(
local rest, part = 0, 1 / 240
function on_update(dt)
  rest = rest + dt
  while rest >= part do
    rest = rest - part
    local old = circle1.position
    circle1.position = old + circle1.velocity * part
    circle1.velocity = circle1.velocity + gravity * part
    walls(circle1, old)
  end
end)lua"));
    QVERIFY(!all.empty());
    QVERIFY(std::none_of(all.begin(), all.end(), isOfWalls));
}

void TestNearWalls::aHundredthThatIsLostIsTold()
{
    const auto all = findings("L42T4", losing("0.99") + falling + QStringLiteral(R"lua(
function on_update(dt)
  for _, c in ipairs(circles) do
    local old = c.position
    c.position = old + c.velocity * dt
    c.velocity = c.velocity + gravity * dt
    walls(c, old)
  end
end)lua"));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY2(all.front().message.startsWith(
                 QLatin1String("Hits at the walls give both circles 0.99 times the speed back")),
             qPrintable(all.front().message));
}

void TestNearWalls::whatGoesWrongOneWayIsTold_data()
{
    QTest::addColumn<QString>("way");
    QTest::newRow("never down") << "vec(v.x, math.abs(v.y))";
    QTest::newRow("not so fast") << "vec(math.min(v.x, 2), math.min(v.y, 2))";
    QTest::newRow("half of the angles")
        << "vec(math.cos(math.atan(v.y / v.x)), math.sin(math.atan(v.y / v.x))) * v:length()";
}

/// Of the second, flights down or to the left, or fast ones, are wrong; the last stops at rest.
void TestNearWalls::whatGoesWrongOneWayIsTold()
{
    QFETCH(QString, way);
    const auto all =
        findings("L42T1", QStringLiteral("function on_load() circle1.velocity = vec(2, 0) end\n"
                                         "function on_update(dt) local v = circle1.velocity\n"
                                         "circle1.position = circle1.position + %1 * dt end")
                              .arg(way));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY2(
        all.front().message.startsWith(QStringLiteral("The way of circle 1 in a step is not v Δt")),
        qPrintable(all.front().message));
}

/// In this step the circles start at the same place, and nothing happens where they meet.
void TestNearWalls::aCircleThatIsNearIsTold()
{
    const auto all = findings("L42T4", losing("1") + falling + QStringLiteral(R"lua(
function on_update(dt)
  for _, c in ipairs(circles) do
    local old = c.position
    c.position = old + c.velocity * dt
    c.velocity = c.velocity + gravity * dt
    walls(c, old)
  end
  if (circle1.position - circle2.position):length() < circle1.radius + circle2.radius then
    circle2.velocity = -circle2.velocity
  end
end)lua"));
    QCOMPARE(all.size(), std::size_t{1});
    QVERIFY2(all.front().message.startsWith(
                 QLatin1String("Another circle that is near changes the velocity of circle 2")),
             qPrintable(all.front().message));
}

QTEST_GUILESS_MAIN(TestNearWalls)
#include "test_near_walls.moc"
