// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace cradle {

/// What this process has worked since then. Unlike a clock it stands still while the machine does
/// something else, so a bound does not depend on who else is at work.
class CpuTimer
{
public:
    /// ms of processor time, of all threads.
    [[nodiscard]] double elapsed() const
    {
        return 1e3 * static_cast<double>(std::clock() - m_start) / CLOCKS_PER_SEC;
    }

private:
    std::clock_t m_start = std::clock();
};

} // namespace cradle
