// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/law_programs.h"

#include "tasks/judging/measured_wall.h"

#include <set>

using namespace cradle;
using namespace cradle::programs;

/// How circles are thrown at walls: so that every way of treating a wall shows itself there.
class TestWallScenes : public LabTest
{
    Q_OBJECT
private slots:
    void initTestCase() { read(shippedLab); }
    void throwsReachTheWallBetweenTwoSteps_data();
    void throwsReachTheWallBetweenTwoSteps();
    void throwsDifferInSpeedAndShare();
    void cornersAreReachedByBothRimsAtOnce();
    void othersAreInNobodysWay();
    void lobsComeToTheCeilingEverSlower();
    void dropsFallFromUnlikeHeights();
    void everyRestitutionIsSeen();

private:
    /// What is measured of a right program, in the step's own scenes.
    struct Seen {
        explicit Seen(const Task &task)
            : bench(task)
            , program(written(
                  {.walls =
                       wallsOf(wallWays[1], "c.radius",
                               bench.ground.walls.restitutions.size() > 1 ? "restitution" : "1")},
                  structures[1]))
            , laws(&program, bench.ground)
            , walls(laws.walls())
        {
        }
        const LawBench bench;
        const QString program;
        const MeasuredLaws laws;
        const MeasuredWalls &walls;
    };
};

namespace {

const Circle &thrown(const WallHit &hit)
{
    return hit.stage.preset.circles[static_cast<std::size_t>(hit.circle)].body;
}

/// The speed towards the wall that it was thrown with, m/s.
double speedOf(const WallHit &hit)
{
    return dot(thrown(hit).velocity, outwardNormal(hit.wall));
}

} // namespace

void TestWallScenes::throwsReachTheWallBetweenTwoSteps_data()
{
    QTest::addColumn<QString>("step");
    for (const char *step : {"L42T2", "L42T3", "L42T7", "L42T12", "L42T17"})
        QTest::newRow(step) << QString::fromLatin1(step);
}

/// From more than 2.4 radii away, so that nobody is there who takes the diameter; the rim is at the
/// wall a good part of a step after a state and before the next.
void TestWallScenes::throwsReachTheWallBetweenTwoSteps()
{
    QFETCH(QString, step);
    const Seen seen(task(step));
    QVERIFY(!seen.walls.hits.empty());
    for (const WallHit &hit : seen.walls.hits) {
        const double far =
            hit.stage.preset.halfWidth - dot(thrown(hit).position, outwardNormal(hit.wall));
        const double large = std::max(hit.radius, hit.otherRadius);
        QVERIFY(far > 2.4 * large && far < 2.4 * large + 0.11);
        QVERIFY(hit.turned && hit.step > 1);
        const double share = (hit.before - hit.radius) / hit.travel;
        QVERIFY2(0.03 < share && share < 0.97, QByteArray::number(share).constData());
        const Vec2 along = perpendicular(outwardNormal(hit.wall));
        QVERIFY(std::abs(std::abs(dot(thrown(hit).velocity, along)) / speedOf(hit) - 0.37) < 1e-9);
    }
}

void TestWallScenes::throwsDifferInSpeedAndShare()
{
    for (const auto &[step, fast, slow] :
         {std::tuple("L42T17", 2.9, 1.07), std::tuple("L42T3", 6.1, 4.7)}) {
        const Seen seen(task(QString::fromLatin1(step)));
        QCOMPARE(speedOf(seen.walls.hits[0]), fast);
        QCOMPARE(speedOf(seen.walls.hits[1]), slow);
        QCOMPARE(seen.walls.hits[0].wall, seen.walls.hits[1].wall);
    }
}

/// Without gravity within a step of each other, so that both parts must be turned at once.
void TestWallScenes::cornersAreReachedByBothRimsAtOnce()
{
    for (const char *step : {"L42T12", "L42T17"}) {
        const Seen seen(task(QString::fromLatin1(step)));
        QVERIFY(seen.walls.corners.size() >= 4);
        for (const WallHit &hit : seen.walls.corners) {
            const Vec2 n = outwardNormal(hit.wall);
            QVERIFY(std::abs(dot(thrown(hit).velocity, perpendicular(n)) - speedOf(hit)) < 1e-9);
            QVERIFY(hit.turned && hit.turnsBoth);
            QVERIFY(std::abs(hit.back - hit.restitution) < seen.walls.blur);
            // The other part is turned, too, in this step.
            QVERIFY2(hit.along < 0.0, QByteArray::number(hit.along).constData());
        }
    }
}

/// The other circle starts more than a metre from the walls and from the one that is thrown, and
/// along x and along y more than both radii from it: a program may ask for one of them alone.
void TestWallScenes::othersAreInNobodysWay()
{
    const Seen seen(task(QStringLiteral("L42T17")));
    for (const auto *hits : {&seen.walls.hits, &seen.walls.corners, &seen.walls.slow}) {
        for (const WallHit &hit : *hits) {
            for (std::size_t i = 0; i < hit.stage.preset.circles.size(); ++i) {
                if (static_cast<int>(i) == hit.circle)
                    continue;
                const Circle &other = hit.stage.preset.circles[i].body;
                QVERIFY(length(other.position - thrown(hit).position) > 1.0);
                QVERIFY(std::max(std::abs(other.position.x), std::abs(other.position.y)) < 2.8);
                const double across = dot(other.position, outwardNormal(hit.wall));
                QVERIFY(std::abs(across + 0.6) < 1e-9);
                const double along = dot(other.position, perpendicular(outwardNormal(hit.wall)));
                QVERIFY(std::abs(along - 0.4) < 1e-9);
                const Vec2 apart = other.position - thrown(hit).position;
                QVERIFY(std::min(std::abs(apart.x), std::abs(apart.y))
                        > other.radius + thrown(hit).radius);
                QVERIFY(other.velocity.x > 0.0 && other.velocity.y != 0.0
                        && other.velocity.x != other.velocity.y);
            }
            QVERIFY(!hit.disturbs);
        }
    }
}

/// What is left of their speed there are 0.2, 0.5, … of what gravity takes in a step: whoever asks
/// the old velocity or the new one, early or late, is caught by one of them.
void TestWallScenes::lobsComeToTheCeilingEverSlower()
{
    const Seen seen(task(QStringLiteral("L42T17")));
    std::vector<double> left;
    for (const Drop &drop : seen.walls.drops) {
        if (drop.wall != Wall::Top || drop.circle != 0)
            continue;
        const Preset &preset = drop.stage.preset;
        const Circle &c = preset.circles[0].body;
        const double gain = length(preset.gravity) * preset.timestep;
        left.push_back(c.velocity.y / gain - 1.0);
        // So far below the ceiling as that speed brings it in a step.
        const double gap = preset.halfWidth - c.radius - c.position.y;
        QVERIFY(std::abs(gap - left.back() * gain * preset.timestep) < 1e-12);
        QVERIFY(0.4 < c.velocity.x && c.velocity.x < 0.45);
        QCOMPARE(drop.again, 0);
        QCOMPARE(drop.step, 8); // nothing to see until the end
    }
    QCOMPARE(left.size(), 5U);
    for (std::size_t i = 0; i < left.size(); ++i)
        QVERIFY(std::abs(left[i] - 0.2 - 0.3 * static_cast<double>(i)) < 1e-9);
}

/// Three from a centimetre up, one after another 1.3 to 1.5 cm higher.
void TestWallScenes::dropsFallFromUnlikeHeights()
{
    const Seen seen(task(QStringLiteral("L42T17")));
    std::vector<double> heights;
    double least = 1.0;
    bool hop = false; // one is above the floor in the end
    for (const Drop &drop : seen.walls.drops) {
        if (drop.wall != Wall::Bottom || drop.circle != 0)
            continue;
        const Preset &preset = drop.stage.preset;
        const Circle &c = preset.circles[0].body;
        heights.push_back(preset.halfWidth - c.radius + c.position.y);
        least = std::min(least, drop.restitution);
        QVERIFY(0.4 < c.velocity.x && c.velocity.x < 0.45 && c.velocity.y == 0.0);
        QVERIFY(std::abs(drop.depth) < 0.05);
        hop |= drop.depth < 0.0;
        QCOMPARE(drop.step, 70);
    }
    QCOMPARE(heights.size(), 4U);
    QVERIFY(0.01 < heights[0] && heights[0] < 0.0115);
    for (const std::size_t i : {1U, 2U})
        QVERIFY(heights[i] - heights[i - 1] > 0.013 && heights[i] - heights[i - 1] < 0.015);
    QCOMPARE(heights[3], heights[1]);
    QVERIFY(least < 1.0 && hop);
}

void TestWallScenes::everyRestitutionIsSeen()
{
    const Seen seen(task(QStringLiteral("L42T17")));
    std::set<double> met;
    std::set<Wall> withLosses;
    for (const WallHit &hit : seen.walls.hits) {
        met.insert(hit.restitution);
        if (hit.restitution < 1.0)
            withLosses.insert(hit.wall);
    }
    for (const double e : seen.bench.ground.walls.restitutions)
        QVERIFY(met.count(e) == 1);
    QCOMPARE(withLosses.size(), 4U);
}

QTEST_GUILESS_MAIN(TestWallScenes)
#include "test_wall_scenes.moc"
