// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/contacts/disc_grid.h"
#include "model/world/random.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace cradle;

namespace {

constexpr std::size_t count = 400;
constexpr double side = 10.0; ///< m: about one place in each cell of 0.5 m
constexpr double cell = 0.5;
constexpr double reach = 0.7; ///< m

struct Sorted {
    DiscGrid grid{};
    std::vector<Vec2> places{}; ///< by slot
};

/// Places anywhere in a square whose lower left corner is \p corner.
Sorted scattered(Vec2 corner)
{
    Random random(1);
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < count; ++i)
        places.push_back(corner + Vec2{random.between(0.0, side), random.between(0.0, side)});
    Sorted s;
    s.grid.build(count, [&](std::size_t i) { return places[i]; });
    for (const std::uint32_t i : s.grid.sorted())
        s.places.push_back(places[i]);
    return s;
}

bool isNear(Vec2 a, Vec2 b, double width)
{
    return std::abs(a.x - b.x) <= width && std::abs(a.y - b.y) <= width;
}

std::vector<Circle> ofRadii(std::initializer_list<double> radii)
{
    std::vector<Circle> circles;
    for (const double radius : radii)
        circles.push_back({.radius = radius});
    return circles;
}

} // namespace

/// Whoever is near is seen, and few others.
class TestDiscGrid : public QObject
{
    Q_OBJECT
private slots:
    void everyPlaceIsSortedOnce();
    void runsHoldWhoIsNear_data();
    void runsHoldWhoIsNear();
    void everyPairIsSeenOnce();
    void aRowOfPlacesIsDivided();
    void onePlaceIsFound();
    void giantsStandApart_data();
    void giantsStandApart();
};

void TestDiscGrid::everyPlaceIsSortedOnce()
{
    const Sorted s = scattered({});
    std::vector<std::uint32_t> all(s.grid.sorted().begin(), s.grid.sorted().end());
    std::sort(all.begin(), all.end());
    QCOMPARE(all.size(), count);
    for (std::uint32_t i = 0; i < count; ++i)
        QCOMPARE(all[i], i);
}

void TestDiscGrid::runsHoldWhoIsNear_data()
{
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("about the origin") << -5.0 << -5.0;
    QTest::newRow("far to the left") << -500.0 << 0.0;
    QTest::newRow("far to the right, below") << 500.0 << -900.0;
}

void TestDiscGrid::runsHoldWhoIsNear()
{
    QFETCH(double, x);
    QFETCH(double, y);
    const Sorted s = scattered({x, y});
    for (const Vec2 &centre : s.places) {
        std::vector<bool> seen(count, false);
        s.grid.visitRuns(centre, reach, [&](std::size_t begin, std::size_t end) {
            for (std::size_t slot = begin; slot < end; ++slot)
                seen[slot] = true;
        });
        for (std::size_t slot = 0; slot < count; ++slot) {
            if (isNear(s.places[slot], centre, reach))
                QVERIFY(seen[slot]);
            // Cells are no larger than where one place in each would fill them all by a tenth.
            else if (!isNear(s.places[slot], centre, reach + 1.1 * cell))
                QVERIFY(!seen[slot]);
        }
    }
}

void TestDiscGrid::everyPairIsSeenOnce()
{
    const Sorted s = scattered({-5.0, -5.0});
    std::vector<int> seen(count * count, 0);
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        s.grid.visitRunsAfter(slot, s.places[slot], reach, [&](std::size_t begin, std::size_t end) {
            for (std::size_t other = begin; other < end; ++other)
                ++seen[slot * count + other];
        });
    }
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const int times = seen[a * count + b] + seen[b * count + a];
            QVERIFY(times <= 1);
            if (isNear(s.places[a], s.places[b], reach))
                QCOMPARE(times, 1);
        }
    }
}

/// All on one line, or on one spot: no cell is nothing wide.
void TestDiscGrid::aRowOfPlacesIsDivided()
{
    DiscGrid grid;
    grid.build(100, [](std::size_t i) { return Vec2{0.1 * static_cast<double>(i), 3.0}; });
    std::size_t seen = 0;
    grid.visitRuns({5.0, 3.0}, 0.25,
                   [&](std::size_t begin, std::size_t end) { seen += end - begin; });
    QVERIFY(seen >= 5 && seen <= 8);
}

void TestDiscGrid::onePlaceIsFound()
{
    DiscGrid grid;
    grid.build(1, [](std::size_t) { return Vec2{2.0, 3.0}; });
    std::size_t seen = 0;
    grid.visitRuns({2.0, 3.0}, 0.0,
                   [&](std::size_t begin, std::size_t end) { seen += end - begin; });
    QCOMPARE(seen, std::size_t{1});
}

void TestDiscGrid::giantsStandApart_data()
{
    QTest::addColumn<std::vector<Circle>>("circles");
    QTest::addColumn<std::size_t>("small");
    QTest::addColumn<double>("smallRadius");
    const auto row = [](const char *name, const std::vector<Circle> &circles, std::size_t small,
                        double smallRadius) {
        QTest::newRow(name) << circles << small << smallRadius;
    };
    row("none", {}, 0, 0.0);
    row("alike", ofRadii({0.2, 0.2, 0.2}), 3, 0.2);
    row("four times as wide", ofRadii({0.8, 0.2, 0.2}), 3, 0.8);
    row("more than four times as wide", ofRadii({0.81, 0.2, 0.2}), 2, 0.2);
    // The third by size of five is the median, and of four.
    row("two of five", ofRadii({1.0, 0.1, 0.2, 1.0, 0.1}), 3, 0.2);
    row("half of four", ofRadii({0.1, 2.0, 0.1, 2.0}), 4, 2.0);
    std::vector<Circle> many(40, Circle{.radius = 0.1});
    many.resize(56, Circle{.radius = 1.0});
    row("sixteen giants", many, 40, 0.1);
    many.push_back({.radius = 1.0});
    row("seventeen are no few", many, 57, 1.0);
}

void TestDiscGrid::giantsStandApart()
{
    QFETCH(std::vector<Circle>, circles);
    QFETCH(std::size_t, small);
    const GiantsApart apart = giantsApart(circles);
    QCOMPARE(apart.small, small);
    QTEST(apart.smallRadius, "smallRadius");
    // Each in its order.
    QVERIFY(
        std::is_sorted(apart.ids.begin(), apart.ids.begin() + static_cast<std::ptrdiff_t>(small)));
    QVERIFY(
        std::is_sorted(apart.ids.begin() + static_cast<std::ptrdiff_t>(small), apart.ids.end()));
    for (std::size_t i = 0; i < apart.ids.size(); ++i)
        QCOMPARE(i < small, circles[apart.ids[i]].radius <= apart.smallRadius);
}

QTEST_APPLESS_MAIN(TestDiscGrid)
#include "test_disc_grid.moc"
