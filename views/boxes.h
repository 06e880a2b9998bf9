// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QBoxLayout>
#include <QWidget>

#include <initializer_list>

namespace cradle {

/// What a row or a column holds: a widget or a layout, with its share of the room that is left, or
/// room alone.
class BoxPart
{
public:
    BoxPart(QWidget *widget, int share = 0, Qt::Alignment alignment = {})
        : m_widget(widget)
        , m_share(share)
        , m_alignment(alignment)
    {
    }
    BoxPart(QLayout *layout, int share = 0)
        : m_layout(layout)
        , m_share(share)
    {
    }
    /// So many px of room.
    [[nodiscard]] static BoxPart space(int size)
    {
        BoxPart part(static_cast<QWidget *>(nullptr));
        part.m_size = size;
        return part;
    }
    /// All room that is left.
    [[nodiscard]] static BoxPart rest() { return {static_cast<QWidget *>(nullptr), 1}; }

    void addTo(QBoxLayout &box) const
    {
        if (m_widget)
            box.addWidget(m_widget, m_share, m_alignment);
        else if (m_layout)
            box.addLayout(m_layout, m_share);
        else if (m_size > 0)
            box.addSpacing(m_size);
        else
            box.addStretch(m_share);
    }

private:
    QWidget *m_widget = nullptr;
    QLayout *m_layout = nullptr;
    int m_share = 0;
    Qt::Alignment m_alignment{};
    int m_size = 0; ///< px
};

/// A row or a column, as \p Box is, that is yet to be added to another one.
/// \param gap  px between two parts; −1: as the style has it
template <typename Box>
[[nodiscard]] Box *makeBox(QMargins margins, int gap, std::initializer_list<BoxPart> parts)
{
    auto *box = new Box;
    box->setContentsMargins(margins);
    box->setSpacing(gap);
    for (const BoxPart &part : parts)
        part.addTo(*box);
    return box;
}

[[nodiscard]] inline QVBoxLayout *makeColumn(QMargins margins, int gap,
                                             std::initializer_list<BoxPart> parts = {})
{
    return makeBox<QVBoxLayout>(margins, gap, parts);
}

[[nodiscard]] inline QHBoxLayout *makeRow(QMargins margins, int gap,
                                          std::initializer_list<BoxPart> parts = {})
{
    return makeBox<QHBoxLayout>(margins, gap, parts);
}

/// Lays \p parts out below each other in all of \p whole.
inline QVBoxLayout *layOutColumn(QWidget *whole, QMargins margins, int gap,
                                 std::initializer_list<BoxPart> parts = {})
{
    QVBoxLayout *column = makeColumn(margins, gap, parts);
    whole->setLayout(column);
    return column;
}

/// Lays \p parts out beside each other in all of \p whole.
inline QHBoxLayout *layOutRow(QWidget *whole, QMargins margins, int gap,
                              std::initializer_list<BoxPart> parts = {})
{
    QHBoxLayout *row = makeRow(margins, gap, parts);
    whole->setLayout(row);
    return row;
}

} // namespace cradle
