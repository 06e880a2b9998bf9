// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace cradle {

/// A number that a program keeps with a circle, such as its mass.
struct CircleField {
    int circle = 0; ///< from 0
    QString name;
    double value = 0.0;

    friend bool operator==(const CircleField &, const CircleField &) = default;
};

} // namespace cradle
