// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <array>
#include <optional>

namespace cradle {

/// What a unit is made of: \c scale times metres, kilograms and seconds to their powers. Angles and
/// shares are numbers: 1° = π/180, 1 % = 0.01.
struct Unit {
    double scale = 1.0;
    std::array<int, 3> powers{}; ///< of m, kg and s

    friend bool operator==(const Unit &, const Unit &) = default;
};

/// Reads "km/h", "kg m/s", "m/s²", "N·s", "s^-1", "°"; an empty text is the number 1. All behind a
/// slash divides, up to the next.
/// \return nothing if a part of it is no unit
[[nodiscard]] std::optional<Unit> unitFrom(const QString &text);

/// A number as somebody wrote it, with what stands behind it.
struct Quantity {
    double number = 0.0;
    QString unit{}; ///< as it was written; empty if there was none
};

/// Reads "9.9 m/s", "-3,2e-3kg" (a comma is a point); nothing if it does not begin with a number.
[[nodiscard]] std::optional<Quantity> quantityFrom(const QString &text);

} // namespace cradle
