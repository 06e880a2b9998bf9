// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Geometry and lines of Plot.
#include "views/charts/plot.h"

#include "views/charts/needed_points.h"
#include "views/number_text.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int plotTextPixels = 11;
constexpr double straight = 0.05; ///< px that a line may be off
constexpr double leastStep = 0.4; ///< px: of a path, what is nearer to the last point is left out
constexpr double leastGutter = 42.0; ///< px for the values left of the lines
constexpr double rightRoom = 14.0;   ///< px
constexpr double axisRoom = 22.0;    ///< px for the numbers below the lines
constexpr double numberGap = 32.0;   ///< px between two numbers of the horizontal axis, at least
constexpr double mostNumbers = 10.0; ///< of the horizontal axis

/// A line that is longer than so many widths of the plot fills its columns from top to bottom.
constexpr double denseLength = 8.0;
constexpr qsizetype densePath = 4000; ///< points of a line that may go anywhere

double lengthOf(const QList<QPointF> &pixels)
{
    double sum = 0.0;
    for (qsizetype i = 1; i < pixels.size(); ++i)
        sum += std::abs(pixels[i].y() - pixels[i - 1].y());
    return sum;
}

/// \p pixels without those that nobody would see.
QList<QPointF> thinned(const QList<QPointF> &pixels, bool isOverTime)
{
    QList<QPointF> kept;
    if (isOverTime) {
        for (const qsizetype index : neededPoints(pixels, straight))
            kept.append(pixels[index]);
        return kept;
    }
    for (const QPointF &pixel : pixels) {
        if (kept.isEmpty() || (pixel - kept.last()).manhattanLength() >= leastStep)
            kept.append(pixel);
    }
    return kept;
}

/// Makes \p axis \p factor times as long, about its middle.
void widen(AxisScale &axis, double factor)
{
    const double middle = 0.5 * (axis.low + axis.high);
    axis.low = middle + factor * (axis.low - middle);
    axis.high = middle + factor * (axis.high - middle);
}

} // namespace

Plot::Plot(const Form &form, QWidget *parent)
    : QChartView(parent)
    , m_form(form)
    , m_pixelsRight(new QValueAxis(this))
    , m_pixelsDown(new QValueAxis(this))
{
    setLayoutDirection(Qt::LeftToRight); // as physics is written, in every language
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setInteractive(false);
    setMinimumSize(160, 80);
    setFocusPolicy(Qt::TabFocus);
    if (form.isPicked)
        setCursor(Qt::CrossCursor);
    chart()->setMargins({});
    chart()->setBackgroundVisible(false);
    chart()->setDropShadowEnabled(false);
    chart()->legend()->hide();
    chart()->addAxis(m_pixelsRight, Qt::AlignBottom);
    chart()->addAxis(m_pixelsDown, Qt::AlignLeft);
    m_pixelsDown->setReverse();
    for (QValueAxis *axis : {m_pixelsRight, m_pixelsDown}) {
        axis->setLabelsVisible(false);
        axis->setGridLineVisible(false);
        axis->setLineVisible(false);
    }
}

void Plot::showEmpty(const QString &text)
{
    m_showsRun = false;
    m_emptyText = text;
    m_lines.clear();
    fillSeries();
    viewport()->update();
}

int Plot::rows() const
{
    const double height = viewport()->height() - (m_form.topRoom + axisRoom) * textScale();
    return static_cast<int>(height / (m_form.tickHeight * textScale()));
}

void Plot::layOut(const PlotAxis &across, const PlotAxis &up, bool isEqual)
{
    m_across = across;
    m_up = up;
    const QSizeF size = viewport()->size();
    const QFontMetricsF metrics(smallFont());
    double gutter = leastGutter * textScale();
    for (const double tick : m_up.scale.ticks())
        gutter =
            std::max(gutter, std::ceil(metrics.horizontalAdvance(numberAt(m_up, tick))) + 18.0);
    const double top = m_form.topRoom * textScale();
    const QRectF area(gutter, top, std::max(1.0, size.width() - gutter - rightRoom),
                      std::max(1.0, size.height() - top - axisRoom * textScale()));
    if (area != m_area) {
        m_area = area;
        chart()->setPlotArea(area);
        m_pixelsRight->setRange(0.0, area.width());
        m_pixelsDown->setRange(0.0, area.height());
    }
    AxisScale &scale = m_across.scale;
    if (isEqual) {
        const double right = area.width() / (scale.high - scale.low);
        const double high = area.height() / (m_up.scale.high - m_up.scale.low);
        widen(right > high ? scale : m_up.scale, std::max(right / high, high / right));
    }
    scale.step = stepOf(scale);
}

/// As short as its numbers have room.
double Plot::stepOf(const AxisScale &across) const
{
    const QFontMetricsF metrics(smallFont());
    const double length = across.high - across.low;
    const double gap = numberGap * textScale();
    double step = niceStep(length / mostNumbers);
    while (step < length) {
        const double widest = std::max(metrics.horizontalAdvance(tickNumber(across.low, step)),
                                       metrics.horizontalAdvance(tickNumber(across.high, step)));
        if (widest + gap <= step / length * m_area.width())
            break;
        step = niceStep(1.5 * step);
    }
    return step;
}

void Plot::showLines(const std::vector<PlotLine> &lines)
{
    m_showsRun = true;
    m_lines.clear();
    m_profiles.clear();
    QList<QPointF> floor{{m_area.left(), yOf(0.0)}, {m_area.right(), yOf(0.0)}};
    for (const PlotLine &line : lines) {
        QList<QPointF> pixels;
        pixels.reserve(line.points.size());
        for (const QPointF &point : line.points)
            pixels.append(placeOf(point));
        DrawnLine drawn{thinned(pixels, line.isOverTime), line.pen, {}, line.isOverTime};
        drawn.isDense = line.isOverTime ? lengthOf(drawn.pixels) > denseLength * m_area.width()
                                        : drawn.pixels.size() >= densePath;
        if (line.isFilled && !drawn.pixels.isEmpty()) {
            drawn.area = QPolygonF(drawn.pixels);
            std::copy(floor.rbegin(), floor.rend(), std::back_inserter(drawn.area));
            floor = drawn.pixels;
        }
        m_profiles.emplace_back(line.isOverTime ? drawn.pixels : QList<QPointF>(), m_area);
        m_lines.push_back(drawn);
    }
    fillSeries();
    viewport()->update();
}

/// In pixels, so that the axes of QtCharts rest whatever is zoomed.
void Plot::fillSeries()
{
    while (m_series.size() < m_lines.size()) {
        auto *series = new QLineSeries;
        chart()->addSeries(series);
        series->attachAxis(m_pixelsRight);
        series->attachAxis(m_pixelsDown);
        m_series.push_back(series);
    }
    for (std::size_t i = 0; i < m_series.size(); ++i) {
        QLineSeries &series = *m_series[i];
        if (i < m_lines.size() && !m_lines[i].isDense) {
            QList<QPointF> points = m_lines[i].pixels;
            for (QPointF &point : points)
                point -= m_area.topLeft();
            series.setPen(m_lines[i].pen);
            series.replace(points);
        } else if (series.count() > 0) {
            series.clear();
        }
    }
}

double Plot::xOf(double value) const
{
    const AxisScale &scale = m_across.scale;
    return m_area.left() + (value - scale.low) / (scale.high - scale.low) * m_area.width();
}

double Plot::yOf(double value) const
{
    const AxisScale &scale = m_up.scale;
    return m_area.bottom() - (value - scale.low) / (scale.high - scale.low) * m_area.height();
}

QPointF Plot::placeOf(QPointF values) const
{
    return {xOf(values.x()), yOf(values.y())};
}

QPointF Plot::valuesAt(QPointF pixel) const
{
    if (m_area.isEmpty())
        return {};
    const AxisScale &across = m_across.scale;
    const AxisScale &up = m_up.scale;
    const double right = (pixel.x() - m_area.left()) / m_area.width();
    const double high = (m_area.bottom() - pixel.y()) / m_area.height();
    return {across.low + right * (across.high - across.low), up.low + high * (up.high - up.low)};
}

ValueSpan Plot::acrossSpan() const
{
    return {m_across.scale.low, m_across.scale.high};
}

ValueSpan Plot::upSpan() const
{
    return {m_up.scale.low, m_up.scale.high};
}

QFont Plot::smallFont() const
{
    QFont small = font();
    small.setPixelSize(scaledByText(plotTextPixels));
    return small;
}

double Plot::sharp(double x)
{
    return std::floor(x) + 0.5;
}

void Plot::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    // The samples may be gone by now: whoever has them draws anew.
    if (m_showsRun)
        emit resized();
}

} // namespace cradle
