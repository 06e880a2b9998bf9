// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

namespace cradle {

/// The header of the table of circles: a symbol with its index lowered (v_x), over its unit.
class CircleHeader final : public QHeaderView
{
    Q_OBJECT
public:
    explicit CircleHeader(QWidget *parent = nullptr);

    /// Width of a section's symbol and unit, px.
    [[nodiscard]] int widthOf(int section) const;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int logicalIndex) const override;
    [[nodiscard]] QSize sectionSizeFromContents(int logicalIndex) const override;

private:
    struct Parts {
        QString symbol;
        QString index;
        QString unit;
    };
    [[nodiscard]] Parts partsOf(int section) const;
    [[nodiscard]] QFont smallFont() const;
};

} // namespace cradle
