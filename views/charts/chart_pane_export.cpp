// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What leaves a ChartPane: its picture and its numbers.
#include "views/charts/chart_pane.h"

#include "model/world/shortest_number.h"
#include "views/charts/pin_legend.h"
#include "views/theme.h"

#include <QLabel>
#include <QPainter>

namespace cradle {

namespace {

constexpr double headingRoom = 28.0;  ///< px over the plot
constexpr double headingInset = 14.0; ///< px
constexpr double rounding = 1e-9;     ///< s, of sums of times; far less than a step

} // namespace

ChartPicture ChartPane::picture()
{
    redraw(); // which may be due
    const int lines = m_legend->lines().empty() ? 0 : m_legend->sizeHint().height();
    const QSize size(m_plot->width(), m_plot->height() + lines + static_cast<int>(headingRoom));
    return {size, title(), [this, size](QPainter &painter) { paintPicture(painter, size); }};
}

void ChartPane::paintPicture(QPainter &painter, QSizeF size) const
{
    painter.fillRect(QRectF({}, size), theme().panel);
    painter.setFont(m_heading->font());
    painter.setPen(theme().mutedText);
    painter.drawText(QRectF(headingInset, 0.0, size.width() - 2.0 * headingInset, headingRoom),
                     Qt::AlignLeft | Qt::AlignVCenter, title());
    m_legend->paint(painter, QRectF(0.0, headingRoom, size.width(), size.height()));
    painter.translate(0.0, size.height() - m_plot->height());
    m_plot->paint(painter);
}

QByteArray ChartPane::table()
{
    redraw(); // which may be due: the curves are to be those of now
    const Recording &recording = m_simulation.recording();
    const auto unitText = [](const QString &unit) {
        return unit.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(unit);
    };
    QStringList cells{tr("time") + unitText(tr("s", "seconds"))};
    for (const ChartCurve &curve : m_plot->curves())
        cells << csvCell((curve.column.isEmpty() ? curve.label : curve.column) + unitText(m_unit));
    QByteArray rows = cells.join(QLatin1Char(',')).toUtf8() + '\n';
    const TimeWindow::Span span = m_plot->timeSpan();
    for (qint64 i = recording.first(); i <= recording.last(); ++i) {
        const double time = recording.time(i);
        if (time < span.from || time > span.to)
            continue;
        cells = {shortestNumber(time)};
        for (const ChartCurve &curve : m_plot->curves()) {
            const MinMaxPyramid &samples = *curve.samples;
            const double then = curve.shift > 0.0 ? time + curve.shift + rounding : time;
            const bool known = !samples.isEmpty() && then >= samples.firstTime()
                               && then <= samples.lastTime() + 2.0 * rounding;
            cells << (known ? shortestNumber(samples.valueAt(then) + curve.lift) : QString());
        }
        rows += cells.join(QLatin1Char(',')).toUtf8() + '\n';
    }
    return rows;
}

} // namespace cradle
