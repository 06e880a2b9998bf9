// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sanitizer/asan_interface.h>

#include <array>
#include <cstddef>
#include <new>
#include <utility>

namespace cradle {

/// Memory for many small objects that come and go, as the vectors of a program do: blocks are cut
/// from chunks, and what is given back is taken again for the next of its size. All of it goes
/// when this does. Not for two threads at once. The address sanitizer, where there is one, is told
/// who has which block, as malloc tells it.
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
    [[nodiscard]] void *take(std::size_t size)
    {
        const std::size_t kind = (size - 1) / grain;
        Free *block = m_free[kind];
        if (!block) {
            const std::size_t whole = (kind + 1) * grain;
            if (m_left < whole)
                return cut(whole);
            m_left -= whole;
            return std::exchange(m_next, m_next + whole);
        }
        ASAN_UNPOISON_MEMORY_REGION(block, (kind + 1) * grain);
        m_free[kind] = block->next;
        return block;
    }

    /// \param size  with which \p block was taken
    void giveBack(void *block, std::size_t size)
    {
        const std::size_t kind = (size - 1) / grain;
        m_free[kind] = new (block) Free{m_free[kind]};
        ASAN_POISON_MEMORY_REGION(block, (kind + 1) * grain);
    }

private:
    static constexpr std::size_t grain = 16; ///< bytes; malloc aligns to as many
    static constexpr std::size_t chunkSize = 8 * 1024;
    struct Free {
        Free *next = nullptr;
    };
    struct alignas(grain) Chunk {
        Chunk *older = nullptr;
    };

    /// From a new chunk.
    [[nodiscard]] void *cut(std::size_t size);

    std::array<Free *, largest / grain> m_free{}; ///< of each size
    Chunk *m_newest = nullptr;
    std::byte *m_next = nullptr; ///< in the newest chunk
    std::size_t m_left = 0;      ///< bytes there
};

} // namespace cradle
