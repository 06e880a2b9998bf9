// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace cradle {

/// The pixels that a drawn curve covers: from top to bottom in each column of the plot.
class CurveProfile
{
public:
    /// \param points  the corners of the curve in px, from left to right
    CurveProfile(const QList<QPointF> &points, const QRectF &plot);

    /// Whether the curve has a point in the column \p x px from the plot's left.
    [[nodiscard]] bool covers(int x) const { return m_top[index(x)] <= m_bottom[index(x)]; }
    [[nodiscard]] double top(int x) const { return m_top[index(x)]; }
    [[nodiscard]] double bottom(int x) const { return m_bottom[index(x)]; }

private:
    [[nodiscard]] std::size_t index(int x) const;
    void cover(int x, double y);

    std::vector<double> m_top;
    std::vector<double> m_bottom;
};

/// Places a label at each curve: beside it, over no other label, over curves only if need be, and
/// where it was before as long as that is not much worse.
class LabelLayout
{
public:
    /// \param sizes  of the labels in px, one to a curve, the most important first; an empty one
    ///               is for a curve without a label
    /// \param taken  where no label may be, px
    /// \return where they go; an empty rectangle for one that finds no room
    [[nodiscard]] std::vector<QRectF> place(const QRectF &plot,
                                            const std::vector<CurveProfile> &curves,
                                            const std::vector<QSizeF> &sizes,
                                            const QRectF &taken = {});
    void forget() { m_lastSlots.clear(); }

private:
    std::vector<int> m_lastSlots;
};

} // namespace cradle
