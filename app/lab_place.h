// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

namespace cradle {

/// Where the student is: a lab, and one of its steps.
struct LabPlace {
    Lab lab{};
    int current = -1; ///< index of the step; −1: a scene without one

    /// nullptr for a scene without a step
    [[nodiscard]] const Task *task() const
    {
        return current >= 0 ? &lab.tasks[static_cast<std::size_t>(current)] : nullptr;
    }
};

} // namespace cradle
