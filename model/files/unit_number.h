// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/files/unit.h"

#include <functional>

namespace cradle {

/// Powers of m, kg and s, as in a Unit.
using UnitPowers = std::array<int, 3>;

/// "kg m/s²"; "1" of a number without a unit.
[[nodiscard]] QString nameOf(const UnitPowers &powers);

/// A number in an expression, and what is known of its unit.
struct UnitNumber {
    enum class Kind {
        Bare,     ///< written without a unit: a factor, or in the unit that is asked for
        Measured, ///< with a unit
        Any       ///< of a named value, whose unit nobody says
    };

    double number = 0.0; ///< in m, kg, s
    Kind kind = Kind::Bare;
    UnitPowers powers{}; ///< of what is Measured

    [[nodiscard]] static UnitNumber measured(double number, const UnitPowers &powers);
    /// Whether \p other may be added to it, or be asked for in its place.
    [[nodiscard]] bool fits(const UnitNumber &other) const;
};

/// \p number, of the sort of \p a and \p b, which fit.
[[nodiscard]] UnitNumber likeBoth(const UnitNumber &a, const UnitNumber &b, double number);
/// \param way  1 for a product, -1 for a quotient
[[nodiscard]] UnitNumber timesPower(const UnitNumber &a, const UnitNumber &b, int way);
/// \return nullopt if its unit would be none: m^0.5, or anything to a power with a unit
[[nodiscard]] std::optional<UnitNumber> raised(const UnitNumber &base, const UnitNumber &exponent);

/// So many times a unit: 35 cm are 35/100 m, and 36 km/h 36/3.6 m/s, to the last bit.
[[nodiscard]] UnitNumber inUnit(double number, const Unit &unit);

/// The unit that is asked for, as "m/s²" or "1000 kg/m³"; nullopt where numbers have none.
[[nodiscard]] std::optional<UnitNumber> askedUnit(const QString &unit);

/// A unit as it stands in a text.
struct UnitText {
    Unit unit{};
    qsizetype end = 0; ///< where it ends there
};

/// The unit that begins at \p from, after spaces, as unitFrom() reads it.
/// \param isTaken  whether a word behind / or * is the name of something else
/// \return nullopt if there is none
[[nodiscard]] std::optional<UnitText> unitAt(const QString &text, qsizetype from,
                                             const std::function<bool(const QString &)> &isTaken);

} // namespace cradle
