// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cradle {

namespace {

constexpr int places = 9;           ///< along a curve; above and below at each
constexpr double gap = 2.0;         ///< px between a curve and its label
constexpr double levelWithin = 1.5; ///< px that a level curve may be off
constexpr double beside = 4.0;      ///< px between a value's place and its label
constexpr int besideValue = 4;      ///< places left, right, above and below of a value
constexpr double uponCost = 20.0;   ///< crossed columns that a place upon the curve itself costs
constexpr double inset = 8.0;       ///< px from the plot's left and right end
constexpr double stayBonus = 12.0;  ///< crossed columns that a label puts up with to stay
constexpr double leftBonus = 0.5;   ///< crossed columns that a place further left is worth

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the slot-th place of a label for \p curve is; empty if it is not within the plot.
QRectF candidate(const QRectF &plot, const CurveProfile &curve, QSizeF size, int slot)
{
    const double travel = plot.width() - size.width() - 2.0 * inset;
    if (travel < 0.0)
        return {};
    const int place = slot / 2; // two slots each
    const double x = inset + travel * place / (places - 1);
    double top = infinity;
    double bottom = -infinity;
    for (int column = int(x); column <= int(x + size.width()); ++column) {
        if (curve.covers(column)) {
            top = std::min(top, curve.top(column));
            bottom = std::max(bottom, curve.bottom(column));
        }
    }
    if (top > bottom)
        return {};
    const double y = slot % 2 == 0 ? top - gap - size.height() : bottom + gap;
    const QRectF rect(QPointF(std::round(plot.left() + x), std::round(y)), size);
    return plot.contains(rect) ? rect : QRectF();
}

/// How much a label at \p rect hides or is hidden, in columns of pixels. \param isUpon  it
/// interrupts its own curve
double cost(const QRectF &plot, const QRectF &rect, const CurveProfile &own,
            const std::vector<CurveProfile> &curves, bool isUpon)
{
    double sum = isUpon ? uponCost : 0.0;
    const int from = static_cast<int>(rect.left() - plot.left());
    const int to = static_cast<int>(rect.right() - plot.left());
    for (int column = from; column <= to; ++column) {
        for (const CurveProfile &curve : curves) {
            if (curve.covers(column) && curve.top(column) < rect.bottom() + 1.0
                && curve.bottom(column) > rect.top() - 1.0 && !(isUpon && &curve == &own))
                sum += 1.0;
        }
        // Far from its curve a label could be anyone's.
        if (!own.covers(column))
            sum += 0.3;
        else if (!isUpon)
            sum +=
                0.02 * std::max(own.top(column) - rect.bottom(), rect.top() - own.bottom(column));
    }
    return sum;
}

/// Whether \p curve is level at \p y px along the columns of \p rect, which is relative to the
/// plot.
bool isLevel(const CurveProfile &curve, const QRectF &rect, double y)
{
    for (int x = static_cast<int>(rect.left()); x <= static_cast<int>(rect.right()); ++x) {
        if (curve.covers(x)
            && (std::abs(curve.top(x) - y) > levelWithin
                || std::abs(curve.bottom(x) - y) > levelWithin))
            return false;
    }
    return true;
}

/// A place upon \p curve, where it is level, so that the label interrupts it: between curves that
/// are nearer than a label is high, the others are spared. Empty if it is not within the plot.
QRectF placeUpon(const QRectF &plot, const CurveProfile &curve, QSizeF size, int place)
{
    const QRectF below = candidate(plot, curve, size, 2 * place + 1);
    const QRectF spot = below.isEmpty() ? candidate(plot, curve, size, 2 * place) : below;
    if (spot.isEmpty())
        return {};
    const double y = curve.top(static_cast<int>(spot.center().x() - plot.left()));
    const QRectF rect(QPointF(spot.left(), std::round(y - 0.5 * size.height())), size);
    const bool isWithin = plot.contains(rect);
    return isWithin && isLevel(curve, rect.translated(-plot.left(), 0.0), y) ? rect : QRectF();
}

/// A place left or right of the value, above or below it; empty if it is not within the plot.
QRectF placeBeside(const QRectF &plot, const CurveLabel &label, int slot)
{
    const QSizeF size = label.sizeWithValue;
    const double x =
        slot % 2 == 0 ? label.value->x() - beside - size.width() : label.value->x() + beside;
    const double y = slot < 2 ? label.value->y() - gap - size.height() : label.value->y() + gap;
    const QRectF rect(QPointF(std::round(x), std::round(y)), size);
    return plot.contains(rect) ? rect : QRectF();
}

} // namespace

CurveProfile::CurveProfile(const QList<QPointF> &points, const QRectF &plot)
    : m_top(static_cast<std::size_t>(std::max(1.0, plot.width() + 1.0)), infinity)
    , m_bottom(m_top.size(), -infinity)
{
    const int last = static_cast<int>(m_top.size()) - 1;
    for (qsizetype i = 0; i < points.size(); ++i) {
        const QPointF a = points[std::max<qsizetype>(0, i - 1)] - QPointF(plot.left(), 0.0);
        const QPointF b = points[i] - QPointF(plot.left(), 0.0);
        if (b.x() < 0.0 || a.x() > last)
            continue;
        const int from = static_cast<int>(std::clamp(a.x(), 0.0, double(last)));
        const int to = static_cast<int>(std::clamp(b.x(), 0.0, double(last)));
        for (int x = from; x <= to; ++x) {
            const double part =
                b.x() > a.x() ? std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) : 0.0;
            cover(x, a.y() + part * (b.y() - a.y()));
        }
        cover(to, b.y());
    }
}

std::size_t CurveProfile::index(int x) const
{
    return static_cast<std::size_t>(std::clamp(x, 0, static_cast<int>(m_top.size()) - 1));
}

void CurveProfile::cover(int x, double y)
{
    m_top[index(x)] = std::min(m_top[index(x)], y);
    m_bottom[index(x)] = std::max(m_bottom[index(x)], y);
}

/// The places of one label, of which the best is kept.
struct LabelLayout::Search {
    const QRectF &plot;
    const std::vector<CurveProfile> &curves;
    const CurveProfile &own;
    const std::vector<PlacedLabel> &placed; ///< those before it
    const QRectF &taken;
    int lastSlot;
    double best = infinity;
    int bestSlot = -1;
    PlacedLabel found{};

    void consider(const QRectF &rect, int slot, bool tellsValue, bool isUpon = false)
    {
        const bool meets = std::any_of(placed.begin(), placed.end(), [&](const PlacedLabel &other) {
            return other.rect.intersects(rect.adjusted(-4.0, 0.0, 4.0, 0.0));
        });
        if (rect.isEmpty() || meets || taken.intersects(rect))
            return;
        const double bonus = slot == lastSlot ? stayBonus : 0.0;
        const double price = cost(plot, rect, own, curves, isUpon) + leftBonus * slot - bonus;
        if (price < best) {
            best = price;
            bestSlot = slot;
            found = {rect, tellsValue};
        }
    }
};

std::vector<PlacedLabel> LabelLayout::place(const QRectF &plot,
                                            const std::vector<CurveProfile> &curves,
                                            const std::vector<CurveLabel> &labels,
                                            const QRectF &taken)
{
    m_lastSlots.resize(labels.size(), -1);
    std::vector<PlacedLabel> placed;
    for (std::size_t c = 0; c < labels.size(); ++c) {
        const CurveLabel &label = labels[c];
        Search search{plot, curves, curves[c], placed, taken, m_lastSlots[c]};
        if (label.value && !label.sizeWithValue.isEmpty()) {
            for (int slot = 0; slot < 2 * places; ++slot) {
                const QRectF rect = candidate(plot, curves[c], label.sizeWithValue, slot);
                if (isLevel(curves[c], rect.translated(-plot.left(), 0.0), label.value->y()))
                    search.consider(rect, slot, true);
            }
            for (int slot = 0; slot < besideValue; ++slot)
                search.consider(placeBeside(plot, label, slot), 2 * places + slot, true);
            for (int place = 0; place < places; ++place) {
                const QRectF rect = placeUpon(plot, curves[c], label.sizeWithValue, place);
                if (isLevel(curves[c], rect.translated(-plot.left(), 0.0), label.value->y()))
                    search.consider(rect, 2 * places + besideValue + place, true, true);
            }
        }
        if (search.bestSlot < 0 && !label.size.isEmpty()) {
            for (int slot = 0; slot < 2 * places; ++slot)
                search.consider(candidate(plot, curves[c], label.size, slot), slot, false);
            for (int place = 0; place < places; ++place)
                search.consider(placeUpon(plot, curves[c], label.size, place),
                                2 * places + besideValue + place, false, true);
        }
        m_lastSlots[c] = search.bestSlot;
        placed.push_back(search.found);
    }
    return placed;
}

} // namespace cradle
