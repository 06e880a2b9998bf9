// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

// What expressions can be made with besides signs; see evaluated().
namespace cradle {

/// What becomes of the unit of an argument.
enum class UnitOf { None, Kept, Root };

struct OfOne {
    const char *name;
    double (*of)(double);
    UnitOf unit = UnitOf::None; ///< by none it has none
};
inline constexpr OfOne ofOne[] = {
    {"sqrt", [](double x) { return std::sqrt(x); }, UnitOf::Root},
    {"abs", [](double x) { return std::abs(x); }, UnitOf::Kept},
    {"exp", [](double x) { return std::exp(x); }},
    {"ln", [](double x) { return std::log(x); }},
    {"log10", [](double x) { return std::log10(x); }},
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"floor", [](double x) { return std::floor(x); }},
    {"ceil", [](double x) { return std::ceil(x); }},
    {"round", [](double x) { return std::round(x); }},
};

struct OfTwo {
    const char *name;
    double (*of)(double, double);
    bool keepsUnit;
};
inline constexpr OfTwo ofTwo[] = {
    {"min", [](double x, double y) { return std::fmin(x, y); }, true},
    {"max", [](double x, double y) { return std::fmax(x, y); }, true},
    {"atan2", [](double x, double y) { return std::atan2(x, y); }, false},
};

} // namespace cradle
