// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/figures.h"
#include "tasks/judging/deviation.h"

namespace cradle {

/// As brief(), of a number or a Vec2, but with as many digits more as tell \p value from \p other,
/// beside which it stands.
template <class Value>
[[nodiscard]] QString briefBeside(Value value, Value other)
{
    return brief(value) == brief(other) ? motion::figureBeside(value, other) : brief(value);
}

} // namespace cradle
