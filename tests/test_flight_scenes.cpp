// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/judging/flight_scenes.h"

#include "tests/check_spec.h"

#include <QTest>

#include <algorithm>

using namespace cradle;
using namespace cradle::flights;

/// How circles start where their free motion is measured: so that nothing is taken for another.
class TestFlightScenes : public QObject
{
    Q_OBJECT
private slots:
    void noTwoPartsAreAlike();
    void noTwoVelocitiesHaveARatioInCommon();
    void fastIsFastAndFallingFalls();
    void onlyTheShiftedAreElsewhere();
    void onlyOneMovesAlone();
    void stateIsThatOfTheSecondStep();
    void lateRunsKnowThatTheyAreLate();

private:
    [[nodiscard]] std::vector<Vec2> velocities(Scene scene) const;
};

namespace {

/// A step that looks at \p count circles.
Ground groundOf(int count)
{
    std::vector<int> circles;
    for (int i = 0; i < count; ++i)
        circles.push_back(i);
    Task task;
    task.checks = {checkOf("integrates", {}, circles)};
    return Ground(task, task.preset);
}

Preset flightOf(Scene scene, int count = 4, std::size_t mover = 0)
{
    return flightPreset(groundOf(count), {0.0, -9.81}, 0.01, scene, mover);
}

} // namespace

std::vector<Vec2> TestFlightScenes::velocities(Scene scene) const
{
    std::vector<Vec2> found;
    for (const PresetCircle &circle : flightOf(scene).circles)
        found.push_back(circle.body.velocity);
    return found;
}

/// Of sixteen sizes between 0.35 and 1.45 m/s no two are nearer than 0.039 m/s: who copies a part
/// of another circle, or another part, is not taken for right.
void TestFlightScenes::noTwoPartsAreAlike()
{
    std::vector<double> sizes;
    for (const Scene scene : {Scene::First, Scene::Second}) {
        for (const Vec2 v : velocities(scene)) {
            sizes.push_back(std::abs(v.x));
            sizes.push_back(std::abs(v.y));
        }
    }
    QCOMPARE(sizes.size(), 16U);
    std::sort(sizes.begin(), sizes.end());
    QVERIFY(sizes.front() > 0.35 && sizes.back() < 1.45);
    for (std::size_t i = 1; i < sizes.size(); ++i)
        QVERIFY2(sizes[i] - sizes[i - 1] > 0.039, QByteArray::number(sizes[i]).constData());
}

/// Not within a hundredth: of y to x, nor from the first flight to the second.
void TestFlightScenes::noTwoVelocitiesHaveARatioInCommon()
{
    std::vector<double> slopes;
    for (const Scene scene : {Scene::First, Scene::Second}) {
        for (const Vec2 v : velocities(scene))
            slopes.push_back(v.y / v.x);
    }
    std::sort(slopes.begin(), slopes.end());
    for (std::size_t i = 1; i < slopes.size(); ++i)
        QVERIFY2(slopes[i] - slopes[i - 1] > 0.01, QByteArray::number(slopes[i]).constData());
    // A crowd has velocities of its own, too.
    const Preset crowd = flightOf(Scene::First, 8);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 early = crowd.circles[i].body.velocity;
        const Vec2 late = crowd.circles[i + 4].body.velocity;
        QVERIFY(late.x / early.x > 1.1 && late.x / early.x < 1.12);
        QVERIFY(late.y / early.y > 0.92 && late.y / early.y < 0.94);
    }
}

void TestFlightScenes::fastIsFastAndFallingFalls()
{
    const std::vector<Vec2> first = velocities(Scene::First);
    const std::vector<Vec2> second = velocities(Scene::Second);
    const std::vector<Vec2> fast = velocities(Scene::Fast);
    const std::vector<Vec2> falling = velocities(Scene::Falling);
    for (std::size_t i = 0; i < first.size(); ++i) {
        QCOMPARE(fast[i], 5.0 * first[i]);
        QCOMPARE(falling[i].x, second[i].x);
        QCOMPARE(falling[i].y, -9.0 - std::abs(first[i].x));
        QCOMPARE(velocities(Scene::Rest)[i], Vec2{});
    }
}

void TestFlightScenes::onlyTheShiftedAreElsewhere()
{
    const Preset rest = flightOf(Scene::Rest);
    QCOMPARE(rest.gravity, (Vec2{0.0, -9.81}));
    QCOMPARE(rest.timestep, 0.01);
    for (const Scene scene :
         {Scene::First, Scene::Second, Scene::Shifted, Scene::Alone, Scene::Fast, Scene::Falling}) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec2 moved =
                flightOf(scene).circles[i].body.position - rest.circles[i].body.position;
            const Vec2 wanted = scene == Scene::Shifted ? Vec2{0.31, -0.23} : Vec2{};
            QVERIFY(length(moved - wanted) < 1e-12);
        }
    }
}

void TestFlightScenes::onlyOneMovesAlone()
{
    const std::vector<Vec2> first = velocities(Scene::First);
    for (std::size_t mover = 0; mover < 4; ++mover) {
        const Preset alone = flightOf(Scene::Alone, 4, mover);
        for (std::size_t i = 0; i < 4; ++i)
            QCOMPARE(alone.circles[i].body.velocity, i == mover ? first[i] : Vec2{});
    }
}

/// The program counts its steps in a velocity.
void TestFlightScenes::stateIsThatOfTheSecondStep()
{
    const QString counts = QStringLiteral("function on_update(h) "
                                          "circle1.velocity = circle1.velocity + vec(1, 0) end");
    const Steps steps = fly(&counts, flightOf(Scene::Rest));
    QVERIFY(steps.made);
    QCOMPARE(steps.start[0].velocity, Vec2{});
    QCOMPARE(steps.before[0].velocity, (Vec2{1.0, 0.0}));
    QCOMPARE(steps.after[0].velocity, (Vec2{2.0, 0.0}));
    const QString stops = QStringLiteral("function on_update(h) if circle1.velocity.x > 0 then "
                                         "error('no') end circle1.velocity = vec(1, 0) end");
    QVERIFY(!fly(&stops, flightOf(Scene::Rest)).made);
    QCOMPARE(fly(&stops, flightOf(Scene::Rest)).before.size(), 4U);
}

/// What a program is told of the time, and where it is before its first step.
void TestFlightScenes::lateRunsKnowThatTheyAreLate()
{
    const QString tells = QStringLiteral("function on_update(h) circle1.velocity = "
                                         "vec(time, step) end");
    const Steps early = fly(&tells, flightOf(Scene::Rest));
    const Steps late = fly(&tells, flightOf(Scene::Rest), lateSteps);
    QVERIFY(early.made && late.made);
    const Vec2 apart = late.after[0].velocity - early.after[0].velocity;
    QVERIFY(length(apart - Vec2{0.97, 97.0}) < 1e-9);
}

QTEST_APPLESS_MAIN(TestFlightScenes)
#include "test_flight_scenes.moc"
