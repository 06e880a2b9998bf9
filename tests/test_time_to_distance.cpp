// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_paths.h"
#include "model/contacts/collision_detection.h"

#include "tests/scenes.h"

using namespace cradle;
using namespace cradle::scenes;

namespace {

long double squaredGap(const Path &a, const Path &b, double distance, long double s)
{
    const auto l = [](double value) { return static_cast<long double>(value); };
    const auto difference = [&](double p, double v, double k) {
        return l(p) + s * (l(v) + s * l(k));
    };
    const long double x = difference(b.position.x, b.velocity.x, b.curve.x)
                          - difference(a.position.x, a.velocity.x, a.curve.x);
    const long double y = difference(b.position.y, b.velocity.y, b.curve.y)
                          - difference(a.position.y, a.velocity.y, a.curve.y);
    return x * x + y * y - l(distance) * l(distance);
}

/// The first contact by scanning [0, end] and halving the interval found; needs no algebra.
double contactByScan(const Path &a, const Path &b, double distance, double end)
{
    constexpr int samples = 200'000;
    long double low = 0.0L;
    for (int i = 1; i <= samples; ++i) {
        long double high = static_cast<long double>(end) * i / samples;
        if (squaredGap(a, b, distance, low) > 0.0L && squaredGap(a, b, distance, high) <= 0.0L) {
            for (int k = 0; k < 80; ++k) {
                const long double middle = 0.5L * (low + high);
                (squaredGap(a, b, distance, middle) > 0.0L ? low : high) = middle;
            }
            return static_cast<double>(high);
        }
        low = high;
    }
    return never;
}

Vec2 quarterTurns(Vec2 v, int count)
{
    for (int i = 0; i < count; ++i)
        v = {-v.y, v.x};
    return v;
}

Path quarterTurns(const Path &p, int count)
{
    return {quarterTurns(p.position, count), quarterTurns(p.velocity, count),
            quarterTurns(p.curve, count)};
}

} // namespace

/// The moment when two paths come within a distance.
class TestTimeToDistance : public QObject
{
    Q_OBJECT
private slots:
    void timeToDistanceMatchesHandWorkedCase_data();
    void timeToDistanceMatchesHandWorkedCase();
    void timeToDistanceMatchesAScan_data();
    void timeToDistanceMatchesAScan();
    void timeToDistanceDoesNotDependOnTheDirection_data();
    void timeToDistanceDoesNotDependOnTheDirection();
    void timeToDistanceIsTheSameSeenFromTheOther();
    void theFirstOfTwoApproachesCounts();
};

void TestTimeToDistance::timeToDistanceMatchesHandWorkedCase_data()
{
    QTest::addColumn<Path>("a");
    QTest::addColumn<Path>("b");
    QTest::addColumn<double>("end");
    QTest::addColumn<double>("time"); // at which they are 1 m apart
    const Path resting{};
    QTest::newRow("head-on") << Path{{-4, 0}, {2, 0}} << resting << 9.0 << 1.5;
    QTest::newRow("both moving") << Path{{-2, 0}, {1, 0}} << Path{{2, 0}, {-2, 0}} << 9.0 << 1.0;
    // Contact where dx² = 1 − 0.6²: 0.8 before the centre.
    QTest::newRow("glancing, 3-4-5") << Path{{-2, 0.6}, {1, 0}} << resting << 9.0 << 1.2;
    QTest::newRow("just at the end") << Path{{-4, 0}, {2, 0}} << resting << 1.5 << 1.5;
    QTest::newRow("after the end") << Path{{-4, 0}, {2, 0}} << resting << 1.4 << never;
    QTest::newRow("misses") << Path{{-4, 1.001}, {2, 0}} << resting << 9.0 << never;
    QTest::newRow("leaving") << Path{{-4, 0}, {-2, 0}} << resting << 9.0 << never;
    QTest::newRow("same velocity") << Path{{-4, 0}, {2, 1}} << Path{{0, 0}, {2, 1}} << 9.0 << never;
    QTest::newRow("touching, approaching") << Path{{-1, 0}, {1, 0}} << resting << 9.0 << 0.0;
    QTest::newRow("touching, leaving") << Path{{-1, 0}, {-1, 0}} << resting << 9.0 << never;
    QTest::newRow("touching, sliding") << Path{{-1, 0}, {0, 1}} << resting << 9.0 << never;
    QTest::newRow("touching, at rest") << Path{{-1, 0}, {}} << resting << 9.0 << never;
    QTest::newRow("inside, approaching") << Path{{-0.5, 0}, {1, 0}} << resting << 9.0 << 0.0;
    QTest::newRow("inside, leaving") << Path{{-0.5, 0}, {-1, 0}} << resting << 9.0 << never;
    // 3 = 2 s + ½ s², just before the end: nothing nearer may be called too far.
    QTest::newRow("speeds up, just in reach")
        << Path{{-4, 0}, {2, 0}, {0.5, 0}} << resting << 1.17 << std::sqrt(10.0) - 2.0;
    QTest::newRow("speeds up, just out of reach")
        << Path{{-4, 0}, {2, 0}, {0.5, 0}} << resting << 1.16 << never;
    // Both fall alike: only the velocities matter.
    QTest::newRow("alike curves cancel")
        << Path{{-4, 0}, {2, 3}, {0, -5}} << Path{{0, 0}, {0, 3}, {0, -5}} << 9.0 << 1.5;
    // One falls 4 m to 1 m above the other: 3 = 3 s².
    QTest::newRow("one falls from rest") << Path{{0, 4}, {}, {0, -3}} << resting << 9.0 << 1.0;
    QTest::newRow("touching, pressed together")
        << Path{{0, 1}, {}, {0, -3}} << resting << 9.0 << 0.0;
    // It is through the other after half a second: 1 − 8 s² = −1.
    QTest::newRow("touching, pressed through it")
        << Path{{0, 1}, {}, {0, -8}} << resting << 9.0 << 0.0;
    QTest::newRow("touching, drawn apart") << Path{{0, 1}, {}, {0, 3}} << resting << 9.0 << never;
    // Thrown off by 2 m/s against 2 m/s²: back after 1 s.
    QTest::newRow("thrown off, falls back")
        << Path{{0, 1}, {0, 2}, {0, -2}} << resting << 9.0 << 1.0;
    // Rises towards the other but turns 1.5 m below it.
    QTest::newRow("turns before it") << Path{{0, -2}, {0, 2}, {0, -2}} << resting << 0.9 << never;
}

void TestTimeToDistance::timeToDistanceMatchesHandWorkedCase()
{
    QFETCH(Path, a);
    QFETCH(Path, b);
    QFETCH(double, end);
    QFETCH(double, time);
    const std::optional<double> found = timeToDistance(a, b, 1.0, end);
    QCOMPARE(found.has_value(), time != never);
    if (found)
        COMPARE_NEAR(*found, time, 1e-14);
}

void TestTimeToDistance::timeToDistanceMatchesAScan_data()
{
    QTest::addColumn<Path>("a");
    QTest::addColumn<Path>("b");
    QTest::addColumn<double>("end");
    const Vec2 euler{};             // the curve of Euler
    const Vec2 verlet{0.0, -4.905}; // ½ g
    const Vec2 symplectic{0.0, -9.81};
    QTest::newRow("head-on") << Path{{-2, 2}, {2, 0}} << Path{{2, 2}, {0, 0}} << 3.0;
    QTest::newRow("glancing") << Path{{-2, 2.3}, {2, 0}} << Path{{2, 2}, {0, 0}} << 3.0;
    QTest::newRow("both moving") << Path{{-2, 2}, {2, 0}} << Path{{2, -2}, {0, 2}} << 3.0;
    QTest::newRow("Euler against Verlet")
        << Path{{-2, 0}, {2, 0.4}, euler} << Path{{0.5, 3}, {-0.3, 0.2}, verlet} << 2.0;
    QTest::newRow("Euler against symplectic")
        << Path{{-1, 0}, {1, 0.2}, euler} << Path{{0, 5}, {0, 0}, symplectic} << 2.0;
    QTest::newRow("Verlet against symplectic")
        << Path{{-1, 1}, {2, 1}, verlet} << Path{{1, 6}, {-0.5, 0}, symplectic} << 2.0;
    QTest::newRow("thrown up past, met on the way down")
        << Path{{0, -3}, {0, 0}, euler} << Path{{0.9, -2}, {-0.3, 8}, verlet} << 3.0;
    QTest::newRow("quartic miss") << Path{{-2, 0}, {2, 0}, euler} << Path{{2, 3}, {2, 0}, verlet}
                                  << 2.0;
    QTest::newRow("quartic, short step")
        << Path{{0, 0}, {1, 0}, euler} << Path{{1.005, 0}, {0, 0}, verlet} << 1.0 / 60.0;
}

void TestTimeToDistance::timeToDistanceMatchesAScan()
{
    QFETCH(Path, a);
    QFETCH(Path, b);
    QFETCH(double, end);
    for (const double distance : {0.4, 0.452, 1.0}) {
        const double expected = contactByScan(a, b, distance, end);
        const std::optional<double> found = timeToDistance(a, b, distance, end);
        QCOMPARE(found.has_value(), expected != never);
        if (found)
            COMPARE_NEAR(*found, expected, 1e-12);
    }
}

void TestTimeToDistance::timeToDistanceDoesNotDependOnTheDirection_data()
{
    timeToDistanceMatchesAScan_data();
}

void TestTimeToDistance::timeToDistanceDoesNotDependOnTheDirection()
{
    QFETCH(Path, a);
    QFETCH(Path, b);
    QFETCH(double, end);
    const double expected = contactByScan(a, b, 0.4, end);
    for (int turns = 1; turns < 4; ++turns) {
        const std::optional<double> found =
            timeToDistance(quarterTurns(a, turns), quarterTurns(b, turns), 0.4, end);
        QCOMPARE(found.has_value(), expected != never);
        if (found)
            COMPARE_NEAR(*found, expected, 1e-12);
    }
}

void TestTimeToDistance::timeToDistanceIsTheSameSeenFromTheOther()
{
    const Path a{{-2, 0}, {2, 0.4}, {}};
    const Path b{{0.5, 3}, {-0.3, 0.2}, {0, -4.905}};
    const double expected = contactByScan(a, b, 1.0, 2.0);
    QVERIFY(expected != never);
    const std::optional<double> found = timeToDistance(b, a, 1.0, 2.0);
    QVERIFY(found.has_value());
    COMPARE_NEAR(*found, expected, 1e-12);
}

void TestTimeToDistance::theFirstOfTwoApproachesCounts()
{
    // Thrown straight up through a resting circle: 1 = 0.5 + … it comes within 1 m going up
    // (y = 4 s − s² rises to 2 at s = 2 − √2) and again going down (never asked for).
    const Path resting{{0, 3}, {}};
    const Path thrown{{0, 0}, {0, 4}, {0, -1}};
    const std::optional<double> found = timeToDistance(resting, thrown, 1.0, 10.0);
    QVERIFY(found.has_value());
    COMPARE_NEAR(*found, 2.0 - std::sqrt(2.0), 1e-14);
}

QTEST_APPLESS_MAIN(TestTimeToDistance)
#include "test_time_to_distance.moc"
