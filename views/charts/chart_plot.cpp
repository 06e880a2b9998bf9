// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"

#include "views/charts/hit_columns.h"
#include "views/charts/needed_points.h"
#include "views/charts/note_place.h"
#include "views/charts/number_text.h"
#include "views/charts/subscript_text.h"
#include "views/theme.h"

#include <QFontMetricsF>
#include <QLineSeries>
#include <QValueAxis>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int textPixels = 11;
constexpr double straight = 0.05;    ///< px that a line may be off
constexpr double leastGutter = 42.0; ///< px for the values left of the plot
constexpr double rightRoom = 14.0;   ///< px
constexpr double topRoom = 4.0;      ///< px
constexpr double axisRoom = 22.0;    ///< px for the times below the plot
constexpr double tickHeight = 40.0;  ///< px from one value to the next, at least
constexpr int leastTicks = 4;        ///< however low the plot is
constexpr double margin = 0.08;      ///< of the height, above and below the range

constexpr double wholeNoteShare =
    0.3; ///< of the plot that a note may cover without being cut short

/// A curve that is longer than so many widths of the plot fills its columns from top to bottom.
constexpr double denseLength = 8.0;

double lengthOf(const QList<QPointF> &pixels)
{
    double sum = 0.0;
    for (qsizetype i = 1; i < pixels.size(); ++i)
        sum += std::abs(pixels[i].y() - pixels[i - 1].y());
    return sum;
}

QPen penOf(const ChartCurve &curve)
{
    return {curve.colour, curve.width, curve.dash, Qt::FlatCap, Qt::MiterJoin};
}

} // namespace

ChartPlot::ChartPlot(QWidget *parent)
    : QChartView(parent)
    , m_timeAxis(new QValueAxis(this))
    , m_valueAxis(new QValueAxis(this))
{
    setLayoutDirection(Qt::LeftToRight); // as physics is written, in every language
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setInteractive(false);
    setMinimumSize(160, 96);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::CrossCursor);
    chart()->setMargins({});
    chart()->setBackgroundVisible(false);
    chart()->setDropShadowEnabled(false);
    chart()->legend()->hide();
    chart()->addAxis(m_timeAxis, Qt::AlignBottom);
    chart()->addAxis(m_valueAxis, Qt::AlignLeft);
    for (QValueAxis *axis : {m_timeAxis, m_valueAxis}) {
        axis->setLabelsVisible(false);
        axis->setGridLineVisible(false);
        axis->setLineVisible(false);
    }
}

void ChartPlot::showMoment(const ChartMoment &moment, const std::vector<ChartCurve> &curves,
                           const Recording &recording)
{
    m_showsRun = true;
    m_moment = moment;
    setCurves(curves);
    layOut();
    fillSeries();
    placeNote();
    placeLabels();
    markHits(recording);
    viewport()->update();
}

void ChartPlot::showEmpty(const QString &text)
{
    setCurves({});
    m_showsRun = false;
    m_emptyText = text;
    m_labelTexts.clear();
    m_labelRects.clear();
    viewport()->update();
}

void ChartPlot::setCurves(const std::vector<ChartCurve> &curves)
{
    if (curves == m_curves)
        return;
    m_curves = curves;
    m_layout.forget();
    for (QLineSeries *series : m_series) {
        chart()->removeSeries(series);
        delete series;
    }
    m_series.clear();
    m_windows.assign(curves.size(), {});
    for (const ChartCurve &curve : curves) {
        auto *series = new QLineSeries;
        series->setPen(penOf(curve));
        chart()->addSeries(series);
        series->attachAxis(m_timeAxis);
        series->attachAxis(m_valueAxis);
        m_series.push_back(series);
    }
}

void ChartPlot::layOut()
{
    const QSizeF size = viewport()->size();
    const double height = size.height() - topRoom * textScale() - axisRoom * textScale();
    const int ticks = std::max(leastTicks, static_cast<int>(height / (tickHeight * textScale())));
    m_scale = m_moment.range.scale(ticks, margin);
    if (const auto &zoom = m_moment.zoom)
        m_scale = {zoom->low, zoom->high, niceStep((zoom->high - zoom->low) / ticks)};
    const QFontMetricsF metrics(smallFont());
    double gutter = leastGutter * textScale();
    for (const double tick : m_scale.ticks()) {
        const double text = metrics.horizontalAdvance(tickNumber(tick, m_scale.step));
        gutter = std::max(gutter, std::ceil(text) + 18.0);
    }
    const QRectF area(gutter, topRoom * textScale(), size.width() - gutter - rightRoom, height);
    if (area != m_area) {
        m_area = area;
        chart()->setPlotArea(area);
    }
    m_timeAxis->setRange(0.0, m_moment.to - m_moment.from);
    m_valueAxis->setRange(m_scale.low, m_scale.high);
}

void ChartPlot::fillSeries()
{
    m_profiles.clear();
    m_lines.clear();
    m_areas.clear();
    m_dense.clear();
    QList<QPointF> floor{{m_area.left(), yOf(0.0)}, {m_area.right(), yOf(0.0)}};
    const int columns = std::max(1, static_cast<int>(m_area.width()));
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const ChartCurve &curve = m_curves[i];
        curve.samples->decimate(m_windows[i], m_moment.from + curve.shift,
                                m_moment.to + curve.shift, columns);
        // Relative to the left end: the axis of QtCharts rests while the window slides.
        QList<QPointF> points = m_windows[i].points();
        QList<QPointF> pixels;
        pixels.reserve(points.size());
        for (QPointF &point : points) {
            point += QPointF(-curve.shift, curve.lift);
            pixels.emplaceBack(xOf(point.x()), yOf(point.y()));
            point.rx() -= m_moment.from;
        }
        qsizetype kept = 0;
        for (const qsizetype index : neededPoints(pixels, straight)) {
            points[kept] = points[index];
            pixels[kept++] = pixels[index];
        }
        points.resize(kept);
        pixels.resize(kept);
        m_dense.push_back(lengthOf(pixels) > denseLength * m_area.width());
        if (!m_dense.back())
            m_series[i]->replace(points);
        else if (m_series[i]->count() > 0)
            m_series[i]->clear();
        m_profiles.emplace_back(pixels, m_area);
        m_lines.push_back(pixels);
        if (curve.isFilled && !pixels.isEmpty()) {
            QPolygonF area(pixels);
            std::copy(floor.rbegin(), floor.rend(), std::back_inserter(area));
            m_areas.push_back(area);
            floor = pixels;
        }
    }
}

/// Whole where that hides no more than the short one, which is small enough to lie between curves.
void ChartPlot::placeNote()
{
    m_noteRect = {};
    if (!m_moment.note)
        return;
    const auto placed = [this](NoteForm form) {
        return quietestPlace(m_area, m_profiles, sizeOf(*m_moment.note, form, smallFont()),
                             xOf(m_moment.shown));
    };
    const NotePlace whole = placed(NoteForm::Whole);
    const NotePlace cut = placed(NoteForm::Short);
    const bool isRoomy = whole.rect.width() * whole.rect.height()
                         < wholeNoteShare * m_area.width() * m_area.height();
    m_noteForm = isRoomy && whole.hidden <= cut.hidden ? NoteForm::Whole : NoteForm::Short;
    m_noteRect = m_noteForm == NoteForm::Whole ? whole.rect : cut.rect;
}

void ChartPlot::placeLabels()
{
    m_labelTexts.clear();
    m_labelRects.clear();
    std::vector<CurveLabel> labels;
    std::vector<QString> withValues;
    const QFont font = smallFont();
    const double height = std::ceil(QFontMetricsF(font).height());
    const auto sizeOf = [&font, height](const QString &text) {
        return QSizeF(std::ceil(subscriptWidth(font, text)) + 4.0, height);
    };
    for (const ChartCurve &curve : m_curves) {
        CurveLabel label;
        withValues.push_back(curve.label);
        if (curve.isLabelled)
            label.size = sizeOf(curve.label);
        if (curve.isLabelled && curve.showsValue) {
            const double value = curve.samples->valueAt(m_moment.shown + curve.shift);
            withValues.back() =
                withNumber(curve.label, withPower(shortNumber(value, m_moment.scale)));
            label.sizeWithValue = sizeOf(withValues.back());
            label.value = QPointF(xOf(m_moment.shown), yOf(value + curve.lift));
        }
        labels.push_back(label);
    }
    const std::vector<PlacedLabel> placed = m_layout.place(m_area, m_profiles, labels, m_noteRect);
    for (std::size_t i = 0; i < placed.size(); ++i) {
        m_labelRects.push_back(placed[i].rect);
        m_labelTexts.push_back(placed[i].tellsValue ? withValues[i] : m_curves[i].label);
    }
}

void ChartPlot::markHits(const Recording &recording)
{
    const auto &hits = recording.encounters();
    m_contacts = lastingEncounters(recording, [this](double time) { return xOf(time); });
    m_hitMarks.clear();
    m_nearestHit.reset();
    const int width = static_cast<int>(m_area.width());
    for (const HitColumn &column : hitColumns(hits, m_moment.from, m_moment.to, width))
        m_hitMarks.push_back({xOf(hits[column.first].time), hits[column.first].step});
    if (const auto nearest = nearestHit(hits, m_moment.shown)) {
        const double time = hits[*nearest].time;
        if (time >= m_moment.from && time <= m_moment.to)
            m_nearestHit = xOf(time);
    }
}

double ChartPlot::timeAt(double x) const
{
    const double part = m_area.width() > 0.0 ? (x - m_area.left()) / m_area.width() : 0.0;
    return m_moment.from + std::clamp(part, 0.0, 1.0) * (m_moment.to - m_moment.from);
}

double ChartPlot::valueAt(double y) const
{
    const double part = m_area.height() > 0.0 ? (m_area.bottom() - y) / m_area.height() : 0.0;
    return m_scale.low + std::clamp(part, 0.0, 1.0) * (m_scale.high - m_scale.low);
}

std::vector<std::pair<QString, QRectF>> ChartPlot::labels() const
{
    std::vector<std::pair<QString, QRectF>> shown;
    for (std::size_t i = 0; i < m_labelRects.size(); ++i) {
        if (!m_labelRects[i].isEmpty())
            shown.emplace_back(m_labelTexts[i], m_labelRects[i]);
    }
    return shown;
}

double ChartPlot::xOf(double time) const
{
    return m_area.left() + (time - m_moment.from) / (m_moment.to - m_moment.from) * m_area.width();
}

double ChartPlot::yOf(double value) const
{
    return m_area.bottom() - (value - m_scale.low) / (m_scale.high - m_scale.low) * m_area.height();
}

QFont ChartPlot::smallFont() const
{
    QFont small = font();
    small.setPixelSize(scaledByText(textPixels));
    return small;
}

void ChartPlot::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    // The samples may be gone by now: whoever has them draws anew.
    if (m_showsRun)
        emit resized();
}

} // namespace cradle
