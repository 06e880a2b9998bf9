// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace cradle {

/// Memory for many small objects that come and go, as the vectors of a program do: blocks are cut
/// from chunks, and what is given back is taken again for the next of its size. All of it goes
/// when this does. Not for two threads at once.
class SmallBlocks
{
public:
    static constexpr std::size_t largest = 128; ///< bytes; what is larger is left to malloc

    SmallBlocks() = default;
    ~SmallBlocks();
    SmallBlocks(const SmallBlocks &) = delete;
    SmallBlocks &operator=(const SmallBlocks &) = delete;

    /// \param size  bytes, from 1 to largest
    /// \return nullptr if there is no memory
    [[nodiscard]] void *take(std::size_t size);
    /// \param size  with which \p block was taken
    void giveBack(void *block, std::size_t size);

private:
    static constexpr std::size_t grain = 16; ///< bytes; malloc aligns to as many
    static constexpr std::size_t chunkSize = 8 * 1024;
    struct Free {
        Free *next = nullptr;
    };
    struct alignas(grain) Chunk {
        Chunk *older = nullptr;
    };

    [[nodiscard]] void *cut(std::size_t size);

    std::array<Free *, largest / grain> m_free{}; ///< of each size
    Chunk *m_newest = nullptr;
    std::byte *m_next = nullptr; ///< in the newest chunk
    std::size_t m_left = 0;      ///< bytes there
};

} // namespace cradle
