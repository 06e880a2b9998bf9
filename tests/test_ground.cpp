// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/ground.h"

#include "tests/check_spec.h"

#include <QJsonArray>
#include <QTest>

using namespace cradle;

/// What the checks of a step ask for, and where it is measured.
class TestGround : public QObject
{
    Q_OBJECT
private slots:
    void onlyChecksOfWallsAskForWalls_data();
    void onlyChecksOfWallsAskForWalls();
    void onlyChecksOfHitsAskForAPair_data();
    void onlyChecksOfHitsAskForAPair();
    void gravityIsThatOfTheSceneThatPasses();
    void rangesOfAllChecksAreTaken();
    void nobodyIsInTheWayOnTheStage();
};

namespace {

constexpr const char *kinds[] = {"bounces",  "bounce_heights", "stays_inside", "settles",
                                 "collides", "rebounds",       "touches",      "conserves",
                                 "start",    "integrates",     "together"};

Task taskWith(std::vector<CheckSpec> checks)
{
    Task task;
    task.preset.gravity = {0.0, -9.81};
    task.checks = std::move(checks);
    return task;
}

CheckSpec inScene(const char *kind, const QJsonObject &scene, std::vector<int> circles)
{
    CheckSpec check = checkOf(kind, {}, std::move(circles));
    check.scene = scene;
    return check;
}

} // namespace

void TestGround::onlyChecksOfWallsAskForWalls_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<bool>("asks");
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        QTest::newRow(kinds[i]) << QString::fromLatin1(kinds[i]) << (i < 4);
}

void TestGround::onlyChecksOfWallsAskForWalls()
{
    QFETCH(QString, kind);
    QFETCH(bool, asks);
    const Task task = taskWith({checkOf(kind.toLatin1().constData(), {}, {1, 0})});
    const Ground ground(task, task.preset);
    QCOMPARE(ground.walls.circles, asks ? (std::vector<int>{1, 0}) : std::vector<int>{});
    QCOMPARE(ground.walls.restitutions, std::vector<double>{1.0});
}

void TestGround::onlyChecksOfHitsAskForAPair_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<bool>("asks");
    for (std::size_t i = 0; i < std::size(kinds); ++i)
        QTest::newRow(kinds[i]) << QString::fromLatin1(kinds[i]) << (i >= 4 && i < 8);
}

void TestGround::onlyChecksOfHitsAskForAPair()
{
    QFETCH(QString, kind);
    QFETCH(bool, asks);
    const Task task = taskWith({checkOf(kind.toLatin1().constData(), {}, {0})});
    const Ground ground(task, task.preset);
    QCOMPARE(ground.pair.asked, asks);
    QCOMPARE(ground.flights.size(), asks ? 2U : 1U);
    QCOMPARE(ground.sameIntegrator, kind == QLatin1String("together"));
}

/// What the solution makes of the scene, be it a program or a scene.
void TestGround::gravityIsThatOfTheSceneThatPasses()
{
    Task task = taskWith({checkOf("integrates", {})});
    const auto own = [&] { return Ground(task, task.preset).gravities.front(); };
    QCOMPARE(own(), (Vec2{0.0, -9.81}));
    task.solutionScene = task.preset;
    task.solutionScene->gravity = {0.0, -1.62};
    QCOMPARE(own(), (Vec2{0.0, -1.62}));
    task.solution = QStringLiteral("function on_load() gravity = vec(0, -3.5) end");
    QCOMPARE(own(), (Vec2{0.0, -3.5}));
    // One that stops has made nothing of it.
    task.solution = QStringLiteral("function on_load() gravity = vec(0, -3.5) error('no') end");
    QCOMPARE(own(), (Vec2{0.0, -1.62}));
    task.solution.clear();
    // An edition for students has only what the checks say.
    task.forStudents = true;
    QCOMPARE(own(), (Vec2{0.0, -9.81}));
    task.checks.front().parameters.insert(QStringLiteral("gravity"), QJsonArray{0.0, -3.7});
    QCOMPARE(own(), (Vec2{0.0, -3.7}));
}

void TestGround::rangesOfAllChecksAreTaken()
{
    const QJsonObject first{{QStringLiteral("kind"), QStringLiteral("encounters")},
                            {QStringLiteral("radii"), QJsonArray{0.15, 0.2}},
                            {QStringLiteral("densities"), QJsonArray{1.0, 9.0}},
                            {QStringLiteral("restitutions"), QJsonArray{1.0, 0.5}},
                            {QStringLiteral("both_move"), true}};
    const QJsonObject second{{QStringLiteral("kind"), QStringLiteral("encounters")},
                             {QStringLiteral("radii"), QJsonArray{0.2, 0.3}},
                             {QStringLiteral("restitutions"), QJsonArray{0.5, 0.8}},
                             {QStringLiteral("timesteps"), QJsonArray{0.01, 0.02}},
                             {QStringLiteral("offset"), 0.6}};
    Task task =
        taskWith({inScene("collides", first, {0, 1}), inScene("conserves", second, {0, 1})});
    const Ground ground(task, task.preset);
    QCOMPARE(ground.pair.radii.low, 0.15);
    QCOMPARE(ground.pair.radii.high, 0.3);
    QCOMPARE(ground.pair.densities.low, 1.0);
    QCOMPARE(ground.pair.densities.high, 9.0);
    QCOMPARE(ground.pair.restitutions, (std::vector{1.0, 0.5, 0.8}));
    QVERIFY(ground.pair.bothMove);
    QVERIFY(ground.pair.oblique);
    QCOMPARE(ground.timesteps, (std::vector{1.0 / 60.0, 0.01, 0.02}));
    QCOMPARE(ground.stage().timestep, 1.0 / 60.0);
    // Two gravities, the own one first.
    QCOMPARE(ground.gravities, (std::vector{Vec2{0.0, -9.81}, Vec2{}}));
}

/// Twenty: more than 0.65 m from each other (the four in the middle 2.5 m), and 0.7 m from the
/// walls.
void TestGround::nobodyIsInTheWayOnTheStage()
{
    std::vector<int> circles(20);
    for (int i = 0; i < 20; ++i)
        circles[static_cast<std::size_t>(i)] = i;
    const Task task = taskWith({checkOf("integrates", {}, circles)});
    const Preset stage = Ground(task, task.preset).stage();
    QCOMPARE(stage.circles.size(), 20U);
    QCOMPARE(stage.halfWidth, 4.0);
    QCOMPARE(stage.gravity, Vec2{});
    for (std::size_t i = 0; i < 20; ++i) {
        const Vec2 place = stage.circles[i].body.position;
        QVERIFY(std::max(std::abs(place.x), std::abs(place.y)) < 3.3);
        for (std::size_t j = 0; j < i; ++j) {
            const Vec2 other = stage.circles[j].body.position;
            const double least = i < 4 ? 2.5 : 0.65;
            QVERIFY2(length(place - other) > least,
                     QByteArray::number(length(place - other)).constData());
        }
    }
}

QTEST_APPLESS_MAIN(TestGround)
#include "test_ground.moc"
