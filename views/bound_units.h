// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

QT_BEGIN_NAMESPACE
class QTextDocument;
QT_END_NAMESPACE

namespace cradle {

/// Keeps on one line what is read in one go: a number or formula with its unit, a unit such as
/// m/s, a vector such as (−2, 2). Code stays as it is. Formulas must still be marks, see
/// FormulaText.
void bindUnits(QTextDocument *document);

} // namespace cradle
