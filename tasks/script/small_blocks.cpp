// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/small_blocks.h"

#include <sanitizer/asan_interface.h>

#include <cstdlib>
#include <new>
#include <utility>

namespace cradle {

// The address sanitizer, where there is one, is told who has which block, as malloc tells it.

SmallBlocks::~SmallBlocks()
{
    while (m_newest) {
        ASAN_UNPOISON_MEMORY_REGION(m_newest, chunkSize);
        std::free(std::exchange(m_newest, m_newest->older));
    }
}

void *SmallBlocks::take(std::size_t size)
{
    const std::size_t kind = (size - 1) / grain;
    Free *block = m_free[kind];
    if (!block)
        return cut((kind + 1) * grain);
    ASAN_UNPOISON_MEMORY_REGION(block, (kind + 1) * grain);
    m_free[kind] = block->next;
    return block;
}

void SmallBlocks::giveBack(void *block, std::size_t size)
{
    const std::size_t kind = (size - 1) / grain;
    m_free[kind] = new (block) Free{m_free[kind]};
    ASAN_POISON_MEMORY_REGION(block, (kind + 1) * grain);
}

void *SmallBlocks::cut(std::size_t size)
{
    if (m_left < size) {
        void *chunk = std::malloc(chunkSize);
        if (!chunk)
            return nullptr;
        m_newest = new (chunk) Chunk{m_newest};
        m_next = static_cast<std::byte *>(chunk) + sizeof(Chunk);
        m_left = chunkSize - sizeof(Chunk);
    }
    m_left -= size;
    return std::exchange(m_next, m_next + size);
}

} // namespace cradle
