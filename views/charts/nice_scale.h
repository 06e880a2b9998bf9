// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace cradle {

/// The least of 1, 2, 5 · 10ᵏ that is not below \p rough; 1 if that is not a positive number.
[[nodiscard]] double niceStep(double rough);

/// An axis from low to high, with what its ticks are multiples of.
struct AxisScale {
    double low = 0.0;
    double high = 1.0;
    double step = 1.0;

    /// The multiples of step within the axis.
    [[nodiscard]] std::vector<double> ticks() const;
    friend bool operator==(const AxisScale &, const AxisScale &) = default;
};

/// A part of an axis of values.
struct ValueSpan {
    double low = 0.0;
    double high = 1.0;

    friend bool operator==(const ValueSpan &, const ValueSpan &) = default;
};

/// \p span \p factor times as long, where \p about keeps its place; nullopt where the digits of a
/// double would end.
[[nodiscard]] std::optional<ValueSpan> zoomed(const ValueSpan &span, double factor, double about);

/// The range of a vertical axis: contains zero, grows at once to round numbers, and shrinks only
/// when the values need a third of it or less, or when it is reset.
class SteadyRange
{
public:
    void reset() { *this = {}; }
    /// Holds the values from \p low to \p high. \p reference is the scale of the run:
    /// values below rounding noise of it count as zero, and a curve of zeros is shown in it.
    void fit(double low, double high, double reference);
    /// The range with room for \p margin (part of the height) above and below.
    [[nodiscard]] AxisScale scale(int ticks, double margin) const;

private:
    double m_low = 0.0;
    double m_high = 0.0;
};

} // namespace cradle
