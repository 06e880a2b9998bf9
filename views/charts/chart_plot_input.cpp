// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer of ChartPlot.
#include "views/charts/chart_plot.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

constexpr double hitReach = 4.0; ///< px from a hit that a click means it
constexpr double leastBox = 6.0; ///< px: less is a slip of the hand
constexpr double wheelZoom =
    1.0 / 600; ///< e-folds per eighth of a degree: a notch is about a fifth

} // namespace

void ChartPlot::pick(double x)
{
    emit timePicked(timeAt(x));
}

void ChartPlot::mousePressEvent(QMouseEvent *event)
{
    if (!m_showsRun || m_drag != Drag::None)
        return;
    m_dragStart = event->position();
    m_dragEnd = m_dragStart;
    if (event->button() == Qt::MiddleButton) {
        m_drag = Drag::Pan;
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton
               && event->modifiers().testFlag(Qt::ShiftModifier)) {
        m_drag = Drag::Box;
    } else if (event->button() == Qt::LeftButton) {
        m_drag = Drag::Pick;
        emit pickingBegan();
        const auto distance = [x = m_dragStart.x()](const HitMark &mark) {
            return std::abs(mark.x - x);
        };
        const auto nearest = std::min_element(
            m_hitMarks.begin(), m_hitMarks.end(),
            [&](const HitMark &a, const HitMark &b) { return distance(a) < distance(b); });
        m_isOnHit = nearest != m_hitMarks.end() && distance(*nearest) <= hitReach;
        if (m_isOnHit)
            emit hitPicked(nearest->step);
        else
            pick(m_dragStart.x());
    }
}

void ChartPlot::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF before = std::exchange(m_dragEnd, event->position());
    if (!m_showsRun)
        return;
    switch (m_drag) {
    case Drag::None:
        break;
    case Drag::Pick:
        // The hand that clicks on a hit is not quite still.
        m_isOnHit = m_isOnHit && std::abs(m_dragEnd.x() - m_dragStart.x()) <= hitReach;
        if (!m_isOnHit)
            pick(m_dragEnd.x());
        break;
    case Drag::Box:
        viewport()->update();
        break;
    case Drag::Pan:
        emit panned((before.x() - m_dragEnd.x()) / m_area.width() * (m_moment.to - m_moment.from),
                    (m_dragEnd.y() - before.y()) / m_area.height() * (m_scale.high - m_scale.low));
        break;
    }
}

void ChartPlot::mouseReleaseEvent(QMouseEvent *event)
{
    event->accept();
    const Qt::MouseButton button = m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton;
    if (m_drag == Drag::None || event->button() != button)
        return;
    const Drag ended = std::exchange(m_drag, Drag::None);
    setCursor(Qt::CrossCursor);
    if (ended == Drag::Box)
        chooseBox();
    emit pickingEnded();
}

QRectF ChartPlot::box() const
{
    return QRectF(m_dragStart, m_dragEnd).normalized().intersected(m_area);
}

/// A box that is low is a stretch of time, of whatever values.
void ChartPlot::chooseBox()
{
    const QRectF chosen = box();
    viewport()->update();
    if (chosen.width() < leastBox)
        return;
    std::optional<ValueSpan> values;
    if (chosen.height() >= leastBox)
        values = ValueSpan{valueAt(chosen.bottom()), valueAt(chosen.top())};
    emit boxChosen({timeAt(chosen.left()), timeAt(chosen.right())}, values);
}

void ChartPlot::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && m_showsRun)
        emit resetRequested();
}

void ChartPlot::wheelEvent(QWheelEvent *event)
{
    event->accept();
    if (!m_showsRun)
        return;
    const double factor = std::exp(-wheelZoom * event->angleDelta().y());
    if (event->modifiers().testFlag(Qt::ControlModifier))
        emit valuesZoomed(factor, valueAt(event->position().y()));
    else if (event->angleDelta().y() != 0)
        emit timeZoomed(factor, timeAt(event->position().x()));
}

/// It is the pane's, which knows more than its curves.
void ChartPlot::contextMenuEvent(QContextMenuEvent *event)
{
    event->ignore();
}

} // namespace cradle
