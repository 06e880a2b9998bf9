// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace cradle {

/// Draws a step: its state as a glyph, its title, and "extra" if the original lab lacks it.
class StepDelegate final : public QStyledItemDelegate
{
    Q_OBJECT
public:
    enum class State { Open, Current, Passed };
    static constexpr int stateRole = Qt::UserRole;       ///< State as an int
    static constexpr int tagRole = Qt::UserRole + 1;     ///< "extra", or empty
    static constexpr int currentRole = Qt::UserRole + 2; ///< whether this is the open step
    static constexpr int rowHeight = 26;                 ///< px

    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option,
                                 const QModelIndex &index) const override;
};

} // namespace cradle
