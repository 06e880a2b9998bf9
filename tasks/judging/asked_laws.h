// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <initializer_list>

namespace cradle {

/// What the checks of a step themselves say of the right laws. A lab that came to students without
/// its solutions has no other reference. What they leave open is said to be unknown, even where a
/// guess would mostly be right.
struct AskedLaws {
    Preset scene{};      ///< the step's own, with the laws and the gravity that are asked for
    bool motion = false; ///< whether the checks tell how circles move freely
    bool walls = false;  ///< how walls turn them
    bool pair = false;   ///< when two count as touching, and what a hit does
};

/// Whether \p kind is that of a check among \p names.
[[nodiscard]] bool isOneOf(const QString &kind, std::initializer_list<const char *> names);

[[nodiscard]] AskedLaws askedLaws(const Task &task);

} // namespace cradle
