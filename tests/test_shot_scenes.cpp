// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/variant.h"

#include "tasks/runs/observation.h"
#include "tasks/runs/shot_scene.h"

#include "tests/programs.h"
#include "tests/scenes.h"

#include <algorithm>
#include <set>

using namespace cradle;
using namespace cradle::programs;

/// Shots at the walls: from places that no program knows, surely at a wall, and with the other
/// circle on its way meanwhile.
class TestShotScenes : public QObject
{
    Q_OBJECT
private slots:
    void directionsShootEachCircleClearOfTheOther();
    void whoDriftsLeavesTheWallOfTheShot();
    void whoIsShotHasQuiteAnotherRadius();
    void shotsBeginAtUnknownPlaces();
    void everyShotComesToAWallInTime_data();
    void everyShotComesToAWallInTime();
    void cornersAreAimedAt();
    void shotsAreNamedByTheirDirection_data();
    void shotsAreNamedByTheirDirection();
    void slowHitsDivideAStep();
    void someAreLetGoLow();
    void whatDriftsFliesAsLongAsTheSquareAllows();
};

namespace {

Preset two()
{
    Preset preset = scene({Circle{}, Circle{.position = {1.0, 1.0}}});
    preset.laws.circles = CircleLaw::None;
    return preset;
}

/// Twelve scenes, long enough and without gravity.
CheckSpec shots(const QString &kind)
{
    CheckSpec made = check("bounces", {0, 1});
    made.scene = {{QStringLiteral("kind"), kind},
                  {QStringLiteral("count"), 12},
                  {QStringLiteral("duration"), 4},
                  {QStringLiteral("timesteps"), QJsonArray{1.0 / 60.0, 1.0 / 120.0}},
                  {QStringLiteral("speeds"), QJsonArray{1.0, 4.0}},
                  {QStringLiteral("radii"), QJsonArray{0.1, 0.4}}};
    return made;
}

double directionOf(Vec2 v)
{
    return std::atan2(v.y, v.x) * 180.0 / scenes::pi;
}

/// The circle that is shot, by the scene's name: the other drifts.
std::size_t shotOf(const Variant &variant)
{
    return variant.name.startsWith(QLatin1String("circle 1 ")) ? 0 : 1;
}

} // namespace

void TestShotScenes::directionsShootEachCircleClearOfTheOther()
{
    const CheckSpec floating = shots(QStringLiteral("directions"));
    std::set<int> quadrants;
    for (qint64 seed = 1; seed <= 10; ++seed) {
        const auto variants = makeVariants(two(), floating, seed);
        QCOMPARE(variants.size(), std::size_t{24});
        std::size_t slow = 0;
        std::set<int> slowWalls;
        for (const Variant &variant : variants) {
            const auto &c = variant.preset.circles;
            const std::size_t shot = shotOf(variant);
            QVERIFY(length(c[1 - shot].body.velocity) > 0.2);
            const double speed = length(c[shot].body.velocity);
            QVERIFY2(variant.name.startsWith(
                         QStringLiteral("circle %1 towards ").arg(shot == 0 ? 1 : 2)),
                     qPrintable(variant.name));
            // Four of each circle are so slow that a program could take it for rest.
            const double direction = directionOf(c[shot].body.velocity);
            if (speed < 0.5) {
                ++slow;
                slowWalls.insert(static_cast<int>((direction + 405.0) / 90.0) % 4);
            } else
                QVERIFY2(speed >= 1.0 - 1e-12 && speed <= 4.0 + 1e-12, qPrintable(variant.name));
            QVERIFY(speed >= 0.15);
            quadrants.insert(static_cast<int>((direction + 180.0) / 90.0));
            const Observation o = observe(variant);
            for (qint64 k = 0; k <= o.steps(); ++k) {
                const double apart = length(o.circle(1, k).position - o.circle(0, k).position);
                QVERIFY2(apart > c[0].body.radius + c[1].body.radius, qPrintable(variant.name));
                const Vec2 other = o.circle(static_cast<int>(1 - shot), k).velocity;
                QVERIFY2(other == c[1 - shot].body.velocity, "what drifts comes to a wall");
            }
        }
        QCOMPARE(slow, std::size_t{8});
        QCOMPARE(slowWalls.size(), std::size_t{4});
    }
    QCOMPARE(quadrants.size(), std::size_t{4});
}

/// A wall that asks for the velocity of the other circle answers nothing then.
void TestShotScenes::whoDriftsLeavesTheWallOfTheShot()
{
    for (qint64 seed = 1; seed <= 20; ++seed) {
        std::set<std::pair<std::size_t, std::pair<int, int>>>
            left; // who is shot, away from which wall
        for (const Variant &variant :
             makeVariants(two(), shots(QStringLiteral("directions")), seed)) {
            const std::size_t shot = shotOf(variant);
            const Vec2 drift = variant.preset.circles[1 - shot].body.velocity;
            const Observation o = observe(variant);
            bool first = true;
            for (qint64 k = 0; k < o.steps(); ++k) {
                const int index = static_cast<int>(shot);
                const Vec2 kick = o.circle(index, k + 1).velocity - o.circle(index, k).velocity;
                if (kick == Vec2{})
                    continue;
                if (first)
                    QVERIFY2(dot(drift, kick) > 0.0, qPrintable(variant.name));
                first = false;
                if (dot(drift, kick) > 0.0)
                    left.insert({shot,
                                 {kick.x > 0.0   ? 1
                                  : kick.x < 0.0 ? -1
                                                 : 0,
                                  kick.y > 0.0   ? 1
                                  : kick.y < 0.0 ? -1
                                                 : 0}});
            }
            QVERIFY2(!first, qPrintable(variant.name));
        }
        for (const std::size_t shot : {std::size_t{0}, std::size_t{1}})
            for (const auto &wall : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
                QVERIFY(left.contains({shot, wall}));
    }
}

/// A wall that takes the radius of the other circle turns by more than a step too early or late.
void TestShotScenes::whoIsShotHasQuiteAnotherRadius()
{
    CheckSpec check = shots(QStringLiteral("directions"));
    check.scene.insert(QStringLiteral("radii"), QJsonArray{0.12, 0.45});
    std::set<std::pair<std::size_t, bool>> seen;
    for (qint64 seed = 1; seed <= 10; ++seed) {
        for (const Variant &variant : makeVariants(two(), check, seed)) {
            const std::size_t shot = shotOf(variant);
            const double own = variant.preset.circles[shot].body.radius;
            const double other = variant.preset.circles[1 - shot].body.radius;
            QVERIFY2(std::abs(own - other) > 4.0 / 30.0, qPrintable(variant.name));
            QVERIFY(std::min(own, other) >= 0.12 && std::max(own, other) <= 0.45);
            seen.insert({shot, own > other});
        }
    }
    QCOMPARE(seen.size(), std::size_t{4});
}

void TestShotScenes::shotsBeginAtUnknownPlaces()
{
    std::set<double> places;
    std::size_t fromTheMiddle = 0;
    const auto variants = makeVariants(two(), shots(QStringLiteral("directions")), 1);
    for (const Variant &variant : variants) {
        const Vec2 place = variant.preset.circles[shotOf(variant)].body.position;
        places.insert(place.x);
        fromTheMiddle += place == Vec2{} ? 1 : 0;
    }
    // The first of each circle is the one that a program could know.
    QCOMPARE(fromTheMiddle, std::size_t{2});
    QCOMPARE(places.size(), variants.size() - 1);
}

void TestShotScenes::everyShotComesToAWallInTime_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<Vec2>("gravity");
    QTest::addColumn<Vec2>("speeds");
    QTest::newRow("directions") << QStringLiteral("directions") << Vec2{} << Vec2{1.0, 4.0};
    QTest::newRow("corners") << QStringLiteral("corners") << Vec2{} << Vec2{1.0, 4.0};
    QTest::newRow("under gravity")
        << QStringLiteral("directions") << Vec2{0.0, -9.81} << Vec2{9.0, 11.0};
}

void TestShotScenes::everyShotComesToAWallInTime()
{
    QFETCH(QString, kind);
    QFETCH(Vec2, gravity);
    QFETCH(Vec2, speeds);
    CheckSpec check = shots(kind);
    check.circles = {0};
    check.scene.insert(QStringLiteral("gravity"), json(gravity));
    check.scene.insert(QStringLiteral("speeds"), json(speeds));
    check.scene.insert(QStringLiteral("duration"), gravity == Vec2{} ? 4 : 2);
    for (qint64 seed = 1; seed <= 10; ++seed) {
        for (const Variant &variant : makeVariants(scene({Circle{}}), check, seed)) {
            const Observation o = observe(variant);
            bool turned = false;
            for (qint64 k = 0; k < 7 * o.steps() / 10; ++k) {
                const Vec2 kick =
                    o.circle(0, k + 1).velocity - o.circle(0, k).velocity - o.timestep() * gravity;
                turned = turned || length(kick) > 0.1; // of 0.15 m/s and more
            }
            QVERIFY2(turned, qPrintable(variant.name));
        }
    }
}

void TestShotScenes::cornersAreAimedAt()
{
    for (const Variant &variant : makeVariants(two(), shots(QStringLiteral("corners")), 1)) {
        const Circle &c = variant.preset.circles[shotOf(variant)].body;
        const double room = 4.0 - c.radius;
        const Vec2 corner{std::copysign(room, c.velocity.x), std::copysign(room, c.velocity.y)};
        const double off = std::abs(directionOf(c.velocity) - directionOf(corner - c.position));
        QVERIFY2(off < 5.0, qPrintable(QString::number(off)));
    }
}

void TestShotScenes::shotsAreNamedByTheirDirection_data()
{
    QTest::addColumn<QString>("kind");
    QTest::newRow("directions") << QStringLiteral("directions");
    QTest::newRow("corners") << QStringLiteral("corners");
}

/// "circle 1 towards 45.0°", from 0 to 360.
void TestShotScenes::shotsAreNamedByTheirDirection()
{
    QFETCH(QString, kind);
    for (const Variant &variant : makeVariants(two(), shots(kind), 1)) {
        const auto &c = variant.preset.circles;
        const QString told =
            variant.name.section(QStringLiteral(" towards "), 1).section(QChar(0xb0), 0, 0);
        bool isNumber = false;
        const double degrees = told.toDouble(&isNumber);
        QVERIFY2(isNumber && degrees >= 0.0 && degrees <= 360.0, qPrintable(variant.name));
        const double error =
            std::remainder(degrees - directionOf(c[shotOf(variant)].body.velocity), 360.0);
        QVERIFY2(std::abs(error) < 0.051, qPrintable(variant.name));
    }
}

void TestShotScenes::slowHitsDivideAStep()
{
    CheckSpec slow = shots(QStringLiteral("slow"));
    slow.circles = {0};
    slow.scene.insert(QStringLiteral("gravity"), json({0.0, -9.81}));
    slow.scene.insert(QStringLiteral("timesteps"), QJsonArray{1.0 / 30.0});
    for (qint64 seed = 1; seed <= 10; ++seed) {
        std::vector<double> moments[2]; // at the floor and at the ceiling, in steps
        for (const Variant &variant : makeVariants(scene({Circle{}}), slow, seed)) {
            const Circle &c = variant.preset.circles[0].body;
            if (c.velocity.y == 0.0) // to a wall beside
                continue;
            const bool up = c.velocity.y > 0.0;
            const double gap = 4.0 - c.radius - std::abs(c.position.y);
            // With the velocity that gravity will have given it after three steps.
            const double speed = std::abs(c.velocity.y - 3.0 * 9.81 / 30.0);
            QVERIFY(speed > 3.0 * 9.81 / 30.0 && speed < 4.5 * 9.81 / 30.0);
            moments[up ? 1 : 0].push_back(gap / (speed / 30.0));
        }
        for (std::vector<double> &each : moments) {
            QCOMPARE(each.size(), std::size_t{6});
            std::sort(each.begin(), each.end());
            for (std::size_t i = 1; i < each.size(); ++i)
                QVERIFY(std::abs(each[i] - each[i - 1] - 1.0 / 6.0) < 1e-9);
        }
    }
}

/// v² = 2 g h, in what gravity makes in a step.
void TestShotScenes::someAreLetGoLow()
{
    CheckSpec slow = shots(QStringLiteral("slow"));
    slow.circles = {0};
    slow.scene.insert(QStringLiteral("gravity"), json({0.0, -9.81}));
    std::vector<double> speeds;
    double slowest = 10.0; // m/s
    for (const Variant &variant : makeVariants(scene({Circle{}}), slow, 1)) {
        const Circle &c = variant.preset.circles[0].body;
        if (!(c.velocity == Vec2{}))
            continue;
        const double speed = std::sqrt(2.0 * 9.81 * (c.position.y + 4.0 - c.radius));
        speeds.push_back(speed / (9.81 * variant.preset.timestep));
        slowest = std::min(slowest, speed);
        const double after = (variant.duration - speed / 9.81) / variant.preset.timestep;
        QVERIFY(after > 5.0 && after < 7.0);
    }
    QCOMPARE(speeds.size(), std::size_t{3});
    for (const double speed : speeds)
        QVERIFY(speed > 3.5 && speed < 12.0);
    QVERIFY(slowest < 0.45);
    // Where nothing pulls, nothing would come.
    slow.scene.remove(QStringLiteral("gravity"));
    for (const Variant &variant : makeVariants(scene({Circle{}}), slow, 1))
        QVERIFY(!(variant.preset.circles[0].body.velocity == Vec2{}));
}

/// Thrown up and back again under gravity over four fifths of the height: h = g t² / 8.
void TestShotScenes::whatDriftsFliesAsLongAsTheSquareAllows()
{
    constexpr double g = 9.81;
    CheckSpec check = shots(QStringLiteral("directions"));
    check.scene.insert(QStringLiteral("gravity"), json({0.0, -g}));
    check.scene.insert(QStringLiteral("speeds"), json({9.0, 11.0}));
    for (qint64 seed = 1; seed <= 10; ++seed) {
        for (const Variant &variant : makeVariants(two(), check, seed)) {
            const Circle &c = variant.preset.circles[1 - shotOf(variant)].body;
            const double height = 0.8 * 2.0 * (4.0 - c.radius);
            const double flight = std::sqrt(8.0 * height / g);
            QVERIFY(flight < variant.duration);
            QVERIFY2(timeToWall(variant.preset, c) > flight - 1e-9, qPrintable(variant.name));
            QVERIFY(std::abs(c.velocity.y - 0.5 * g * flight) < 0.9 + 1e-9);
        }
    }
}

QTEST_GUILESS_MAIN(TestShotScenes)
#include "test_shot_scenes.moc"
