// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/script/large_blocks.h"

#include <cstdlib>
#include <new>
#include <utility>

namespace cradle {

LargeBlocks::~LargeBlocks()
{
    while (m_first)
        std::free(std::exchange(m_first, m_first->next));
}

void *LargeBlocks::resize(void *block, std::size_t size)
{
    void *moved = std::realloc(block ? headOf(block) : nullptr, sizeof(Head) + size);
    if (!moved)
        return nullptr;
    Head *head = block ? static_cast<Head *>(moved) : new (moved) Head{nullptr, m_first};
    link(head);
    return head + 1;
}

void LargeBlocks::giveBack(void *block)
{
    Head *head = headOf(block);
    (head->previous ? head->previous->next : m_first) = head->next;
    if (head->next)
        head->next->previous = head->previous;
    std::free(head);
}

void LargeBlocks::link(Head *head)
{
    (head->previous ? head->previous->next : m_first) = head;
    if (head->next)
        head->next->previous = head;
}

} // namespace cradle
