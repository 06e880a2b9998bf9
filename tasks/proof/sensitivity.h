// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <functional>
#include <optional>

namespace cradle {

/// How wrong a run must just be for a check to fail it: the other side of a tolerance. The right
/// run of the solution is bent until the check notices, each way by itself; nullopt where it does
/// not notice the most that is tried.
struct Sensitivity {
    std::optional<double> turn{};  ///< °: the way after its first hit, or from the start; up to 45
    std::optional<double> speed{}; ///< share by which it goes on too fast after that; up to 0.5
    std::optional<double> drift{}; ///< m/s by which positions run away from velocities; up to 1
    std::optional<double> restitution{}; ///< by which e of its first hit is larger; up to 1
    /// By which mass grows with a higher power of the radius than r³ in its first hit of two
    /// circles; up to 3.
    std::optional<double> massExponent{};

    friend bool operator==(const Sensitivity &, const Sensitivity &) = default;
};

/// Measures \p check of \p task with the run of its solution in the first scenes of seed 1, to a
/// tenth. \param stop  asked before every scene; if it answers true, nothing more is measured
/// \return nullopt if there is no solution, or if it fails
[[nodiscard]] std::optional<Sensitivity> sensitivityOf(const Task &task, const CheckSpec &check,
                                                       const std::function<bool()> &stop);

/// "0.06° · 0.3 % · 2 mm/s": what is noticed, in words of that order, with "–" for what is not;
/// then "e ± 0.001" and "r^(3 ± 0.02)" where those are.
[[nodiscard]] QString describe(const Sensitivity &sensitivity);

} // namespace cradle
