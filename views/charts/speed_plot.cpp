// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/speed_plot.h"

#include "views/charts/speed_distribution.h"
#include "views/number_text.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr double legendSwatch = 10.0; ///< px
/// The axis of shares ends at this many times the top of the curve.
constexpr double headroom = 2.0;

QColor barColour()
{
    QColor fill = theme().kinetic;
    fill.setAlphaF(0.45F);
    return fill;
}

} // namespace

/// Over the lines there is room for the text over a bar that is cut off.
SpeedPlot::SpeedPlot(QWidget *parent)
    : Plot({.topRoom = 16.0, .tickHeight = 36.0, .isPicked = false}, parent)
{
}

void SpeedPlot::showPicture(const SpeedPicture &picture)
{
    m_picture = picture;
    const double top = maxwellDensity(picture.spread, picture.spread) * picture.binWidth;
    const double highest = headroom * top;
    layOut({.scale = {0.0, lastSpeed(), 1.0}, .unit = tr("m/s")},
           {.scale = {0.0, highest, niceStep(highest / std::max(1, rows()))}, .isShare = true});
    showLines({curve()});
}

PlotLine SpeedPlot::curve() const
{
    PlotLine line{.points = {{0.0, 0.0}}, .pen = QPen(theme().text, 2.0)};
    const int columns = std::max(1, static_cast<int>(plotArea().width()));
    for (int column = 2; column <= columns; column += 2) {
        const double speed = lastSpeed() * column / columns;
        line.points.append({speed, maxwellDensity(speed, m_picture.spread) * m_picture.binWidth});
    }
    return line;
}

double SpeedPlot::lastSpeed() const
{
    return m_picture.binWidth * static_cast<double>(m_picture.shares.size());
}

QString SpeedPlot::told() const
{
    if (m_told < 0 || m_told >= static_cast<int>(m_picture.shares.size()))
        return {};
    const double low = m_picture.binWidth * m_told;
    const double high = low + m_picture.binWidth;
    const double curve =
        maxwellShareBelow(high, m_picture.spread) - maxwellShareBelow(low, m_picture.spread);
    const auto percent = [](double share) { return tickNumber(100.0 * share, 0.1); };
    return tr("%1 to %2 m/s: %3 %, the curve %4 %")
        .arg(tickNumber(low, m_picture.binWidth), tickNumber(high, m_picture.binWidth),
             percent(m_picture.shares[static_cast<std::size_t>(m_told)]), percent(curve));
}

bool SpeedPlot::tellNext(int direction)
{
    m_told = std::clamp(m_told + direction, 0, static_cast<int>(m_picture.shares.size()) - 1);
    emit toldChanged();
    return true;
}

void SpeedPlot::drawUnder(QPainter &painter) const
{
    const QRectF area = plotArea();
    const QFontMetricsF metrics(painter.font());
    double textFrom = area.left();
    for (std::size_t bin = 0; bin < m_picture.shares.size(); ++bin) {
        const double share = m_picture.shares[bin];
        const double left = std::round(xOf(m_picture.binWidth * static_cast<double>(bin)));
        const double right = std::round(xOf(m_picture.binWidth * static_cast<double>(bin + 1)));
        const double top = std::max(area.top(), yOf(share));
        painter.fillRect(QRectF(left + 1.0, top, right - left - 1.0, area.bottom() - top),
                         barColour());
        if (share <= upSpan().high)
            continue;
        const QString text = Plot::tr("%1 %", "share").arg(std::lround(100.0 * share));
        const double advance = metrics.horizontalAdvance(text);
        const double x = 0.5 * (left + right - advance);
        if (x < textFrom) // there is no room beside the one before
            continue;
        painter.setPen(theme().mutedText);
        painter.drawText(QPointF(std::round(x), area.top() - 4.0), text);
        textFrom = x + advance + 4.0;
    }
}

/// At the top right, where the curve is low.
void SpeedPlot::drawOver(QPainter &painter) const
{
    painter.setRenderHint(QPainter::Antialiasing, false);
    const QRectF area = plotArea();
    const QFontMetricsF metrics(painter.font());
    QStringList lines{m_picture.barsText, m_picture.curveText};
    if (m_picture.shareBeyond > 0.0)
        lines << tr("%1 % faster").arg(shortNumber(100.0 * m_picture.shareBeyond));
    double widest = 0.0;
    for (const QString &line : lines)
        widest = std::max(widest, metrics.horizontalAdvance(line));
    const double left = std::round(area.right() - widest);
    const double height = std::ceil(metrics.height());
    QColor behind = theme().panel;
    behind.setAlphaF(0.8F);
    painter.fillRect(QRectF(left - legendSwatch - 8.0, area.top(), widest + legendSwatch + 8.0,
                            height * static_cast<double>(lines.size())),
                     behind);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const double top = area.top() + static_cast<double>(i) * height;
        const double middle = std::round(top + 0.5 * height);
        const QRectF mark(left - legendSwatch - 6.0, middle - 0.5 * legendSwatch, legendSwatch,
                          legendSwatch);
        if (i == 0)
            painter.fillRect(mark, barColour());
        else if (i == 1)
            painter.fillRect(QRectF(mark.left(), middle - 1.0, legendSwatch, 2.0), theme().text);
        painter.setPen(theme().mutedText);
        painter.setLayoutDirection(directionOf(lines[i]));
        painter.drawText(QPointF(left, top + std::round(metrics.ascent())), lines[i]);
    }
}

} // namespace cradle
