// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/heap_meter.h"

#include <malloc.h>

#include <algorithm>
#include <cerrno>

// The allocator of glibc by its own names: ours replace the usual ones.
extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t count, std::size_t size);
void *__libc_realloc(void *block, std::size_t size);
void *__libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void *block);
}

namespace {

thread_local constinit std::ptrdiff_t heldBytes = 0;
thread_local constinit std::ptrdiff_t peakBytes = 0;

void *counted(void *block)
{
    heldBytes += static_cast<std::ptrdiff_t>(malloc_usable_size(block));
    peakBytes = std::max(peakBytes, heldBytes);
    return block;
}

void discount(void *block)
{
    heldBytes -= static_cast<std::ptrdiff_t>(malloc_usable_size(block));
}

} // namespace

extern "C" {

void *malloc(std::size_t size)
{
    return counted(__libc_malloc(size));
}

void *calloc(std::size_t count, std::size_t size)
{
    return counted(__libc_calloc(count, size));
}

void *realloc(void *block, std::size_t size)
{
    // While it moves, both blocks are there.
    const auto before = static_cast<std::ptrdiff_t>(malloc_usable_size(block));
    void *moved = __libc_realloc(block, size);
    if (moved || size == 0) {
        counted(moved);
        heldBytes -= before;
    }
    return moved;
}

void *aligned_alloc(std::size_t alignment, std::size_t size)
{
    return counted(__libc_memalign(alignment, size));
}

int posix_memalign(void **block, std::size_t alignment, std::size_t size)
{
    *block = counted(__libc_memalign(alignment, size));
    return *block ? 0 : ENOMEM;
}

void free(void *block)
{
    discount(block);
    __libc_free(block);
}
}

namespace cradle {

std::ptrdiff_t HeapMeter::held()
{
    return heldBytes;
}

std::ptrdiff_t HeapMeter::peak()
{
    return peakBytes;
}

void HeapMeter::restart()
{
    peakBytes = heldBytes;
}

} // namespace cradle
