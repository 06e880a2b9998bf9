// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/question.h"

namespace cradle {

/// A question for a number with a unit: 20 m/s, to 0.1.
inline Question speed()
{
    return {.id = QStringLiteral("speed"),
            .kind = Question::Kind::Number,
            .title = QStringLiteral("Speed at the floor"),
            .text = {},
            .number = 20.0,
            .tolerance = 0.1,
            .unit = QStringLiteral("m/s")};
}

} // namespace cradle
