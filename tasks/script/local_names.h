// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace cradle {

/// A name that a program makes local, and where it is known.
struct LocalName {
    QString name;
    int line = 0;             ///< where it is declared, from 1
    int lastLine = 0;         ///< of its block
    bool isOutermost = false; ///< in no block: what stands below may use it
};

/// All local names of \p source, parameters and counters too, in order. Any text has some or none.
[[nodiscard]] std::vector<LocalName> localNames(const QString &source);

} // namespace cradle
