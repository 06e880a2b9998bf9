// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace cradle {

/// What the text of a line tells of it, for a program as rows without comments. Lines count from 1.

/// The lines of \p program without comments.
[[nodiscard]] QStringList rowsOf(const QString &program);

/// Whether it compares by order.
[[nodiscard]] bool compares(const QString &row);

/// How much is worked out in a line: its operators, products most.
[[nodiscard]] int worksOut(const QString &row);

/// Whether a line asks for a wall.
[[nodiscard]] bool asksForWall(const QString &row);

/// The line with one name, wherever it stands in it, in place of another.
[[nodiscard]] QString withName(const QString &row, const QString &name, const QString &other);

/// Whether a line takes what another, a local value, gives.
[[nodiscard]] bool takes(const QString &row, const QString &giving);

/// The lines of the function in which a line stands.
struct RowRange {
    int first = 1;
    int last = 0;
};
[[nodiscard]] RowRange functionOf(const QStringList &rows, int line);

} // namespace cradle
