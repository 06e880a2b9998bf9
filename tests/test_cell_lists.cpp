// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/cell_lists.h"
#include "model/world/random.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace cradle;

namespace {

constexpr double reach = 0.4; // m

struct Thing {
    Vec2 place{}; // m
    CellLink link{};
};

/// \p count things anywhere in a square of 8 m, listed.
std::vector<Thing> scattered(int count, CellLists &cells)
{
    Random random(1);
    std::vector<Thing> things(static_cast<std::size_t>(count));
    cells.divide({-4.0, -4.0}, {4.0, 4.0}, things.size(), reach);
    for (std::uint32_t slot = 0; slot < things.size(); ++slot) {
        things[slot].place = {random.between(-4.0, 4.0), random.between(-4.0, 4.0)};
        cells.insert(things.data(), slot, things[slot].place);
    }
    return things;
}

bool isNear(const Thing &a, const Thing &b)
{
    const Vec2 d = b.place - a.place;
    return std::abs(d.x) <= reach && std::abs(d.y) <= reach;
}

/// Those of \p found, sorted.
std::vector<std::uint32_t> sorted(const std::vector<std::uint32_t> &found, std::size_t count)
{
    std::vector<std::uint32_t> list(found.begin(),
                                    found.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(list.begin(), list.end());
    return list;
}

} // namespace

/// Whoever is near is found, however things have moved from cell to cell.
class TestCellLists : public QObject
{
    Q_OBJECT
private slots:
    void nearMissesNobody_data();
    void nearMissesNobody();
    void movingBringsIntoReachWhatIsAhead();
    void aBoxHoldsWhatLiesInIt();
    void allAreListedOnceRowByRow();
    void placesOutsideBelongToTheEdge();
    void roundingAtTheEdgesMissesNobody();
};

void TestCellLists::nearMissesNobody_data()
{
    QTest::addColumn<int>("count");
    QTest::newRow("one") << 1;
    QTest::newRow("cells wider than the reach") << 30;
    QTest::newRow("several to a cell") << 3000;
}

void TestCellLists::nearMissesNobody()
{
    QFETCH(int, count);
    CellLists cells;
    const std::vector<Thing> things = scattered(count, cells);
    std::vector<std::uint32_t> found(things.size() + 1);
    for (std::uint32_t a = 0; a < things.size(); ++a) {
        const auto list = sorted(found, cells.near(things.data(), a, found.data()));
        QVERIFY(std::adjacent_find(list.begin(), list.end()) == list.end());
        QVERIFY(!std::binary_search(list.begin(), list.end(), a));
        for (std::uint32_t b = 0; b < things.size(); ++b) {
            if (b != a && isNear(things[a], things[b]))
                QVERIFY(std::binary_search(list.begin(), list.end(), b));
        }
    }
}

void TestCellLists::movingBringsIntoReachWhatIsAhead()
{
    CellLists cells;
    std::vector<Thing> things = scattered(300, cells);
    std::vector<std::uint32_t> found(things.size() + 1);
    Random random(2);
    int moves = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto a = static_cast<std::uint32_t>(random.between(0.0, 300.0));
        const auto side = static_cast<Wall>(static_cast<int>(random.between(0.0, 4.0)));
        if ((cells.edgesOf(things[a].link) & (1U << static_cast<unsigned>(side))) != 0)
            continue;
        const auto before = sorted(found, cells.near(things.data(), a, found.data()));
        cells.move(things.data(), a, side);
        const auto ahead = sorted(found, cells.ahead(things.data(), a, side, found.data()));
        const auto after = sorted(found, cells.near(things.data(), a, found.data()));
        std::vector<std::uint32_t> fresh;
        std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                            std::back_inserter(fresh));
        QCOMPARE(ahead, fresh);
        ++moves;
    }
    QVERIFY(moves > 10'000);
}

void TestCellLists::aBoxHoldsWhatLiesInIt()
{
    CellLists cells;
    const std::vector<Thing> things = scattered(300, cells);
    std::vector<std::uint32_t> found(things.size() + 1);
    const Vec2 low{-1.3, 0.2};
    const Vec2 high{2.1, 9.0};
    const auto list = sorted(found, cells.within(things.data(), low, high, found.data()));
    QVERIFY(list.size() < things.size());
    for (std::uint32_t a = 0; a < things.size(); ++a) {
        const Vec2 p = things[a].place;
        if (p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y)
            QVERIFY(std::binary_search(list.begin(), list.end(), a));
    }
}

void TestCellLists::allAreListedOnceRowByRow()
{
    CellLists cells;
    const std::vector<Thing> things = scattered(300, cells);
    std::vector<std::uint32_t> found(things.size());
    cells.all(things.data(), found.data());
    const auto cellOf = [&](std::uint32_t slot) {
        return std::pair(things[slot].link.row, things[slot].link.column);
    };
    for (std::size_t i = 1; i < found.size(); ++i)
        QVERIFY(cellOf(found[i - 1]) <= cellOf(found[i]));
    const auto list = sorted(found, found.size());
    for (std::uint32_t slot = 0; slot < things.size(); ++slot)
        QCOMPARE(list[slot], slot);
}

void TestCellLists::placesOutsideBelongToTheEdge()
{
    CellLists cells;
    std::vector<Thing> things(2);
    cells.divide({-4.0, -4.0}, {4.0, 4.0}, 100, reach);
    cells.insert(things.data(), 0, {-1e300, 1e300});
    cells.insert(things.data(), 1, {-3.99, 3.99});
    QCOMPARE(things[0].link.column, things[1].link.column);
    QCOMPARE(things[0].link.row, things[1].link.row);
    const CellLink &link = things[0].link;
    QVERIFY(std::isinf(cells.endAcross(link, false)) && std::isinf(cells.endAlong(link, true)));
    QVERIFY(cells.endAcross(link, true) > -4.0 && cells.endAlong(link, false) < 4.0);
    // All in one place: one cell, and no division by its width.
    cells.divide({1.0, 1.0}, {1.0, 1.0}, 2, 0.0);
    cells.insert(things.data(), 0, {1.0, 1.0});
    QCOMPARE(cells.edgesOf(things[0].link), 15U);
}

/// Those a reach apart are found wherever the edges of cells lie between them: what rounding does
/// to a place is less than what cells are wider than the reach.
void TestCellLists::roundingAtTheEdgesMissesNobody()
{
    for (int steps = 1; steps <= 60; ++steps) {
        const double width = reach * steps;
        for (int i = 0; i < steps; ++i) {
            for (const double shift : {0.0, -1e-16, -4e-16, 4e-16}) {
                CellLists cells;
                std::vector<Thing> things(2);
                cells.divide({-4.0, -4.0}, {-4.0 + width, -4.0 + width}, 10'000, reach);
                const double x = -4.0 + reach * i + shift;
                things[0].place = {x, -4.0};
                things[1].place = {x + reach, -4.0};
                cells.insert(things.data(), 0, things[0].place);
                cells.insert(things.data(), 1, things[1].place);
                std::vector<std::uint32_t> found(things.size() + 1);
                QCOMPARE(cells.near(things.data(), 0, found.data()), std::size_t{1});
                QCOMPARE(cells.near(things.data(), 1, found.data()), std::size_t{1});
            }
        }
    }
}

QTEST_APPLESS_MAIN(TestCellLists)
#include "test_cell_lists.moc"
