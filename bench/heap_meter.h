// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace cradle {

/// What this thread holds on the heap, from malloc and new, in libraries too; bytes.
/// The program's own malloc counts it (heap_meter.cpp), so it sees what lives within a step.
struct HeapMeter {
    /// Held now.
    [[nodiscard]] static std::ptrdiff_t held();
    /// The most that was held since restart().
    [[nodiscard]] static std::ptrdiff_t peak();
    static void restart();
};

} // namespace cradle
