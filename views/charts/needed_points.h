// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QPointF>

namespace cradle {

/// Which of \p pixels, in order from left to right, are needed: those left out lie within
/// \p tolerance px above or below the lines between the others. Every point costs, and rounding
/// would make beads of a thick level line. The first and the last are always needed.
[[nodiscard]] QList<qsizetype> neededPoints(const QList<QPointF> &pixels, double tolerance);

} // namespace cradle
