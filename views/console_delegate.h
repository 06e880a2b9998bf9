// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace cradle {

/// Draws a printed line, and left of it in a gutter that stays there the step that printed it.
class ConsoleDelegate final : public QStyledItemDelegate
{
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// \param lastStep  the greatest that the gutter has room for
    /// \param width     characters of the longest line
    /// \return whether the size of the rows is another one now
    bool fit(qint64 lastStep, qsizetype width);
    /// The lines of this step have a mark in the gutter; −1: none.
    void setMarked(qint64 step) { m_marked = step; }
    [[nodiscard]] qint64 marked() const { return m_marked; }

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem &option,
                                 const QModelIndex &index) const override;

private:
    [[nodiscard]] int gutter() const; ///< px
    void paintGutter(QPainter &painter, const QRect &line, qint64 step) const;

    int m_digits = 4;
    qsizetype m_width = 0;
    qint64 m_marked = -1;
};

} // namespace cradle
