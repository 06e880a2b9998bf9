// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What ChartPlot draws over its curves.
#include "views/charts/chart_plot.h"
#include "views/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double hitHeight = 5.0; ///< px

} // namespace

/// All that lies over the curves.
void ChartPlot::drawOver(QPainter &painter) const
{
    painter.setRenderHint(QPainter::Antialiasing, false);
    drawHits(painter);
    painter.setPen(theme().accent);
    const double x = sharp(std::clamp(xOf(m_moment.shown), plotArea().left(), plotArea().right()));
    const bool inside = m_moment.shown >= m_moment.from && m_moment.shown <= m_moment.to;
    if (inside)
        painter.drawLine(QPointF(x, plotArea().top()), QPointF(x, plotArea().bottom()));
    painter.setRenderHint(QPainter::Antialiasing, true);
    drawLabels(painter);
    if (m_moment.note)
        drawNote(painter, *m_moment.note, m_noteForm, m_noteRect);
}

void ChartPlot::drawHits(QPainter &painter) const
{
    const Theme &colours = theme();
    const QRectF area = plotArea();
    painter.setPen(colours.along);
    for (const HitMark &mark : m_hitMarks) {
        const double x = sharp(mark.x);
        painter.drawLine(QPointF(x, area.bottom() - hitHeight), QPointF(x, area.bottom()));
    }
    for (const auto &[from, to] : m_contacts) {
        const double left = std::max(from, area.left());
        const double right = std::min(to, area.right());
        if (left < right)
            painter.fillRect(QRectF(left, area.bottom() - 2.0, right - left, 2.0), colours.along);
    }
    if (m_nearestHit) {
        QPen pen(colours.mutedText, 1.0, Qt::CustomDashLine);
        pen.setDashPattern({3.0, 3.0});
        painter.setPen(pen);
        const double x = sharp(*m_nearestHit);
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x, area.top()));
    }
}

void ChartPlot::drawLabels(QPainter &painter) const
{
    const QFontMetricsF metrics(painter.font());
    for (std::size_t i = 0; i < m_labelRects.size(); ++i) {
        const QRectF &rect = m_labelRects[i];
        if (rect.isEmpty())
            continue;
        painter.fillRect(rect, theme().panel); // no line strikes a text out
        painter.setPen(readableOn(m_curves[i].colour, theme().panel));
        drawSubscripted(painter, {rect.left() + 2.0, rect.top() + std::round(metrics.ascent())},
                        m_labelTexts[i]);
    }
}

} // namespace cradle
