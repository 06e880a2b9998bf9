// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace cradle {

/// How many letters must be put in, left out, changed or swapped with their neighbour to make
/// \p b of \p a (optimal string alignment distance).
[[nodiscard]] int editDistance(const QString &a, const QString &b);

/// The name out of \p known that \p name was probably meant to be; empty if none is near.
[[nodiscard]] QString nearestName(const QString &name, const QStringList &known);

} // namespace cradle
