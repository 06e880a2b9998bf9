// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/preset.h"

namespace cradle {

/// Instructions that a step of \p program takes in the first part of a run of \p scene; one of the
/// lab takes some hundred.
[[nodiscard]] qint64 workOfAStep(const QString *program, const Preset &scene);

} // namespace cradle
