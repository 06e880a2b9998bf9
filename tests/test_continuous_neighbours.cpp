// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/continuous/continuous_neighbours.h"
#include "tests/scenes.h"

using namespace cradle;

/// Who can meet in a step, worked by hand: steps of 1/8 s, 8 m/s², so gravity gives 1 m/s.
class TestContinuousNeighbours : public QObject
{
    Q_OBJECT
private slots:
    void areThoseWithinTwiceTheSpeed();
    void areLookedForAgainWhereOneIsFaster();
    void fewAreAllNeighbours();
};

namespace {

constexpr double step = 0.125;  // s
constexpr double gravity = 8.0; // m/s²
constexpr double radius = 0.25; // m

/// Nine in a row, the fastest at 1 m/s; from one to the next \p gap (m) between their rims.
std::vector<Circle> row(double gap, std::size_t count = 9)
{
    std::vector<Circle> circles;
    for (std::size_t i = 0; i < count; ++i)
        circles.push_back({.position = {static_cast<double>(i) * (2.0 * radius + gap), 0.5},
                           .velocity = {i == 4 ? 1.0 : 0.0, 0.0},
                           .radius = radius});
    return circles;
}

std::vector<std::uint32_t> sortedNeighbours(const ContinuousNeighbours &neighbours, std::size_t i)
{
    const auto all = neighbours.of(i);
    std::vector<std::uint32_t> sorted(all.begin(), all.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

using Ids = std::vector<std::uint32_t>;

} // namespace

/// 2 (1 + 1) m/s are foreseen; with what gravity gives both come 5/8 m far.
void TestContinuousNeighbours::areThoseWithinTwiceTheSpeed()
{
    ContinuousNeighbours neighbours;
    neighbours.find(row(1.24), gravity, step);
    QCOMPARE(sortedNeighbours(neighbours, 0), (Ids{1}));
    QCOMPARE(sortedNeighbours(neighbours, 4), (Ids{3, 5}));
    QCOMPARE(sortedNeighbours(neighbours, 8), (Ids{7}));
    neighbours.find(row(1.26), gravity, step);
    for (std::size_t i = 0; i < 9; ++i)
        QCOMPARE(sortedNeighbours(neighbours, i), Ids{});
}

void TestContinuousNeighbours::areLookedForAgainWhereOneIsFaster()
{
    ContinuousNeighbours neighbours;
    const double gap = 2.7; // m; 2 (4 + 1) + 1 m/s come 11/8 m far, 2 (3 + 1) + 1 only 9/8 m
    neighbours.find(row(gap), gravity, step);
    QVERIFY(!neighbours.foresee(3.0)); // with what gravity gives, what was foreseen
    QCOMPARE(sortedNeighbours(neighbours, 4), Ids{});
    QVERIFY(neighbours.foresee(3.01));
    QCOMPARE(sortedNeighbours(neighbours, 4), (Ids{3, 5}));
    QVERIFY(!neighbours.foresee(9.0));
    QVERIFY(neighbours.foresee(9.5)); // 2 (10.5 + 1) + 1 m/s come 3 m far
    QCOMPARE(sortedNeighbours(neighbours, 4), (Ids{2, 3, 5, 6}));
}

void TestContinuousNeighbours::fewAreAllNeighbours()
{
    ContinuousNeighbours neighbours;
    neighbours.find(row(100.0, 8), gravity, step);
    QCOMPARE(sortedNeighbours(neighbours, 3), (Ids{0, 1, 2, 4, 5, 6, 7}));
    QVERIFY(!neighbours.foresee(1000.0));
    QCOMPARE(sortedNeighbours(neighbours, 3), (Ids{0, 1, 2, 4, 5, 6, 7}));
}

QTEST_APPLESS_MAIN(TestContinuousNeighbours)
#include "test_continuous_neighbours.moc"
