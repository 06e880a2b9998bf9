// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/large_blocks.h"

#include <QTest>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

using namespace cradle;

class TestLargeBlocks : public QObject
{
    Q_OBJECT
private slots:
    void blocksKeepWhatIsInThem();
    void leftBlocksGoWithTheirOwner();
    void whatIsNotToBeHadIsNotTaken();
};

/// Taken, moved to larger places and given back from the middle and from both ends.
void TestLargeBlocks::blocksKeepWhatIsInThem()
{
    constexpr std::size_t count = 60;
    const auto sizeOf = [](std::size_t i) { return 129 + i * 371 % 4000; };
    LargeBlocks blocks;
    std::vector<unsigned char *> taken;
    for (std::size_t i = 0; i < count; ++i) {
        taken.push_back(static_cast<unsigned char *>(blocks.take(sizeOf(i))));
        QVERIFY(taken.back());
        QCOMPARE(reinterpret_cast<std::uintptr_t>(taken.back()) % alignof(std::max_align_t),
                 std::uintptr_t{0});
        std::memset(taken.back(), static_cast<int>(i), sizeOf(i));
    }
    for (const std::size_t gone : {std::size_t{0}, count / 2, count - 1}) {
        blocks.giveBack(taken[gone]);
        taken[gone] = nullptr;
    }
    for (std::size_t i = 0; i < count; i += 2) {
        if (taken[i])
            taken[i] = static_cast<unsigned char *>(blocks.resize(taken[i], 100 * sizeOf(i)));
    }
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t byte = 0; taken[i] && byte < sizeOf(i); ++byte)
            QCOMPARE(std::size_t{taken[i][byte]}, i);
    }
}

/// A leak, or a block that is freed twice, is what the address sanitizer reports.
void TestLargeBlocks::leftBlocksGoWithTheirOwner()
{
    LargeBlocks blocks;
    void *first = blocks.take(1000);
    QVERIFY(blocks.take(2000));
    QVERIFY(blocks.take(3000));
    blocks.giveBack(first);
    QVERIFY(blocks.take(100'000));
}

/// And the block stays where it is.
void TestLargeBlocks::whatIsNotToBeHadIsNotTaken()
{
#if defined(CRADLE_SANITIZED)
    QSKIP("a sanitizer ends the program there");
#endif
    constexpr std::size_t tooMuch = std::numeric_limits<std::ptrdiff_t>::max() / 2;
    LargeBlocks blocks;
    QVERIFY(!blocks.take(tooMuch));
    auto *block = static_cast<unsigned char *>(blocks.take(1000));
    block[999] = 7;
    QVERIFY(!blocks.resize(block, tooMuch));
    QCOMPARE(int(block[999]), 7);
    blocks.giveBack(block);
}

QTEST_APPLESS_MAIN(TestLargeBlocks)
#include "test_large_blocks.moc"
