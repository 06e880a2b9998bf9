// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/speed_plot.h"

#include "views/charts/nice_scale.h"
#include "views/charts/number_text.h"
#include "views/charts/plot_focus.h"
#include "views/charts/speed_distribution.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int textPixels = 11;
constexpr double leftRoom = 46.0;   ///< px for the shares
constexpr double rightRoom = 14.0;  ///< px
constexpr double topRoom = 16.0;    ///< px: for the text over a bar that is cut off
constexpr double axisRoom = 22.0;   ///< px for the speeds below the plot
constexpr double tickHeight = 36.0; ///< px from one share to the next, at least
constexpr double tickWidth = 44.0;  ///< px from one speed to the next, at least
constexpr double swatch = 10.0;     ///< px
/// The axis of shares ends at this many times the top of the curve.
constexpr double headroom = 2.0;

/// The middle of the pixel, where a line of one pixel is sharp.
double sharp(double x)
{
    return std::floor(x) + 0.5;
}

} // namespace

SpeedPlot::SpeedPlot(QWidget *parent)
    : QWidget(parent)
{
    setLayoutDirection(Qt::LeftToRight);
    setFocusPolicy(Qt::TabFocus);
}

void SpeedPlot::showPicture(const SpeedPicture &picture)
{
    if (picture == m_picture)
        return;
    m_picture = picture;
    m_emptyText.clear();
    update();
}

void SpeedPlot::showEmpty(const QString &text)
{
    m_picture = {};
    m_emptyText = text;
    update();
}

QString SpeedPlot::toldBar() const
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

void SpeedPlot::keyPressEvent(QKeyEvent *event)
{
    const int way = wayOf(*event);
    if (isEmpty() || (way == 0 && !asksToHear(*event))) {
        event->ignore(); // the window's keys go from moment to moment
    } else if (way == 0) {
        emit barsPlayed(m_picture.shares);
    } else {
        m_told = std::clamp(m_told + way, 0, static_cast<int>(m_picture.shares.size()) - 1);
        update();
        emit barTold();
    }
}

double SpeedPlot::lastSpeed() const
{
    return m_picture.binWidth * static_cast<double>(m_picture.shares.size());
}

double SpeedPlot::xOf(double speed) const
{
    return m_area.left() + speed / lastSpeed() * m_area.width();
}

double SpeedPlot::yOf(double share) const
{
    return m_area.bottom() - share / m_highest * m_area.height();
}

void SpeedPlot::layOut()
{
    m_area = QRectF(leftRoom * textScale(), topRoom * textScale(),
                    width() - leftRoom * textScale() - rightRoom,
                    height() - topRoom * textScale() - axisRoom * textScale());
    const double top = maxwellDensity(m_picture.spread, m_picture.spread) * m_picture.binWidth;
    m_highest = headroom * top;
    m_tickStep = niceStep(m_highest / std::max(1.0, m_area.height() / (tickHeight * textScale())));
}

void SpeedPlot::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setLayoutDirection(layoutDirection());
    painter.fillRect(rect(), theme().panel);
    if (isEmpty()) {
        painter.setPen(theme().mutedText);
        painter.setLayoutDirection(directionOf(m_emptyText));
        painter.drawText(QRectF(rect()).adjusted(16.0, 0.0, -16.0, -16.0),
                         Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        if (hasFocus())
            drawPlotFocus(painter, rect(), {}, {});
        return;
    }
    QFont small = font();
    small.setPixelSize(scaledByText(textPixels));
    painter.setFont(small);
    layOut();
    drawAxes(painter);
    drawBars(painter);
    drawCurve(painter);
    drawLegend(painter);
    if (hasFocus())
        drawPlotFocus(painter, rect(), m_area.topLeft(), toldBar());
}

void SpeedPlot::drawAxes(QPainter &painter) const
{
    const Theme &colours = theme();
    const QFontMetricsF metrics(painter.font());
    for (const double share : AxisScale{0.0, m_highest, m_tickStep}.ticks()) {
        const double y = sharp(yOf(share));
        painter.setPen(share == 0.0 ? colours.border : colours.grid);
        painter.drawLine(QPointF(m_area.left(), y), QPointF(m_area.right(), y));
        const QString text = tr("%1 %", "share").arg(tickNumber(100.0 * share, 100.0 * m_tickStep));
        const double x = m_area.left() - 8.0 - metrics.horizontalAdvance(text);
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(x, y + std::round(0.5 * metrics.capHeight())), text);
    }
    const double axis = sharp(m_area.bottom());
    const double baseline = axis + 6.0 + std::ceil(metrics.ascent());
    const double step = niceStep(lastSpeed() * tickWidth * textScale()
                                 / std::max(tickWidth * textScale(), m_area.width()));
    const std::vector<double> speeds = AxisScale{0.0, lastSpeed(), step}.ticks();
    for (const double speed : speeds) {
        QString text = tickNumber(speed, step);
        if (speed == speeds.back())
            text += QChar::Nbsp + tr("m/s");
        const double advance = metrics.horizontalAdvance(text);
        const double x = std::min(xOf(speed) - 0.5 * advance, width() - advance - 2.0);
        painter.setPen(colours.border);
        painter.drawLine(QPointF(sharp(xOf(speed)), axis), QPointF(sharp(xOf(speed)), axis + 3.0));
        painter.setPen(colours.mutedText);
        painter.drawText(QPointF(std::round(x), baseline), text);
    }
}

void SpeedPlot::drawBars(QPainter &painter) const
{
    QColor fill = theme().kinetic;
    fill.setAlphaF(0.45F);
    const QFontMetricsF metrics(painter.font());
    double textFrom = m_area.left();
    for (std::size_t bin = 0; bin < m_picture.shares.size(); ++bin) {
        const double share = m_picture.shares[bin];
        const double left = std::round(xOf(m_picture.binWidth * static_cast<double>(bin)));
        const double right = std::round(xOf(m_picture.binWidth * static_cast<double>(bin + 1)));
        const double top = std::max(m_area.top(), yOf(share));
        painter.fillRect(QRectF(left + 1.0, top, right - left - 1.0, m_area.bottom() - top), fill);
        if (share <= m_highest)
            continue;
        const QString text = tr("%1 %", "share").arg(std::lround(100.0 * share));
        const double advance = metrics.horizontalAdvance(text);
        const double x = 0.5 * (left + right - advance);
        if (x < textFrom) // there is no room beside the one before
            continue;
        painter.setPen(theme().mutedText);
        painter.drawText(QPointF(std::round(x), m_area.top() - 4.0), text);
        textFrom = x + advance + 4.0;
    }
}

void SpeedPlot::drawCurve(QPainter &painter) const
{
    QPainterPath path(QPointF(xOf(0.0), yOf(0.0)));
    const int columns = std::max(1, static_cast<int>(m_area.width()));
    for (int column = 2; column <= columns; column += 2) {
        const double speed = lastSpeed() * column / columns;
        const double share = maxwellDensity(speed, m_picture.spread) * m_picture.binWidth;
        path.lineTo(xOf(speed), yOf(share));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme().text, 2.0));
    painter.drawPath(path);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

/// At the top right, where the curve is low.
void SpeedPlot::drawLegend(QPainter &painter) const
{
    const QFontMetricsF metrics(painter.font());
    QStringList lines{m_picture.barsText, m_picture.curveText};
    if (m_picture.shareBeyond > 0.0)
        lines << tr("%1 % faster").arg(shortNumber(100.0 * m_picture.shareBeyond));
    double widest = 0.0;
    for (const QString &line : lines)
        widest = std::max(widest, metrics.horizontalAdvance(line));
    const double left = std::round(m_area.right() - widest);
    const double height = std::ceil(metrics.height());
    QColor behind = theme().panel;
    behind.setAlphaF(0.8F);
    painter.fillRect(QRectF(left - swatch - 8.0, m_area.top(), widest + swatch + 8.0,
                            height * static_cast<double>(lines.size())),
                     behind);
    QColor fill = theme().kinetic;
    fill.setAlphaF(0.45F);
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const double top = m_area.top() + static_cast<double>(i) * height;
        const double middle = std::round(top + 0.5 * height);
        const QRectF mark(left - swatch - 6.0, middle - 0.5 * swatch, swatch, swatch);
        if (i == 0)
            painter.fillRect(mark, fill);
        else if (i == 1)
            painter.fillRect(QRectF(mark.left(), middle - 1.0, swatch, 2.0), theme().text);
        painter.setPen(theme().mutedText);
        painter.setLayoutDirection(directionOf(lines[i]));
        painter.drawText(QPointF(left, top + std::round(metrics.ascent())), lines[i]);
    }
}

} // namespace cradle
