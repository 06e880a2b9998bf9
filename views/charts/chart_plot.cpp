// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/charts/chart_plot.h"

#include "views/charts/note_place.h"
#include "views/hit_columns.h"
#include "views/number_text.h"
#include "views/subscript_text.h"

#include <QFontMetricsF>

#include <algorithm>
#include <cmath>

namespace cradle {

namespace {

constexpr int leastTicks = 4;    ///< however low the plot is
constexpr double margin = 0.08;  ///< of the height, above and below the range
constexpr double hitReach = 4.0; ///< px from a hit that a click means it

constexpr double wholeNoteShare =
    0.3; ///< of the plot that a note may cover without being cut short

constexpr std::size_t playedValues = 400; ///< of a curve that is heard

} // namespace

ChartPlot::ChartPlot(QWidget *parent)
    : Plot({}, parent)
{
    setMinimumSize(160, 96);
}

void ChartPlot::showMoment(const ChartMoment &moment, const std::vector<ChartCurve> &curves,
                           const Recording &recording)
{
    m_moment = moment;
    if (curves != m_curves) {
        m_curves = curves;
        m_layout.forget();
        m_windows.assign(curves.size(), {});
    }
    const int ticks = std::max(leastTicks, rows());
    AxisScale values = moment.range.scale(ticks, margin);
    if (const auto &zoom = moment.zoom)
        values = {zoom->low, zoom->high, niceStep((zoom->high - zoom->low) / ticks)};
    layOut({.scale = {moment.from, moment.to, 1.0}, .unit = tr("s", "seconds")}, {.scale = values});
    showLines(lines());
    placeNote();
    placeLabels();
    markHits(recording);
}

void ChartPlot::showEmpty(const QString &text)
{
    m_curves.clear();
    m_labelTexts.clear();
    m_labelRects.clear();
    Plot::showEmpty(text);
}

/// In two points a column of pixels.
std::vector<PlotLine> ChartPlot::lines()
{
    std::vector<PlotLine> all;
    const int columns = std::max(1, static_cast<int>(plotArea().width()));
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        const ChartCurve &curve = m_curves[i];
        curve.samples->decimate(m_windows[i], m_moment.from + curve.shift,
                                m_moment.to + curve.shift, columns);
        QList<QPointF> points = m_windows[i].points();
        for (QPointF &point : points)
            point += QPointF(-curve.shift, curve.lift);
        all.push_back({.points = points,
                       .pen = {curve.colour, curve.width, curve.dash, Qt::FlatCap, Qt::MiterJoin},
                       .isFilled = curve.isFilled});
    }
    return all;
}

/// Whole where that hides no more than the short one, which is small enough to lie between curves.
void ChartPlot::placeNote()
{
    m_noteRect = {};
    if (!m_moment.note)
        return;
    const auto placed = [this](NoteForm form) {
        return quietestPlace(plotArea(), profiles(), sizeOf(*m_moment.note, form, smallFont()),
                             xOf(m_moment.shown));
    };
    const NotePlace whole = placed(NoteForm::Whole);
    const NotePlace cut = placed(NoteForm::Short);
    const bool isRoomy = whole.rect.width() * whole.rect.height()
                         < wholeNoteShare * plotArea().width() * plotArea().height();
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
    const std::vector<PlacedLabel> placed =
        m_layout.place(plotArea(), profiles(), labels, m_noteRect);
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
    const int width = static_cast<int>(plotArea().width());
    for (const HitColumn &column : hitColumns(hits, m_moment.from, m_moment.to, width))
        m_hitMarks.push_back({xOf(hits[column.first].time), hits[column.first].step});
    if (const auto nearest = nearestHit(hits, m_moment.shown)) {
        const double time = hits[*nearest].time;
        if (time >= m_moment.from && time <= m_moment.to)
            m_nearestHit = xOf(time);
    }
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

QString ChartPlot::told() const
{
    if (!showsRun() || m_told < 0 || m_told >= static_cast<int>(m_curves.size()))
        return {};
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    const double value = curve.samples->valueAt(m_moment.shown + curve.shift);
    return tr("%1: %2", "curve, value").arg(curve.label, shortNumber(value, m_moment.scale));
}

/// Those without a name are no curves to speak of.
bool ChartPlot::tellNext(int direction)
{
    const int count = static_cast<int>(m_curves.size());
    int next = m_told < 0 ? (direction > 0 ? -1 : count) : m_told;
    do {
        next += direction;
    } while (next >= 0 && next < count && m_curves[static_cast<std::size_t>(next)].label.isEmpty());
    if (next < 0 || next >= count)
        return true;
    m_told = next;
    emit toldChanged();
    return true;
}

/// Of what the run has recorded: beyond that there is nothing to hear.
void ChartPlot::playTold()
{
    if (told().isEmpty() || m_curves[static_cast<std::size_t>(m_told)].samples->isEmpty())
        return;
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    std::vector<double> values(playedValues);
    const double from = std::max(m_moment.from, curve.samples->firstTime() - curve.shift);
    const double length = std::min(m_moment.to, curve.samples->lastTime() - curve.shift) - from;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(values.size() - 1);
        values[i] = curve.samples->valueAt(from + share * length + curve.shift);
    }
    emit played(values);
}

void ChartPlot::pick(QPointF pixel, bool isPress)
{
    const auto distance = [x = pixel.x()](const HitMark &mark) { return std::abs(mark.x - x); };
    if (isPress) {
        const auto nearest = std::min_element(
            m_hitMarks.begin(), m_hitMarks.end(),
            [&](const HitMark &a, const HitMark &b) { return distance(a) < distance(b); });
        m_isOnHit = nearest != m_hitMarks.end() && distance(*nearest) <= hitReach;
        if (m_isOnHit)
            emit hitPicked(nearest->step);
    } else if (std::abs(pixel.x() - dragStart().x()) > hitReach) {
        m_isOnHit = false; // else it is the hand that clicks on a hit and is not quite still
    }
    if (!m_isOnHit)
        emit timePicked(std::clamp(valuesAt(pixel).x(), m_moment.from, m_moment.to));
}

void ChartPlot::focusInEvent(QFocusEvent *event)
{
    Plot::focusInEvent(event);
    if (told().isEmpty()) {
        m_told = -1;
        tellNext(1);
    }
}

} // namespace cradle
