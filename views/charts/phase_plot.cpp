// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/phase_plot.h"

#include "views/theme.h"

#include <algorithm>

namespace cradle {

namespace {

constexpr double rangeMargin = 0.06; ///< of the axis, beyond the range on both sides
constexpr double dotRadius = 4.0;    ///< px

} // namespace

PhasePlot::PhasePlot(QWidget *parent)
    : Plot({.topRoom = 18.0, .tickHeight = 32.0}, parent)
{
}

void PhasePlot::showPicture(const PhasePicture &picture)
{
    m_picture = picture;
    double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
    for (const PlotLine &curve : picture.curves) {
        for (const QPointF &point : curve.points) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    }
    m_acrossRange.fit(left, right, std::max(right, -left));
    m_upRange.fit(low, high, std::max(high, -low));
    const int ticks = std::max(1, rows());
    const auto axis = [ticks](const SteadyRange &range, const std::optional<ValueSpan> &span) {
        return span ? AxisScale{span->low, span->high, niceStep((span->high - span->low) / ticks)}
                    : range.scale(ticks, rangeMargin);
    };
    layOut({.scale = axis(m_acrossRange, picture.across), .name = picture.acrossText},
           {.scale = axis(m_upRange, picture.up), .name = picture.upText}, picture.isEqual);
    showLines(picture.curves);
}

void PhasePlot::forgetRanges()
{
    m_acrossRange.reset();
    m_upRange.reset();
}

void PhasePlot::drawOver(QPainter &painter) const
{
    if (!m_picture.moment || !plotArea().contains(placeOf(*m_picture.moment)))
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().panel, 1.5));
    painter.setBrush(m_picture.momentColour);
    painter.drawEllipse(placeOf(*m_picture.moment), dotRadius, dotRadius);
    painter.setBrush(Qt::NoBrush);
}

} // namespace cradle
