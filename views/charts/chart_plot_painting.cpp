// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"
#include "views/charts/number_text.h"
#include "views/charts/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double timeGap = 32.0;  ///< px between the texts of two times, at least
constexpr double hitHeight = 5.0; ///< px

/// The middle of the pixel, where a line of one pixel is sharp.
double sharp(double x)
{
    return std::floor(x) + 0.5;
}

} // namespace

void ChartPlot::drawBackground(QPainter *painter, const QRectF &rect)
{
    painter->fillRect(rect, theme().panel);
    if (!m_showsRun)
        return;
    painter->setRenderHint(QPainter::Antialiasing, false);
    drawTicks(*painter);
    painter->setRenderHint(QPainter::Antialiasing, true);
}

void ChartPlot::drawTicks(QPainter &painter) const
{
    const Theme &colours = theme();
    painter.setFont(smallFont());
    const QFontMetricsF metrics(painter.font());
    for (const double tick : m_scale.ticks()) {
        const double y = sharp(yOf(tick));
        painter.setPen(tick == 0.0 ? colours.border : colours.grid);
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        const QString text = tickNumber(tick, m_scale.step);
        const double x = m_area.left() - 8.0 - metrics.horizontalAdvance(text);
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(x, y + std::round(0.5 * metrics.capHeight())), text);
    }
    painter.setPen(colours.border);
    const double axis = sharp(m_area.bottom());
    painter.drawLine(QPointF(m_area.left(), axis), QPointF(m_area.right(), axis));

    const QString unit = tr("s", "seconds");
    AxisScale times{m_moment.from, m_moment.to, 1.0};
    const double widest =
        metrics.horizontalAdvance(tickNumber(m_moment.to, 0.01 * (times.high - times.low)) + unit);
    const double count = std::clamp(m_area.width() / (widest + timeGap), 1.0, 10.0);
    times.step = niceStep((times.high - times.low) / count);
    const std::vector<double> ticks = times.ticks();
    const double baseline = axis + 6.0 + std::ceil(metrics.ascent());
    for (const double tick : ticks) {
        QString text = tickNumber(tick, times.step);
        if (tick == ticks.back())
            text += QChar::Nbsp + unit;
        const double width = metrics.horizontalAdvance(text);
        const double x = std::min(xOf(tick) - 0.5 * width, viewport()->width() - width - 2.0);
        painter.setPen(colours.border);
        painter.drawLine(QPointF(sharp(xOf(tick)), axis), QPointF(sharp(xOf(tick)), axis + 3.0));
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(std::round(x), baseline), text);
    }
}

void ChartPlot::drawForeground(QPainter *painter, const QRectF &)
{
    const Theme &colours = theme();
    painter->setFont(smallFont());
    if (!m_showsRun) {
        painter->setFont(font());
        painter->setPen(colours.mutedText);
        painter->drawText(QRectF(viewport()->rect()).adjusted(16.0, 0.0, -16.0, -16.0),
                          Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    painter->setRenderHint(QPainter::Antialiasing, false);
    drawHits(*painter);
    painter->setPen(colours.accent);
    const double x = sharp(std::clamp(xOf(m_moment.shown), m_area.left(), m_area.right()));
    painter->drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
    painter->setRenderHint(QPainter::Antialiasing, true);
    drawLabels(*painter);
}

void ChartPlot::drawHits(QPainter &painter) const
{
    const Theme &colours = theme();
    painter.setPen(colours.along);
    for (const double mark : m_hitMarks) {
        const double x = sharp(mark);
        painter.drawLine(QPointF(x, m_area.bottom() - hitHeight), QPointF(x, m_area.bottom()));
    }
    if (m_nearestHit) {
        QPen pen(colours.mutedText, 1.0, Qt::CustomDashLine);
        pen.setDashPattern({3.0, 3.0});
        painter.setPen(pen);
        const double x = sharp(*m_nearestHit);
        painter.drawLine(QPointF(x, m_area.bottom()), QPointF(x, m_area.top()));
    }
}

void ChartPlot::drawLabels(QPainter &painter) const
{
    const QFontMetricsF metrics(painter.font());
    QColor behind = theme().panel;
    behind.setAlphaF(0.8F);
    for (std::size_t i = 0; i < m_labelRects.size(); ++i) {
        const QRectF &rect = m_labelRects[i];
        if (rect.isEmpty())
            continue;
        painter.fillRect(rect, behind);
        painter.setPen(readableOn(m_curves[i].colour, theme().panel));
        drawSubscripted(painter, {rect.left() + 2.0, rect.top() + std::round(metrics.ascent())},
                        m_labelTexts[i]);
    }
}

} // namespace cradle
