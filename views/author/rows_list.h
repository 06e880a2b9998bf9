// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

#include <functional>
#include <vector>

QT_BEGIN_NAMESPACE
class QBoxLayout;
class QLabel;
class QListWidget;
class QString;
class QToolButton;
class QWidget;
QT_END_NAMESPACE

namespace cradle {

// A heading over a list of rows with buttons: how all lists of the author's window look.

/// A section heading, still without text.
[[nodiscard]] QLabel *makeHeading(QWidget *parent);

/// A list without a frame that never scrolls sideways.
/// \param name  of the object
[[nodiscard]] QListWidget *makeRowsList(const QString &name, QWidget *parent);

/// Gives \p list so many rows: new ones without text at its end, or fewer; its items stay.
void setRowCount(QListWidget *list, int count);

/// Makes the row that was current, or the last one there is, current again; none where there is
/// none.
void chooseRow(QListWidget *list, int row);

/// Lets long texts of \p list take several lines.
void wrapRows(QListWidget *list);

/// \p heading with \p buttons at its right, and \p list below.
[[nodiscard]] QBoxLayout *makeRowsColumn(QLabel *heading, const std::vector<QToolButton *> &buttons,
                                         QListWidget *list);

/// What the keys of a list do: Alt+Up, Alt+Down and Delete press buttons, as far as these are
/// enabled; F2 renames.
struct RowKeys {
    QToolButton *up = nullptr; ///< nullptr: the key does nothing of its own
    QToolButton *down = nullptr;
    QToolButton *remove = nullptr;
    std::function<void()> rename{};
};
void setRowKeys(QListWidget *list, const RowKeys &keys);

} // namespace cradle
