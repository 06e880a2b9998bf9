// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"
#include "views/charts/number_text.h"
#include "views/charts/plot_focus.h"
#include "views/charts/subscript_text.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QLineSeries>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cradle {

namespace {

constexpr double timeGap = 32.0;  ///< px between the texts of two times, at least
constexpr double hitHeight = 5.0; ///< px
constexpr float areaAlpha = 0.28F;

/// The middle of the pixel, where a line of one pixel is sharp.
double sharp(double x)
{
    return std::floor(x) + 0.5;
}

/// The part of the way from \p a to \p b that is within \p rect, if any is. (Liang and Barsky)
std::optional<QLineF> clipped(QPointF a, QPointF b, const QRectF &rect)
{
    double from = 0.0;
    double to = 1.0;
    const QPointF d = b - a;
    const std::array<std::pair<double, double>, 4> sides{
        std::pair{-d.x(), a.x() - rect.left()}, std::pair{d.x(), rect.right() - a.x()},
        std::pair{-d.y(), a.y() - rect.top()}, std::pair{d.y(), rect.bottom() - a.y()}};
    for (const auto &[p, q] : sides) {
        if (p == 0.0 && q < 0.0)
            return std::nullopt;
        if (p < 0.0)
            from = std::max(from, q / p);
        else if (p > 0.0)
            to = std::min(to, q / p);
    }
    if (from > to)
        return std::nullopt;
    return QLineF(a + from * d, a + to * d);
}

/// The parts of a curve that are within \p rect.
QList<QPolygonF> clippedLines(const QList<QPointF> &points, const QRectF &rect)
{
    QList<QPolygonF> parts;
    for (qsizetype i = 1; i < points.size(); ++i) {
        const auto line = clipped(points[i - 1], points[i], rect);
        if (!line)
            continue;
        if (parts.isEmpty() || parts.last().last() != line->p1())
            parts.append(QPolygonF{line->p1()});
        parts.last().append(line->p2());
    }
    return parts;
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
    drawAreas(*painter);
    drawDense(*painter);
}

/// Columns that a curve fills from top to bottom, each as one upright line.
void ChartPlot::drawDense(QPainter &painter) const
{
    const bool smooth = painter.testRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::Antialiasing, false);
    QList<QLineF> columns;
    for (std::size_t i = 0; i < m_dense.size(); ++i) {
        if (!m_dense[i])
            continue;
        columns.clear();
        for (int x = 0; x < static_cast<int>(m_area.width()); ++x) {
            const double top = std::max(m_profiles[i].top(x), m_area.top());
            const double bottom = std::min(m_profiles[i].bottom(x), m_area.bottom());
            if (m_profiles[i].covers(x) && top <= bottom)
                columns.emplaceBack(sharp(m_area.left() + x), top, sharp(m_area.left() + x),
                                    std::max(bottom, top + 1.0));
        }
        painter.setPen(QPen(m_curves[i].colour, 1.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLines(columns);
    }
    painter.setRenderHint(QPainter::Antialiasing, smooth);
}

void ChartPlot::drawAreas(QPainter &painter) const
{
    if (m_areas.empty())
        return;
    painter.save();
    painter.setClipRect(m_area);
    painter.setPen(Qt::NoPen);
    auto area = m_areas.begin();
    for (const ChartCurve &curve : m_curves) {
        if (!curve.isFilled || area == m_areas.end())
            continue;
        QColor fill = curve.colour;
        fill.setAlphaF(areaAlpha);
        painter.setBrush(fill);
        painter.drawPolygon(*area++);
    }
    painter.restore();
}

void ChartPlot::drawTicks(QPainter &painter) const
{
    const Theme &colours = theme();
    painter.setLayoutDirection(layoutDirection()); // else it is the application's
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
    const double count = std::clamp(m_area.width() / (widest + timeGap * textScale()), 1.0, 10.0);
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
    if (m_showsRun) {
        drawOver(*painter);
    } else {
        painter->setFont(font());
        painter->setPen(theme().mutedText);
        painter->setLayoutDirection(directionOf(m_emptyText));
        painter->drawText(QRectF(viewport()->rect()).adjusted(16.0, 0.0, -16.0, -16.0),
                          Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    }
    if (hasFocus()) {
        painter->setFont(smallFont());
        drawPlotFocus(*painter, QRectF(viewport()->rect()), m_area.topLeft(), toldCurve());
    }
}

void ChartPlot::paint(QPainter &painter) const
{
    drawTicks(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    auto area = m_areas.begin();
    for (const ChartCurve &curve : m_curves) {
        if (!curve.isFilled || area == m_areas.end())
            continue;
        QColor fill = curve.colour;
        fill.setAlphaF(areaAlpha);
        painter.setBrush(fill);
        painter.drawPolygon(area->intersected(QPolygonF(m_area)));
        ++area;
    }
    painter.setBrush(Qt::NoBrush);
    drawDense(painter);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        if (m_dense[i])
            continue;
        painter.setPen(m_series[i]->pen());
        for (const QPolygonF &line : clippedLines(m_lines[i], m_area))
            painter.drawPolyline(line);
    }
    drawOver(painter);
}

/// All that lies over the curves.
void ChartPlot::drawOver(QPainter &painter) const
{
    painter.setLayoutDirection(layoutDirection());
    painter.setFont(smallFont());
    painter.setRenderHint(QPainter::Antialiasing, false);
    drawHits(painter);
    painter.setPen(theme().accent);
    const double x = sharp(std::clamp(xOf(m_moment.shown), m_area.left(), m_area.right()));
    const bool inside = m_moment.shown >= m_moment.from && m_moment.shown <= m_moment.to;
    if (inside)
        painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom()));
    painter.setRenderHint(QPainter::Antialiasing, true);
    drawLabels(painter);
    if (m_moment.note)
        drawNote(painter, *m_moment.note, m_noteForm, m_noteRect);
    if (m_drag == Drag::Box)
        drawBox(painter);
}

void ChartPlot::drawBox(QPainter &painter) const
{
    QColor fill = theme().accent;
    fill.setAlphaF(0.15F);
    painter.setPen(QPen(theme().accent, 1.0));
    painter.setBrush(fill);
    painter.drawRect(box());
    painter.setBrush(Qt::NoBrush);
}

void ChartPlot::drawHits(QPainter &painter) const
{
    const Theme &colours = theme();
    painter.setPen(colours.along);
    for (const HitMark &mark : m_hitMarks) {
        const double x = sharp(mark.x);
        painter.drawLine(QPointF(x, m_area.bottom() - hitHeight), QPointF(x, m_area.bottom()));
    }
    for (const auto &[from, to] : m_contacts) {
        const double left = std::max(from, m_area.left());
        const double right = std::min(to, m_area.right());
        if (left < right)
            painter.fillRect(QRectF(left, m_area.bottom() - 2.0, right - left, 2.0), colours.along);
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
