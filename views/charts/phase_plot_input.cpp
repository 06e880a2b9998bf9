// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and keys of PhasePlot: as those of ChartPlot.
#include "views/charts/phase_plot.h"
#include "views/charts/plot_focus.h"

#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace cradle {

namespace {

constexpr double leastBox = 6.0; ///< px: less is a slip of the hand
constexpr double wheelZoom =
    1.0 / 600; ///< e-folds per eighth of a degree: a notch is about a fifth

} // namespace

void PhasePlot::mousePressEvent(QMouseEvent *event)
{
    if (!showsRun() || m_drag != Drag::None)
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
        emit picked(m_dragStart);
    }
}

void PhasePlot::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF before = std::exchange(m_dragEnd, event->position());
    if (!showsRun())
        return;
    if (m_drag == Drag::Pick)
        emit picked(m_dragEnd);
    else if (m_drag == Drag::Pan)
        emit panned(valuesAt(before) - valuesAt(m_dragEnd));
    else if (m_drag == Drag::Box)
        update();
}

QRectF PhasePlot::box() const
{
    return QRectF(m_dragStart, m_dragEnd).normalized().intersected(m_area);
}

void PhasePlot::mouseReleaseEvent(QMouseEvent *event)
{
    const Qt::MouseButton button = m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton;
    if (m_drag == Drag::None || event->button() != button)
        return;
    const Drag ended = std::exchange(m_drag, Drag::None);
    setCursor(Qt::CrossCursor);
    update();
    const QRectF chosen = box();
    if (ended != Drag::Box || chosen.width() < leastBox || chosen.height() < leastBox)
        return;
    const QPointF low = valuesAt(chosen.bottomLeft());
    const QPointF high = valuesAt(chosen.topRight());
    emit boxChosen({low.x(), high.x()}, {low.y(), high.y()});
}

void PhasePlot::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && showsRun())
        emit resetRequested();
}

void PhasePlot::wheelEvent(QWheelEvent *event)
{
    event->accept();
    if (!showsRun() || event->angleDelta().y() == 0)
        return;
    const double factor = std::exp(-wheelZoom * event->angleDelta().y());
    const bool upOnly = event->modifiers().testFlag(Qt::ControlModifier);
    emit zoomed(valuesAt(event->position()), upOnly ? 1.0 : factor, factor);
}

void PhasePlot::keyPressEvent(QKeyEvent *event)
{
    if (asksToHear(*event) && showsRun())
        emit playRequested();
    else
        event->ignore(); // the window's keys go from moment to moment
}

} // namespace cradle
