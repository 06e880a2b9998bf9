// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard of ChartPlot: from curve to curve; the window's keys go from moment to moment.
#include "views/charts/chart_plot.h"

#include "views/charts/number_text.h"
#include "views/text_direction.h"
#include "views/theme.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace cradle {

namespace {

constexpr double chipRoom = 4.0;          ///< px around the text
constexpr std::size_t playedValues = 400; ///< of a curve that is heard

} // namespace

QString ChartPlot::toldCurve() const
{
    if (!m_showsRun || m_told < 0 || m_told >= static_cast<int>(m_curves.size()))
        return {};
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    const double value = curve.samples->valueAt(m_moment.shown + curve.shift);
    return tr("%1: %2", "curve, value").arg(curve.label, shortNumber(value, m_moment.scale));
}

/// Those without a name are no curves to speak of.
void ChartPlot::tellNext(int direction)
{
    const int count = static_cast<int>(m_curves.size());
    int next = m_told < 0 ? (direction > 0 ? -1 : count) : m_told;
    do {
        next += direction;
    } while (next >= 0 && next < count && m_curves[static_cast<std::size_t>(next)].label.isEmpty());
    if (next < 0 || next >= count)
        return;
    m_told = next;
    viewport()->update();
    emit curveTold();
}

/// Of what the run has recorded: beyond that there is nothing to hear.
void ChartPlot::playTold()
{
    if (toldCurve().isEmpty() || m_curves[static_cast<std::size_t>(m_told)].samples->isEmpty())
        return;
    const ChartCurve &curve = m_curves[static_cast<std::size_t>(m_told)];
    std::vector<double> values(playedValues);
    const double from = std::max(m_moment.from, curve.samples->firstTime() - curve.shift);
    const double length = std::min(m_moment.to, curve.samples->lastTime() - curve.shift) - from;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(values.size() - 1);
        values[i] = curve.samples->valueAt(from + share * length + curve.shift);
    }
    emit curvePlayed(values);
}

void ChartPlot::keyPressEvent(QKeyEvent *event)
{
    const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (plain && (event->key() == Qt::Key_Down || event->key() == Qt::Key_Up))
        tellNext(event->key() == Qt::Key_Down ? 1 : -1);
    else if (plain && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter))
        playTold();
    else
        event->ignore(); // nothing here is scrolled
}

void ChartPlot::focusInEvent(QFocusEvent *event)
{
    QChartView::focusInEvent(event);
    if (toldCurve().isEmpty()) {
        m_told = -1;
        tellNext(1);
    }
    viewport()->update();
}

void ChartPlot::focusOutEvent(QFocusEvent *event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

/// That the keys act here, and on which curve.
void ChartPlot::drawFocus(QPainter &painter) const
{
    painter.setPen(QPen(theme().accent, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(viewport()->rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    const QString told = toldCurve();
    if (told.isEmpty())
        return;
    painter.setFont(smallFont());
    const QSizeF size = painter.fontMetrics().size(Qt::TextSingleLine, told);
    const QRectF chip(m_area.topLeft() + QPointF(chipRoom, chipRoom),
                      size + QSizeF(2.0 * chipRoom, chipRoom));
    painter.fillRect(chip, theme().panel);
    painter.setPen(theme().text);
    painter.setLayoutDirection(directionOf(told));
    painter.drawText(chip, Qt::AlignCenter, told);
    painter.setPen(QPen(theme().accent, 1.0));
    painter.drawRect(chip);
}

} // namespace cradle
