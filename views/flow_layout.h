// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <memory>
#include <vector>

namespace cradle {

/// Lays out controls as words in a text: side by side, and in further rows what does not fit.
class FlowLayout final : public QLayout
{
public:
    FlowLayout() = default;
    ~FlowLayout() override = default;

    void addItem(QLayoutItem *item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(m_items.size()); }
    [[nodiscard]] QLayoutItem *itemAt(int index) const override;
    QLayoutItem *takeAt(int index) override;
    [[nodiscard]] QSize sizeHint() const override; ///< all in one row
    [[nodiscard]] QSize minimumSize() const override;
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    void setGeometry(const QRect &rect) override;

private:
    /// \return the height that all rows need, with the margins, px
    int arrange(const QRect &whole, bool places) const;

    std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

} // namespace cradle
