// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/small_blocks.h"

#include <QTest>

#include <cstdint>
#include <cstring>
#include <vector>

using namespace cradle;

class TestSmallBlocks : public QObject
{
    Q_OBJECT
private slots:
    void blocksDoNotOverlap();
    void whatIsGivenBackIsTakenAgain();
};

/// Of all sizes in turn, over many chunks: every byte stays as its owner wrote it.
void TestSmallBlocks::blocksDoNotOverlap()
{
    constexpr std::size_t count = 5000;
    SmallBlocks blocks;
    std::vector<unsigned char *> taken;
    const auto sizeOf = [](std::size_t i) { return 1 + i * 37 % SmallBlocks::largest; };
    for (std::size_t i = 0; i < count; ++i) {
        taken.push_back(static_cast<unsigned char *>(blocks.take(sizeOf(i))));
        QVERIFY(taken.back());
        QCOMPARE(reinterpret_cast<std::uintptr_t>(taken.back()) % alignof(std::max_align_t),
                 std::uintptr_t{0});
        std::memset(taken.back(), static_cast<int>(i % 251), sizeOf(i));
    }
    // Every third goes and another takes its place, which writes over no neighbour.
    for (std::size_t i = 0; i < count; i += 3) {
        blocks.giveBack(taken[i], sizeOf(i));
        taken[i] = static_cast<unsigned char *>(blocks.take(sizeOf(i)));
        std::memset(taken[i], static_cast<int>(i % 251), sizeOf(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t byte = 0; byte < sizeOf(i); ++byte)
            QCOMPARE(int{taken[i][byte]}, static_cast<int>(i % 251));
    }
}

void TestSmallBlocks::whatIsGivenBackIsTakenAgain()
{
    SmallBlocks blocks;
    void *small = blocks.take(24);
    void *large = blocks.take(SmallBlocks::largest);
    blocks.giveBack(small, 24);
    blocks.giveBack(large, SmallBlocks::largest);
    QVERIFY(blocks.take(100) != small);
    QCOMPARE(blocks.take(SmallBlocks::largest), large);
    // 17 to 32 bytes are one size.
    QCOMPARE(blocks.take(30), small);
    QVERIFY(blocks.take(30) != small);
}

QTEST_APPLESS_MAIN(TestSmallBlocks)
#include "test_small_blocks.moc"
