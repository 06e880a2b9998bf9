// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace cradle {

/// Memory by malloc that all goes when this does, whoever still has it. Not for two threads at
/// once.
class LargeBlocks
{
public:
    LargeBlocks() = default;
    ~LargeBlocks();
    LargeBlocks(const LargeBlocks &) = delete;
    LargeBlocks &operator=(const LargeBlocks &) = delete;

    /// \return aligned as by malloc; nullptr if there is no memory
    [[nodiscard]] void *take(std::size_t size) { return resize(nullptr, size); }
    /// \param block  from here, or nullptr
    /// \return what is in \p block, at a place that may be another; nullptr if there is no memory,
    ///     and then \p block stays
    [[nodiscard]] void *resize(void *block, std::size_t size);
    /// \param block  from here
    void giveBack(void *block);

private:
    /// Before every block.
    struct alignas(std::max_align_t) Head {
        Head *previous = nullptr;
        Head *next = nullptr;
    };

    static Head *headOf(void *block) { return static_cast<Head *>(block) - 1; }
    /// Makes what lies beside \p head point to it.
    void link(Head *head);

    Head *m_first = nullptr;
};

} // namespace cradle
