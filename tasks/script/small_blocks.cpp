// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/small_blocks.h"

#include <cstdlib>
#include <utility>

namespace cradle {

SmallBlocks::~SmallBlocks()
{
    while (m_newest) {
        ASAN_UNPOISON_MEMORY_REGION(m_newest, chunkSize);
        std::free(std::exchange(m_newest, m_newest->older));
    }
}

void *SmallBlocks::cut(std::size_t size)
{
    void *chunk = std::malloc(chunkSize);
    if (!chunk)
        return nullptr;
    m_newest = new (chunk) Chunk{m_newest};
    m_next = static_cast<std::byte *>(chunk) + sizeof(Chunk);
    m_left = chunkSize - sizeof(Chunk) - size;
    return std::exchange(m_next, m_next + size);
}

} // namespace cradle
