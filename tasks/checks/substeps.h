// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/checks/check_library.h"

#include <optional>

namespace cradle {

/// Whether the steps of a circle are of one or the other Euler in equal parts of a step: in n parts
/// the place gets (½ ± 1/2n) a Δt² besides v Δt.
class Substeps
{
public:
    /// \return whether the step after \p k of circle \p i goes on as those before
    bool take(const Observation &o, int i, qint64 k, Vec2 gravity, double tolerance);

private:
    std::optional<double> m_share{}; ///< of a Δt², by the first step
    bool m_isOne = true;
};

} // namespace cradle
