// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHeaderView>

namespace cradle {

/// The header of a table of quantities: the symbol, with its subscript, over the unit.
class SymbolHeader final : public QHeaderView
{
    Q_OBJECT
public:
    /// \param unitRole  of the model's header data
    explicit SymbolHeader(int unitRole, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
    [[nodiscard]] QSize sectionSizeFromContents(int section) const override;

private:
    [[nodiscard]] QFont unitFont() const;
    [[nodiscard]] QString symbol(int section) const;
    [[nodiscard]] QString unit(int section) const;

    int m_unitRole;
};

/// The numbers beside the rows of such a table, each in the colour that the model gives it.
class NumberHeader final : public QHeaderView
{
    Q_OBJECT
public:
    explicit NumberHeader(QWidget *parent = nullptr);

protected:
    void paintSection(QPainter *painter, const QRect &rect, int section) const override;
    [[nodiscard]] QSize sectionSizeFromContents(int section) const override;
};

} // namespace cradle
