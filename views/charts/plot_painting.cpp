// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What Plot draws itself.
#include "views/charts/plot.h"
#include "views/number_text.h"
#include "views/subscript_text.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace cradle {

namespace {

constexpr float areaAlpha = 0.28F;
constexpr float boxAlpha = 0.15F;
constexpr double chipRoom = 4.0; ///< px around the text that tells
constexpr double endRoom = 5.0;  ///< px beside the last number of an axis

QColor faint(QColor colour, float alpha)
{
    colour.setAlphaF(alpha);
    return colour;
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

/// The parts of a line that are within \p rect.
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

void Plot::drawBackground(QPainter *painter, const QRectF &rect)
{
    painter->fillRect(rect, theme().panel);
    if (!m_showsRun)
        return;
    painter->setLayoutDirection(layoutDirection()); // else it is the application's
    painter->setFont(smallFont());
    painter->setRenderHint(QPainter::Antialiasing, false);
    drawUpAxis(*painter);
    drawAcrossAxis(*painter);
    drawUnder(*painter);
    painter->save();
    painter->setClipRect(m_area);
    painter->setPen(Qt::NoPen);
    painter->setRenderHint(QPainter::Antialiasing);
    for (const DrawnLine &line : m_lines) {
        painter->setBrush(faint(line.pen.color(), areaAlpha));
        if (!line.area.isEmpty())
            painter->drawPolygon(line.area);
    }
    drawDense(*painter);
    painter->restore();
}

void Plot::drawForeground(QPainter *painter, const QRectF &)
{
    painter->setLayoutDirection(layoutDirection());
    if (m_showsRun) {
        painter->setFont(smallFont());
        drawOver(*painter);
        if (m_drag == Drag::Box)
            drawBox(*painter);
    } else {
        painter->setFont(font());
        painter->setPen(theme().mutedText);
        painter->setLayoutDirection(directionOf(m_emptyText));
        painter->drawText(QRectF(viewport()->rect()).adjusted(16.0, 0.0, -16.0, -16.0),
                          Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    }
    if (hasFocus())
        drawFocus(*painter);
}

void Plot::paint(QPainter &painter) const
{
    painter.setLayoutDirection(layoutDirection());
    painter.setFont(smallFont());
    drawUpAxis(painter);
    drawAcrossAxis(painter);
    drawUnder(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    for (const DrawnLine &line : m_lines) {
        painter.setBrush(faint(line.pen.color(), areaAlpha));
        if (!line.area.isEmpty())
            painter.drawPolygon(line.area.intersected(QPolygonF(m_area)));
    }
    painter.setBrush(Qt::NoBrush);
    drawDense(painter);
    for (const DrawnLine &line : m_lines) {
        painter.setPen(line.pen);
        for (const QPolygonF &part :
             line.isDense ? QList<QPolygonF>() : clippedLines(line.pixels, m_area))
            painter.drawPolyline(part);
    }
    drawOver(painter);
}

/// What a line over time fills, each column by itself; no thinner than the line would be, so that
/// there is no gap between two that are nearly upright.
QList<QRectF> Plot::columnsOf(std::size_t line) const
{
    QList<QRectF> columns;
    const CurveProfile &profile = m_profiles[line];
    const double width = m_lines[line].pen.widthF() > 1.0 ? 2.0 : 1.0;
    for (int x = 0; x < static_cast<int>(m_area.width()); ++x) {
        const double top = std::max(profile.top(x), m_area.top());
        const double bottom = std::min(profile.bottom(x), m_area.bottom());
        const double left = std::floor(m_area.left()) + x;
        if (profile.covers(x) && top <= bottom)
            columns.emplaceBack(left, top, std::min(width, m_area.right() - left),
                                std::max(bottom - top, 1.0));
    }
    return columns;
}

/// Nothing of them is smooth.
void Plot::drawDense(QPainter &painter) const
{
    const bool smooth = painter.testRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const DrawnLine &line = m_lines[i];
        if (!line.isDense)
            continue;
        if (line.isOverTime) {
            for (const QRectF &column : columnsOf(i))
                painter.fillRect(column, line.pen.color());
            continue;
        }
        painter.setPen(QPen(line.pen.color(), 1.0));
        for (const QPolygonF &part : clippedLines(line.pixels, m_area))
            painter.drawPolyline(part);
    }
    painter.setRenderHint(QPainter::Antialiasing, smooth);
}

QString Plot::numberAt(const PlotAxis &axis, double tick) const
{
    if (axis.isShare)
        return tr("%1 %", "share").arg(tickNumber(100.0 * tick, 100.0 * axis.scale.step));
    return tickNumber(tick, axis.scale.step);
}

void Plot::drawUpAxis(QPainter &painter) const
{
    const Theme &colours = theme();
    const QFontMetricsF metrics(painter.font());
    for (const double tick : m_up.scale.ticks()) {
        const double y = sharp(yOf(tick));
        painter.setPen(tick == 0.0 ? colours.border : colours.grid);
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        const QString text = numberAt(m_up, tick);
        const double x = m_area.left() - 8.0 - metrics.horizontalAdvance(text);
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(x, y + std::round(0.5 * metrics.capHeight())), text);
    }
    painter.setPen(colours.mutedText);
    drawSubscripted(painter, {6.0, std::round(metrics.ascent()) + 1.0}, m_up.name);
}

/// A name stands at the end of the axis; numbers that would meet it are left out.
void Plot::drawAcrossAxis(QPainter &painter) const
{
    const Theme &colours = theme();
    const QFontMetricsF metrics(painter.font());
    const double axis = sharp(m_area.bottom());
    const double baseline = axis + 6.0 + std::ceil(metrics.ascent());
    const bool isNamed = !m_across.name.isEmpty();
    const double nameWidth =
        isNamed ? std::ceil(subscriptWidth(painter.font(), m_across.name)) + 2.0 : 0.0;
    const double right = viewport()->width() - endRoom - nameWidth;
    painter.setPen(colours.mutedText);
    drawSubscripted(painter, {right, baseline}, m_across.name);
    painter.setPen(colours.border);
    painter.drawLine(QPointF(m_area.left(), axis), QPointF(m_area.right(), axis));
    const std::vector<double> ticks = m_across.scale.ticks();
    for (const double tick : ticks) {
        const double x = sharp(xOf(tick));
        painter.setPen(isNamed && tick != 0.0 ? colours.grid : colours.border);
        painter.drawLine(QPointF(x, isNamed ? m_area.top() : axis), QPointF(x, axis + 3.0));
        QString text = numberAt(m_across, tick);
        if (tick == ticks.back() && !m_across.unit.isEmpty())
            text += QChar::Nbsp + m_across.unit;
        const double width = metrics.horizontalAdvance(text);
        double left = xOf(tick) - 0.5 * width;
        if (isNamed && left + width > right - 8.0)
            continue;
        left = std::min(left, right - width);
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(std::round(left), baseline), text);
    }
}

void Plot::drawBox(QPainter &painter) const
{
    painter.setPen(QPen(theme().accent, 1.0));
    painter.setBrush(faint(theme().accent, boxAlpha));
    painter.drawRect(box());
    painter.setBrush(Qt::NoBrush);
}

/// That the keys act here, and what they told last, in a chip.
void Plot::drawFocus(QPainter &painter) const
{
    const QRectF rect(viewport()->rect());
    painter.setPen(QPen(theme().accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect.adjusted(1.0, 1.0, -1.0, -1.0));
    const QString text = m_showsRun ? told() : QString();
    if (text.isEmpty())
        return;
    painter.setFont(smallFont());
    const QPointF corner = m_area.topLeft() + QPointF(chipRoom, chipRoom);
    const QSizeF room(rect.right() - corner.x() - 3.0 * chipRoom, rect.height());
    const QSizeF size =
        QFontMetricsF(painter.font())
            .boundingRect(QRectF({}, room), Qt::AlignCenter | Qt::TextWordWrap, text)
            .size();
    const QRectF chip(corner, QSizeF(std::ceil(size.width()) + 2.0 * chipRoom,
                                     std::ceil(size.height()) + chipRoom));
    painter.fillRect(chip, theme().panel);
    painter.setPen(theme().text);
    painter.setLayoutDirection(directionOf(text));
    painter.drawText(chip, Qt::AlignCenter | Qt::TextWordWrap, text);
    painter.setPen(QPen(theme().accent, 1.0));
    painter.drawRect(chip);
}

} // namespace cradle
