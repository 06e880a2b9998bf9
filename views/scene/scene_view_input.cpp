// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The pointer in SceneView.
#include "views/scene/scene_view.h"

#include <QApplication>
#include <QMouseEvent>

#include <cmath>

namespace cradle {

namespace {

constexpr double wheelZoom = 1.0015; ///< per eighth of a degree: a notch is about a fifth

} // namespace

Handle SceneView::handleUnder(QPointF pixel) const
{
    const Simulation &simulation = m_document.simulation();
    const bool grips = m_options.velocities && simulation.atStart();
    return handleAt(pixel, simulation.recording().circles(simulation.current()),
                    simulation.preset(), m_camera, m_editor.selected(), grips);
}

void SceneView::setHovered(Handle handle)
{
    if (handle.kind == Handle::Kind::None)
        unsetCursor();
    else if (handle.kind == Handle::Kind::Velocity)
        setCursor(Qt::CrossCursor);
    else if (m_document.simulation().atStart())
        setCursor(m_drag ? Qt::ClosedHandCursor : Qt::OpenHandCursor);
    else
        setCursor(Qt::PointingHandCursor);
    if (handle.index != m_hovered.index)
        refresh();
    m_hovered = handle;
}

void SceneView::mousePressEvent(QMouseEvent *event)
{
    if (m_press.button != Qt::NoButton && m_press.button != event->button())
        return;
    m_press = {event->button(), event->position(), event->position(), {}, false};
    if (event->button() != Qt::LeftButton)
        return;
    m_press.handle = handleUnder(event->position());
    const int index = m_press.handle.index;
    const bool adds = event->modifiers() & (Qt::ControlModifier | Qt::ShiftModifier);
    if (m_press.handle.kind == Handle::Kind::None) {
        m_press.bands = adds;
    } else if (adds && m_press.handle.kind == Handle::Kind::Circle) {
        m_editor.toggle(index);
    } else if (m_editor.isSelected(index)) {
        // It may be the begin of a drag of all that are selected, so they stay so far.
        m_press.singlesOut = m_press.handle.kind == Handle::Kind::Circle;
        m_editor.addToSelection({index});
    } else {
        m_editor.select(index);
    }
}

void SceneView::mouseMoveEvent(QMouseEvent *event)
{
    const QPointF pixel = event->position();
    if (m_press.button != Qt::LeftButton && m_press.button != Qt::MiddleButton) {
        setHovered(handleUnder(pixel));
        return;
    }
    const QPointF before = m_press.moved ? m_press.last : m_press.start;
    m_press.last = pixel;
    if (!m_press.moved) {
        if ((pixel - m_press.start).manhattanLength() < QApplication::startDragDistance())
            return;
        m_press.moved = true;
        beginMove();
    }
    if (m_drag) {
        drag(pixel, !event->modifiers().testFlag(Qt::AltModifier));
    } else if (m_press.bands) {
        m_band = QRectF(m_press.start, pixel).normalized();
        refresh();
    } else if (m_press.handle.kind == Handle::Kind::None) {
        m_camera.panBy(pixel - before);
        refresh();
    }
}

void SceneView::beginMove()
{
    if (m_press.handle.kind == Handle::Kind::None) {
        setCursor(m_press.bands ? Qt::CrossCursor : Qt::SizeAllCursor);
        return;
    }
    if (!m_editor.isSelected(m_press.handle.index))
        return; // this click took it out of the selection
    Simulation &simulation = m_document.simulation();
    if (!simulation.atStart()) {
        notice(SceneEditor::tr("Press Restart (R) to change the start, or start a new run "
                               "from here (Ctrl+Shift+R)"));
        return;
    }
    simulation.pause();
    m_drag.emplace(m_press.handle, m_document.preset(), m_camera.toMetres(m_press.start),
                   m_editor.selection(), arrowScale(simulation.preset()));
    setHovered(m_press.handle);
}

void SceneView::drag(QPointF pixel, bool snap)
{
    const Preset candidate = m_drag->candidate(m_camera.toMetres(pixel), snap);
    m_dragValue = m_drag->valueText(candidate);
    if (const std::optional<Error> fault = m_document.faultOf(candidate)) {
        m_refused = m_drag->dragged(candidate);
        m_refusal = fault->message;
    } else {
        m_refused.clear();
        m_refusal.clear();
        m_document.edit(m_drag->editText(), candidate, m_drag->mergeKey());
    }
    refresh();
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != m_press.button)
        return;
    const Press press = m_press;
    const QRectF band = m_band;
    endPress();
    if (press.button == Qt::LeftButton && !press.moved) {
        if (press.singlesOut)
            m_editor.select(press.handle.index);
        else if (press.handle.kind == Handle::Kind::None && !press.bands)
            m_editor.select(-1);
    }
    if (!band.isNull())
        selectWithin(band);
    setHovered(handleUnder(event->position()));
}

void SceneView::selectWithin(const QRectF &band)
{
    const Simulation &simulation = m_document.simulation();
    const auto circles = simulation.recording().circles(simulation.current());
    std::vector<int> inside;
    for (std::size_t i = 0; i < circles.size(); ++i) {
        if (band.contains(m_camera.toPixels(circles[i].position)))
            inside.push_back(static_cast<int>(i));
    }
    m_editor.addToSelection(inside);
}

/// Ends a drag as if it had not begun.
void SceneView::cancelMove()
{
    const bool changed = m_drag && !(m_drag->start() == m_document.preset());
    endPress();
    if (changed)
        m_document.undoStack().undo();
}

void SceneView::endPress()
{
    m_press = {};
    m_band = {};
    m_drag.reset();
    m_refused.clear();
    m_refusal.clear();
    m_dragValue.clear();
    refresh();
}

void SceneView::leaveEvent(QEvent *event)
{
    QWidget::leaveEvent(event);
    if (m_press.button == Qt::NoButton)
        setHovered({});
}

void SceneView::wheelEvent(QWheelEvent *event)
{
    m_camera.zoomAbout(event->position(), std::pow(wheelZoom, event->angleDelta().y()));
    refresh();
    event->accept();
}

} // namespace cradle
