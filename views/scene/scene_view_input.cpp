// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Pointer and keyboard of SceneView.
#include "views/scene/scene_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

#include <cmath>

namespace cradle {

namespace {

constexpr double nudgeStep = 0.1;      ///< m
constexpr double fineNudgeStep = 0.01; ///< m, with Shift
constexpr double wheelZoom = 1.0015;   ///< per eighth of a degree: a notch is about a fifth

} // namespace

Handle SceneView::handleUnder(QPointF pixel) const
{
    const Simulation &simulation = m_document.simulation();
    const bool grips = m_options.velocities && simulation.atStart();
    return handleAt(pixel, simulation.recording().circles(simulation.current()),
                    simulation.preset().halfWidth, m_camera, m_editor.selected(), grips);
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
    if (m_press.handle.kind != Handle::Kind::None)
        m_editor.select(m_press.handle.index);
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
    } else if (m_press.handle.kind == Handle::Kind::None) {
        m_camera.panBy(pixel - before);
        refresh();
    }
}

void SceneView::beginMove()
{
    if (m_press.handle.kind == Handle::Kind::None) {
        setCursor(Qt::SizeAllCursor);
        return;
    }
    Simulation &simulation = m_document.simulation();
    if (!simulation.atStart()) {
        notice(SceneEditor::tr("Press Restart (R) to change the start"));
        return;
    }
    simulation.pause();
    m_drag.emplace(m_press.handle, m_document.preset(), m_camera.toMetres(m_press.start));
    setHovered(m_press.handle);
}

void SceneView::drag(QPointF pixel, bool snap)
{
    const Preset candidate = m_drag->candidate(m_camera.toMetres(pixel), snap);
    m_dragValue = m_drag->valueText(candidate);
    if (const std::optional<Error> fault = m_document.faultOf(candidate)) {
        m_refused = candidate.circles[static_cast<std::size_t>(m_drag->handle().index)].body;
        m_refusal = fault->message;
    } else {
        m_refused.reset();
        m_refusal.clear();
        m_document.edit(m_drag->editText(), candidate, m_drag->mergeKey());
    }
    refresh();
}

void SceneView::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() != m_press.button)
        return;
    const bool clickedNothing = m_press.button == Qt::LeftButton && !m_press.moved
                                && m_press.handle.kind == Handle::Kind::None;
    endPress();
    if (clickedNothing)
        m_editor.select(-1);
    setHovered(handleUnder(event->position()));
}

void SceneView::endPress()
{
    m_press = {};
    m_drag.reset();
    m_refused.reset();
    m_refusal.clear();
    m_dragValue.clear();
    refresh();
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event);
    if (event->button() == Qt::LeftButton && m_press.handle.kind != Handle::Kind::None)
        emit circleActivated(m_press.handle.index);
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

bool SceneView::event(QEvent *event)
{
    // Keys that act here must not be taken for the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool arrow = key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down;
        if ((arrow && key->modifiers().testFlag(Qt::ControlModifier))
            || (key->key() == Qt::Key_Escape && m_editor.selected() >= 0)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

bool SceneView::nudge(const QKeyEvent &event)
{
    if (!event.modifiers().testFlag(Qt::ControlModifier) || m_editor.selected() < 0)
        return false;
    const double step = event.modifiers().testFlag(Qt::ShiftModifier) ? fineNudgeStep : nudgeStep;
    switch (event.key()) {
    case Qt::Key_Left:
        m_editor.nudgeSelected({-step, 0.0});
        return true;
    case Qt::Key_Right:
        m_editor.nudgeSelected({step, 0.0});
        return true;
    case Qt::Key_Up:
        m_editor.nudgeSelected({0.0, step});
        return true;
    case Qt::Key_Down:
        m_editor.nudgeSelected({0.0, -step});
        return true;
    default:
        return false;
    }
}

void SceneView::keyPressEvent(QKeyEvent *event)
{
    if (nudge(*event))
        return;
    const bool control = event->modifiers() == Qt::ControlModifier;
    if (event->key() == Qt::Key_Delete && m_editor.selected() >= 0)
        m_editor.removeSelected();
    else if (event->key() == Qt::Key_D && control)
        m_editor.duplicateSelected();
    else if (event->key() == Qt::Key_Escape && m_drag)
        endPress();
    else if (event->key() == Qt::Key_Escape && m_editor.selected() >= 0)
        m_editor.select(-1);
    else
        QWidget::keyPressEvent(event);
}

void SceneView::contextMenuEvent(QContextMenuEvent *event)
{
    // By the keyboard it is about the selected circle, by the pointer about what is under it.
    QPointF place = event->pos();
    const bool byKeyboard = event->reason() == QContextMenuEvent::Keyboard;
    if (byKeyboard) {
        const Simulation &simulation = m_document.simulation();
        const auto circles = simulation.recording().circles(simulation.current());
        place = selected() >= 0
                    ? m_camera.toPixels(circles[static_cast<std::size_t>(selected())].position)
                    : m_camera.middle();
    } else {
        m_editor.select(handleUnder(place).index);
    }
    const Vec2 at = m_camera.toMetres(place);
    QMenu menu(this);
    menu.addAction(tr("Add circle here"), this, [this, at] { addCircle(at); });
    menu.addSeparator();
    QAction *const forCircle[] = {
        menu.addAction(tr("Duplicate"), this, &SceneView::duplicateSelected),
        menu.addAction(tr("Remove"), this, &SceneView::removeSelected),
        menu.addAction(tr("Set velocity to zero"), this, &SceneView::stopSelected)};
    for (QAction *action : forCircle)
        action->setEnabled(selected() >= 0);
    menu.addSeparator();
    menu.addAction(tr("Fit view"), this, &SceneView::fit);
    endPress();
    menu.exec(byKeyboard ? mapToGlobal(place.toPoint()) : event->globalPos());
}

void SceneView::focusInEvent(QFocusEvent *event)
{
    QWidget::focusInEvent(event);
    m_focusFrame = event->reason() == Qt::TabFocusReason
                   || event->reason() == Qt::BacktabFocusReason
                   || event->reason() == Qt::ShortcutFocusReason;
    if (event->reason() == Qt::TabFocusReason)
        m_editor.select(0);
    else if (event->reason() == Qt::BacktabFocusReason)
        m_editor.select(m_editor.circleCount() - 1);
    refresh();
}

void SceneView::focusOutEvent(QFocusEvent *event)
{
    QWidget::focusOutEvent(event);
    m_focusFrame = false;
    refresh();
}

bool SceneView::focusNextPrevChild(bool next)
{
    // Tab goes from circle to circle and, after the last one, on to the next widget.
    const int target =
        selected() < 0 ? (next ? 0 : m_editor.circleCount() - 1) : selected() + (next ? 1 : -1);
    if (target < 0 || target >= m_editor.circleCount())
        return QWidget::focusNextPrevChild(next);
    m_editor.select(target);
    return true;
}

} // namespace cradle
