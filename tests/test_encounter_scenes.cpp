// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/runs/variant.h"

#include "tasks/runs/meeting_scene.h"
#include "tasks/runs/observation.h"

#include "tests/variant_scenes.h"

#include <map>
#include <set>

using namespace cradle;
using namespace cradle::programs;

/// Encounters: that circles 1 and 2 meet, from where, and by whose motion.
class TestEncounterScenes : public QObject
{
    Q_OBJECT
private slots:
    void encountersMeetInTheMiddle();
    void fastOnesBeginInTheSquare();
    void encountersComeFromAllSides();
    void someAreExactlyLevelOrUpright();
    void encountersTakeTurnsInWhoCatchesUp();
    void someMeetAgainInFrontOfAWall();
    void someMeetTwiceOnOneLine();
    void circlesOfOneDensityAreAmongThem();
    void restitutionsAndTimestepsAreMixed();
    void namesTellScenesApart();
};

namespace {

double directionOf(Vec2 v)
{
    return std::atan2(v.y, v.x) * 180.0 / scenes::pi;
}

} // namespace

void TestEncounterScenes::encountersMeetInTheMiddle()
{
    for (qint64 seed = 1; seed <= 20; ++seed) {
        for (const Variant &variant :
             makeVariants(odd(), spec(QStringLiteral("encounters")), seed)) {
            const Circle &a = variant.preset.circles[0].body;
            const Circle &b = variant.preset.circles[1].body;
            const Vec2 d = b.position - a.position;
            const Vec2 v = b.velocity - a.velocity;
            QVERIFY(length(v) >= 1.0 - 1e-12 && length(v) <= 4.0 + 1e-12);
            // |d + t v| = r₁ + r₂ for the first time, by the formula for quadratics.
            const double sum = a.radius + b.radius;
            const double half = dot(d, v) / lengthSquared(v);
            const double root = half * half - (lengthSquared(d) - sum * sum) / lengthSquared(v);
            QVERIFY2(root > 0.0, "they pass each other");
            const double t = -half - std::sqrt(root);
            QVERIFY(t >= 0.5 - 1e-9 && t <= 0.5 + variant.preset.timestep);
            const Vec2 place = a.position + t * a.velocity;
            QVERIFY(std::abs(place.x) <= 1.0 + 1e-9 && std::abs(place.y) <= 1.0 + 1e-9);
            // Off centre by at most 0.9 of the sum of the radii.
            QVERIFY(std::abs(cross(d, normalized(v))) <= 0.9 * sum + 1e-9);
        }
    }
}

/// Each of the two a millimetre from each wall at least, and some of them hardly more.
void TestEncounterScenes::fastOnesBeginInTheSquare()
{
    Preset preset = odd();
    preset.halfWidth = 4.0;
    SceneSpec fast;
    fast.speeds = {5.0, 6.0};
    fast.bothMove = true;
    fast.offset = 0.9;
    Random random(1);
    std::map<std::pair<std::size_t, Wall>, double> least;
    for (int i = 0; i < 10'000; ++i) {
        placeEncounter(preset, fast, i, random.between(0.0, 360.0), random);
        for (const std::size_t circle : {0U, 1U}) {
            const Circle &c = preset.circles[circle].body;
            for (const Wall wall : allWalls) {
                const double gap =
                    preset.halfWidth - c.radius - dot(c.position, outwardNormal(wall));
                double &known = least.try_emplace({circle, wall}, gap).first->second;
                known = std::min(known, gap);
            }
        }
    }
    QCOMPARE(least.size(), std::size_t{8});
    for (const auto &[of, gap] : least)
        QVERIFY2(gap >= 1e-3 - 1e-12 && gap < 8e-3, QByteArray::number(gap).constData());
}

void TestEncounterScenes::encountersComeFromAllSides()
{
    std::set<int> sectors;
    for (const Variant &variant : makeVariants(odd(), spec(QStringLiteral("encounters")), 1)) {
        const auto &c = variant.preset.circles;
        sectors.insert(static_cast<int>(
            (directionOf(c[1].body.position - c[0].body.position) + 180.0) / 45.0));
    }
    QVERIFY2(sectors.size() >= 7, qPrintable(QString::number(sectors.size())));
}

/// From all four sides, where they come head-on: one part of all differences is 0.
void TestEncounterScenes::someAreExactlyLevelOrUpright()
{
    CheckSpec headOn = spec(QStringLiteral("encounters"));
    headOn.scene.insert(QStringLiteral("offset"), 0.0);
    for (qint64 seed = 1; seed <= 3; ++seed) {
        std::set<std::pair<double, double>> sides;
        for (const Variant &variant : makeVariants(odd(), headOn, seed)) {
            const auto &c = variant.preset.circles;
            const Vec2 d = c[1].body.position - c[0].body.position;
            const Vec2 v = c[1].body.velocity - c[0].body.velocity;
            if ((d.x == 0.0 && v.x == 0.0) || (d.y == 0.0 && v.y == 0.0))
                sides.insert({d.x == 0.0 ? 0.0 : d.x / std::abs(d.x),
                              d.y == 0.0 ? 0.0 : d.y / std::abs(d.y)});
        }
        QCOMPARE(sides.size(), std::size_t{4});
    }
}

void TestEncounterScenes::encountersTakeTurnsInWhoCatchesUp()
{
    int byOne = 0;
    int byTwo = 0;
    int oneRests = 0;
    int twoRests = 0;
    for (const Variant &variant : makeVariants(odd(), spec(QStringLiteral("encounters")), 1)) {
        const Circle &a = variant.preset.circles[0].body;
        const Circle &b = variant.preset.circles[1].body;
        const double t = 0.5 + 0.5 * variant.preset.timestep;
        const Vec2 n = normalized(b.position - a.position + t * (b.velocity - a.velocity));
        byOne += dot(a.velocity, n) > 0.1 && dot(b.velocity, n) > 0.1 ? 1 : 0;
        byTwo += dot(a.velocity, n) < -0.1 && dot(b.velocity, n) < -0.1 ? 1 : 0;
        oneRests += a.velocity == Vec2{} ? 1 : 0;
        twoRests += b.velocity == Vec2{} ? 1 : 0;
    }
    QVERIFY(byOne >= 2 && byTwo >= 2 && oneRests >= 2 && twoRests >= 2);
}

void TestEncounterScenes::someMeetAgainInFrontOfAWall()
{
    CheckSpec again = spec(QStringLiteral("encounters"));
    again.scene.insert(QStringLiteral("gravity"), json({0.0, 0.0}));
    again.scene.insert(QStringLiteral("again"), true);
    Preset preset = odd();
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};
    for (PresetCircle &circle : preset.circles)
        circle.body.density = 1.0;
    std::set<double> twice; // restitutions
    for (const Variant &variant : makeVariants(preset, again, 1)) {
        if (!variant.name.contains(QLatin1String("in front of a wall")))
            continue;
        const Observation o = observe(variant);
        // How often the velocity of circle 1 changes, and when.
        std::vector<qint64> hits;
        for (qint64 k = 0; k < o.steps(); ++k) {
            const Vec2 push = o.circle(0, k + 1).velocity - o.circle(0, k).velocity;
            if (length(push) > 0.3)
                hits.push_back(k);
        }
        QVERIFY2(hits.size() >= 2, qPrintable(variant.name));
        twice.insert(variant.preset.restitution);
        QCOMPARE(o.circle(0, 0).radius, o.circle(1, 0).radius);
        // The line of centres has turned: who remembers the first is seen.
        const auto normalAt = [&](qint64 k) {
            return normalized(o.circle(1, k).position - o.circle(0, k).position);
        };
        QVERIFY(std::abs(cross(normalAt(hits[0]), normalAt(hits[1]))) > 0.05);
        // The scene is over soon after.
        QVERIFY(o.steps() - hits[1] < 60);
    }
    QVERIFY2(twice.size() >= 2, qPrintable(QString::number(twice.size())));
}

/// A wall may give back all of the speed or e times it; both times the second hit is seen, well
/// away from the wall, and nothing comes after it.
void TestEncounterScenes::someMeetTwiceOnOneLine()
{
    CheckSpec again = spec(QStringLiteral("encounters"));
    again.scene.insert(QStringLiteral("gravity"), json({0.0, 0.0}));
    again.scene.insert(QStringLiteral("again"), true);
    Preset preset = odd();
    preset.laws = {WallLaw::Reflect, CircleLaw::Impulse, Timing::Exact};
    int seen = 0;
    for (qint64 seed = 1; seed <= 20; ++seed) {
        for (const Variant &variant : makeVariants(preset, again, seed)) {
            if (!variant.name.contains(QLatin1String("on one line")))
                continue;
            ++seen;
            QVERIFY(variant.preset.restitution > 0.0);
            const Observation o = observe(variant);
            std::vector<qint64> hits;
            for (qint64 k = 0; k < o.steps(); ++k) {
                // Both at once: no wall.
                if (!(o.circle(0, k + 1).velocity == o.circle(0, k).velocity)
                    && !(o.circle(1, k + 1).velocity == o.circle(1, k).velocity))
                    hits.push_back(k);
            }
            QVERIFY2(hits.size() == 2, qPrintable(variant.name));
            QVERIFY(double(hits[1] - hits[0]) * o.timestep() > 0.14);
            QVERIFY(o.steps() - hits[1] >= 6);
            const auto lineAt = [&](qint64 k) {
                return normalized(o.circle(1, k).position - o.circle(0, k).position);
            };
            QVERIFY(length(lineAt(hits[0]) - lineAt(hits[1])) < 1e-9);
            for (int i : {0, 1}) {
                const Circle &c = o.circle(i, hits[1]);
                const double room =
                    4.0 - c.radius - std::max(std::abs(c.position.x), std::abs(c.position.y));
                QVERIFY2(room > 4.0 * length(c.velocity) * o.timestep(), qPrintable(variant.name));
            }
        }
    }
    QCOMPARE(seen, 40);
    // None under gravity, nor where a second hit is not asked for.
    again.scene.insert(QStringLiteral("gravity"), json({0.0, -9.81}));
    for (const CheckSpec &none : {again, spec(QStringLiteral("encounters"))}) {
        for (const Variant &variant : makeVariants(preset, none, 1))
            QVERIFY(!variant.name.contains(QLatin1String("on one line")));
    }
}

void TestEncounterScenes::circlesOfOneDensityAreAmongThem()
{
    int alike = 0;
    for (const Variant &variant : makeVariants(odd(), spec(QStringLiteral("encounters")), 1)) {
        const Circle &a = variant.preset.circles[0].body;
        const Circle &b = variant.preset.circles[1].body;
        alike += a.density == b.density && a.radius != b.radius ? 1 : 0;
    }
    QCOMPARE(alike, 1);
}

void TestEncounterScenes::restitutionsAndTimestepsAreMixed()
{
    std::set<std::pair<double, double>> pairs;
    for (const Variant &variant : makeVariants(odd(), spec(QStringLiteral("encounters")), 1))
        pairs.insert({variant.preset.restitution, variant.preset.timestep});
    QCOMPARE(pairs.size(), std::size_t{6});
}

void TestEncounterScenes::namesTellScenesApart()
{
    std::set<QString> names;
    const auto variants = makeVariants(odd(), spec(QStringLiteral("encounters")), 1);
    for (const Variant &variant : variants)
        names.insert(variant.name);
    QCOMPARE(names.size(), variants.size());
}

QTEST_GUILESS_MAIN(TestEncounterScenes)
#include "test_encounter_scenes.moc"
