// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>

namespace cradle {

/// The selected cells of a table as lines with tabs: every row and column that has one; empty if
/// there is none. Minus signs are those of a keyboard, so that a spreadsheet reads numbers.
[[nodiscard]] QString textOfCells(const QAbstractItemModel &model, const QModelIndexList &selected);

/// The whole table with its headers, and units behind those that have one.
/// \param unitRole  of the model's header data
/// \param corner    the header of the rows' headers
[[nodiscard]] QString textOfTable(const QAbstractItemModel &model, int unitRole,
                                  const QString &corner);

} // namespace cradle
