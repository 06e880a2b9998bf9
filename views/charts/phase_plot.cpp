// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/phase_plot.h"

#include "views/charts/number_text.h"
#include "views/charts/plot_focus.h"
#include "views/charts/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int textPixels = 11;
constexpr double leastGutter = 42.0;  ///< px for the values left of the plot
constexpr double rightRoom = 14.0;    ///< px
constexpr double topRoom = 18.0;      ///< px: for the name of the vertical axis
constexpr double axisRoom = 22.0;     ///< px for the values below the plot
constexpr double tickHeight = 32.0;   ///< px from one value to the next, at least
constexpr double tickWidth = 56.0;    ///< px
constexpr double margin = 0.06;       ///< of the axis, beyond the range on both sides
constexpr double dotRadius = 4.0;     ///< px
constexpr double leastStep = 0.4;     ///< px: what is nearer to the last point is left out
constexpr qsizetype fewPoints = 4000; ///< of more a smooth line would cost too much

double sharp(double x)
{
    return std::floor(x) + 0.5;
}

void setEnds(AxisScale &axis, const std::optional<ValueSpan> &span, int ticks)
{
    if (span)
        axis = {span->low, span->high, niceStep((span->high - span->low) / std::max(1, ticks))};
}

/// Makes \p axis \p factor times as long, about its middle.
void widen(AxisScale &axis, double factor)
{
    const double middle = 0.5 * (axis.low + axis.high);
    axis.low = middle + factor * (axis.low - middle);
    axis.high = middle + factor * (axis.high - middle);
}

} // namespace

PhasePlot::PhasePlot(QWidget *parent)
    : QWidget(parent)
{
    setLayoutDirection(Qt::LeftToRight);
    setCursor(Qt::CrossCursor);
    setFocusPolicy(Qt::TabFocus);
}

void PhasePlot::showPicture(const PhasePicture &picture)
{
    m_picture = picture;
    m_emptyText.clear();
    layOut();
    update();
}

void PhasePlot::showEmpty(const QString &text)
{
    m_picture = {};
    m_emptyText = text;
    update();
}

void PhasePlot::forgetRanges()
{
    m_acrossRange.reset();
    m_upRange.reset();
}

QFont PhasePlot::smallFont() const
{
    QFont small = font();
    small.setPixelSize(scaledByText(textPixels));
    return small;
}

void PhasePlot::layOut()
{
    double left = 0.0, right = 0.0, low = 0.0, high = 0.0;
    for (const PhasePicture::Curve &curve : m_picture.curves) {
        for (const QPointF &point : curve.points) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    }
    m_acrossRange.fit(left, right, std::max(right, -left));
    m_upRange.fit(low, high, std::max(high, -low));
    const double height = this->height() - topRoom * textScale() - axisRoom * textScale();
    const int rows = static_cast<int>(height / (tickHeight * textScale()));
    m_up = m_upRange.scale(rows, margin);
    setEnds(m_up, m_picture.up, rows);
    const QFontMetricsF metrics(smallFont());
    double gutter = leastGutter * textScale();
    for (const double tick : m_up.ticks())
        gutter = std::max(gutter,
                          std::ceil(metrics.horizontalAdvance(tickNumber(tick, m_up.step))) + 18.0);
    m_area = QRectF(gutter, topRoom * textScale(), std::max(1.0, width() - gutter - rightRoom),
                    std::max(1.0, height));
    const int columns = static_cast<int>(m_area.width() / (tickWidth * textScale()));
    m_across = m_acrossRange.scale(columns, margin);
    setEnds(m_across, m_picture.across, columns);
    if (m_picture.isEqual) {
        const double across = m_area.width() / (m_across.high - m_across.low);
        const double up = m_area.height() / (m_up.high - m_up.low);
        widen(across > up ? m_across : m_up, std::max(across / up, up / across));
    }
}

QPointF PhasePlot::placeOf(QPointF values) const
{
    return {m_area.left()
                + (values.x() - m_across.low) / (m_across.high - m_across.low) * m_area.width(),
            m_area.bottom() - (values.y() - m_up.low) / (m_up.high - m_up.low) * m_area.height()};
}

QPointF PhasePlot::valuesAt(QPointF pixel) const
{
    const double right = (pixel.x() - m_area.left()) / m_area.width();
    const double up = (m_area.bottom() - pixel.y()) / m_area.height();
    return {m_across.low + right * (m_across.high - m_across.low),
            m_up.low + up * (m_up.high - m_up.low)};
}

void PhasePlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), theme().panel);
    if (m_picture.curves.empty()) {
        painter.setPen(theme().mutedText);
        painter.drawText(QRectF(rect()).adjusted(16.0, 0.0, -16.0, -16.0),
                         Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        if (hasFocus())
            drawPlotFocus(painter, rect(), {}, {});
        return;
    }
    paint(painter);
    if (hasFocus())
        drawPlotFocus(painter, rect(), m_area.topLeft(), m_picture.told);
    if (m_drag == Drag::Box) {
        QColor fill = theme().accent;
        fill.setAlphaF(0.15F);
        painter.setPen(QPen(theme().accent, 1.0));
        painter.setBrush(fill);
        painter.drawRect(box());
    }
}

void PhasePlot::paint(QPainter &painter) const
{
    painter.setLayoutDirection(layoutDirection());
    painter.setFont(smallFont());
    drawAxes(painter);
    drawCurves(painter);
    if (m_picture.moment && m_area.contains(placeOf(*m_picture.moment))) {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(theme().panel, 1.5));
        painter.setBrush(m_picture.momentColour);
        painter.drawEllipse(placeOf(*m_picture.moment), dotRadius, dotRadius);
        painter.setBrush(Qt::NoBrush);
    }
}

void PhasePlot::drawAxes(QPainter &painter) const
{
    const Theme &colours = theme();
    const QFontMetricsF metrics(painter.font());
    for (const double tick : m_up.ticks()) {
        const double y = sharp(placeOf({0.0, tick}).y());
        painter.setPen(tick == 0.0 ? colours.border : colours.grid);
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        const QString text = tickNumber(tick, m_up.step);
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(m_area.left() - 8.0 - metrics.horizontalAdvance(text),
                                 y + std::round(0.5 * metrics.capHeight())),
                         text);
    }
    painter.setPen(colours.mutedText);
    drawSubscripted(painter, {6.0, std::round(metrics.ascent()) + 1.0}, m_picture.upText);
    const double axis = sharp(m_area.bottom());
    painter.setPen(colours.border);
    painter.drawLine(QPointF(m_area.left(), axis), QPointF(m_area.right(), axis));
    // The name stands at the end of the axis; values that would meet it are left out.
    const double baseline = axis + 6.0 + std::ceil(metrics.ascent());
    const double nameLeft =
        width() - 4.0 - std::ceil(subscriptWidth(painter.font(), m_picture.acrossText));
    painter.setPen(colours.mutedText);
    drawSubscripted(painter, {nameLeft, baseline}, m_picture.acrossText);
    for (const double tick : m_across.ticks()) {
        const double x = sharp(placeOf({tick, 0.0}).x());
        painter.setPen(tick == 0.0 ? colours.border : colours.grid);
        painter.drawLine(QPointF(x, m_area.top()), QPointF(x, m_area.bottom() + 3.0));
        const QString text = tickNumber(tick, m_across.step);
        const double advance = metrics.horizontalAdvance(text);
        if (x + 0.5 * advance > nameLeft - 8.0)
            continue;
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(std::round(x - 0.5 * advance), baseline), text);
    }
}

void PhasePlot::drawCurves(QPainter &painter) const
{
    painter.save();
    painter.setClipRect(m_area);
    for (const PhasePicture::Curve &curve : m_picture.curves) {
        QPolygonF line;
        for (const QPointF &point : curve.points) {
            const QPointF place = placeOf(point);
            if (line.isEmpty() || (place - line.last()).manhattanLength() >= leastStep)
                line.append(place);
        }
        painter.setRenderHint(QPainter::Antialiasing, line.size() < fewPoints);
        painter.setPen(line.size() < fewPoints ? curve.pen : QPen(curve.pen.color(), 1.0));
        painter.drawPolyline(line);
    }
    painter.restore();
}

void PhasePlot::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    layOut();
}

} // namespace cradle
