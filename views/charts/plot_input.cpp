// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and keys of Plot; the window's keys go from moment to moment.
#include "views/charts/plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cradle {

namespace {

constexpr double leastBox = 6.0; ///< px: less is a slip of the hand
constexpr double wheelZoom =
    1.0 / 600; ///< e-folds per eighth of a degree: a notch is about a fifth

} // namespace

void Plot::pick(QPointF pixel, bool)
{
    emit picked(pixel);
}

void Plot::mousePressEvent(QMouseEvent *event)
{
    if (!m_form.isPicked)
        event->ignore();
    if (!m_form.isPicked || !m_showsRun || m_drag != Drag::None)
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
        pick(m_dragStart, true);
    }
}

void Plot::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF before = std::exchange(m_dragEnd, event->position());
    if (!m_showsRun)
        return;
    if (m_drag == Drag::Pick)
        pick(m_dragEnd, false);
    else if (m_drag == Drag::Box)
        viewport()->update();
    else if (m_drag == Drag::Pan)
        emit panned(valuesAt(before) - valuesAt(m_dragEnd));
}

void Plot::mouseReleaseEvent(QMouseEvent *event)
{
    event->setAccepted(m_form.isPicked);
    const Qt::MouseButton button = m_drag == Drag::Pan ? Qt::MiddleButton : Qt::LeftButton;
    if (m_drag == Drag::None || event->button() != button)
        return;
    const Drag ended = std::exchange(m_drag, Drag::None);
    setCursor(Qt::CrossCursor);
    if (ended == Drag::Box)
        chooseBox();
    emit pickingEnded();
}

QRectF Plot::box() const
{
    return QRectF(m_dragStart, m_dragEnd).normalized().intersected(m_area);
}

void Plot::chooseBox()
{
    const QRectF chosen = box();
    viewport()->update();
    if (chosen.width() < leastBox)
        return;
    const QPointF low = valuesAt(chosen.bottomLeft());
    const QPointF high = valuesAt(chosen.topRight());
    std::optional<ValueSpan> up;
    if (chosen.height() >= leastBox)
        up = ValueSpan{low.y(), high.y()};
    emit boxChosen({low.x(), high.x()}, up);
}

void Plot::mouseDoubleClickEvent(QMouseEvent *event)
{
    event->setAccepted(m_form.isPicked);
    if (m_form.isPicked && event->button() == Qt::LeftButton && m_showsRun)
        emit resetRequested();
}

void Plot::wheelEvent(QWheelEvent *event)
{
    event->setAccepted(m_form.isPicked);
    if (!m_form.isPicked || !m_showsRun || event->angleDelta().y() == 0)
        return;
    const QPointF place(std::clamp(event->position().x(), m_area.left(), m_area.right()),
                        std::clamp(event->position().y(), m_area.top(), m_area.bottom()));
    emit zoomed(valuesAt(place), std::exp(-wheelZoom * event->angleDelta().y()),
                event->modifiers().testFlag(Qt::ControlModifier));
}

/// It is the pane's, which knows more than its lines.
void Plot::contextMenuEvent(QContextMenuEvent *event)
{
    event->ignore();
}

void Plot::keyPressEvent(QKeyEvent *event)
{
    event->ignore(); // nothing here is scrolled
    if (!m_showsRun || (event->modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier)
        return;
    const int key = event->key();
    if (key == Qt::Key_Down || key == Qt::Key_Up) {
        event->setAccepted(tellNext(key == Qt::Key_Down ? 1 : -1));
        viewport()->update();
    } else if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        event->accept();
        playTold();
    }
}

void Plot::focusInEvent(QFocusEvent *event)
{
    QChartView::focusInEvent(event);
    viewport()->update();
}

void Plot::focusOutEvent(QFocusEvent *event)
{
    QChartView::focusOutEvent(event);
    viewport()->update();
}

} // namespace cradle
