// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/exact/tournament.h"
#include "model/world/random.h"

#include <QTest>

#include <cmath>

using namespace cradle;

/// The first and the second are those of a plain search, after any changes.
class TestTournament : public QObject
{
    Q_OBJECT
private slots:
    void theEarliestWins_data();
    void theEarliestWins();
    void nobodyIsDueAtFirst();
    void theSoonestAreAmongThem();
};

void TestTournament::theEarliestWins_data()
{
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 3, 7, 64, 1000})
        QTest::addRow("%d", count) << count;
}

void TestTournament::theEarliestWins()
{
    QFETCH(int, count);
    Random random(1);
    Tournament tournament;
    tournament.reset(static_cast<std::size_t>(count));
    std::vector<double> times(static_cast<std::size_t>(count),
                              std::numeric_limits<double>::infinity());
    for (int i = 0; i < 2000; ++i) {
        const auto slot = static_cast<std::uint32_t>(random.between(0.0, count));
        // Small whole numbers, so that many are equal.
        times[slot] = std::floor(random.between(0.0, 50.0));
        tournament.set(slot, times[slot]);
        std::vector<double> inOrder = times;
        std::sort(inOrder.begin(), inOrder.end());
        QCOMPARE(tournament.firstTime(), inOrder[0]);
        QCOMPARE(times[tournament.first()], inOrder[0]);
        QCOMPARE(tournament.secondTime(),
                 count > 1 ? inOrder[1] : std::numeric_limits<double>::infinity());
    }
}

void TestTournament::nobodyIsDueAtFirst()
{
    Tournament tournament;
    tournament.reset(5);
    tournament.set(3, 1.0);
    tournament.reset(5);
    QVERIFY(std::isinf(tournament.firstTime()));
}

void TestTournament::theSoonestAreAmongThem()
{
    constexpr std::uint32_t count = 10'000;
    Tournament tournament;
    tournament.reset(count);
    for (std::uint32_t slot = 0; slot < count; ++slot)
        tournament.set(slot, 1.0 + (slot * 7919U) % count);
    bool first = false;
    int visited = 0;
    tournament.visitSoonest([&](std::uint32_t slot) {
        ++visited;
        first = first || slot == tournament.first();
    });
    QCOMPARE(visited, 8);
    QVERIFY(first);
}

QTEST_APPLESS_MAIN(TestTournament)
#include "test_tournament.moc"
