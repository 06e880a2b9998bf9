// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace cradle {

inline constexpr int numberRowHeight = 22; ///< px

/// A table of numbers of \p model with symbols and units over its columns.
/// \param unitRole  of the model's header data
[[nodiscard]] QTableView *makeNumberTable(QAbstractItemModel *model, int unitRole);

/// Makes its rows as high as the size of texts asks for.
void setNumberRows(QTableView *table);

} // namespace cradle
