// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QRectF>
#include <QSizeF>

#include <optional>
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

/// A curve's label, which may tell the curve's value at one place of it.
struct CurveLabel {
    QSizeF size{}; ///< px; empty: the curve has none
    /// With the value, px; only where the curve is at \p value.
    QSizeF sizeWithValue{};
    std::optional<QPointF> value{}; ///< the place that the value is of, px

    friend bool operator==(const CurveLabel &, const CurveLabel &) = default;
};

/// Where a label goes.
struct PlacedLabel {
    QRectF rect{}; ///< px; empty: it finds no room
    bool tellsValue = false;
};

/// Places a label at each curve: beside it, over no other label, upon it or over other curves only
/// if need be, and where it was before as long as that is not much worse. One that tells a value
/// stands at the place that the value is of, or where the curve is level at it; if it finds no room
/// there, it tells none.
class LabelLayout
{
public:
    /// \param labels  one to a curve, the most important first
    /// \param taken   where no label may be, px
    [[nodiscard]] std::vector<PlacedLabel> place(const QRectF &plot,
                                                 const std::vector<CurveProfile> &curves,
                                                 const std::vector<CurveLabel> &labels,
                                                 const QRectF &taken = {});
    void forget() { m_lastSlots.clear(); }

private:
    struct Search;

    std::vector<int> m_lastSlots;
};

} // namespace cradle
