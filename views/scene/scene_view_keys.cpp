// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Keyboard and menu of SceneView.
#include "views/scene/scene_view.h"

#include "views/menu.h"
#include "views/scene/scene_actions.h"

#include <QContextMenuEvent>
#include <QKeyEvent>

namespace cradle {

namespace {

constexpr double nudgeStep = 0.1;      ///< m
constexpr double fineNudgeStep = 0.01; ///< m, with Shift

} // namespace

bool SceneView::event(QEvent *event)
{
    // Keys that act here must not be taken for the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool arrow = key->key() >= Qt::Key_Left && key->key() <= Qt::Key_Down;
        if ((arrow && key->modifiers().testFlag(Qt::ControlModifier))
            || (key->key() == Qt::Key_Escape && (m_editor.selected() >= 0 || m_press.moved))) {
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

/// Shift and an arrow select the circle after or before the last one as well.
bool SceneView::extendSelection(const QKeyEvent &event)
{
    const bool back = event.key() == Qt::Key_Left;
    if (event.modifiers() != Qt::ShiftModifier || (!back && event.key() != Qt::Key_Right))
        return false;
    const int next = m_editor.selected() + (back ? -1 : 1);
    if (next >= 0 && next < m_editor.circleCount())
        m_editor.addToSelection({next});
    return true;
}

void SceneView::keyPressEvent(QKeyEvent *event)
{
    if (nudge(*event) || extendSelection(*event))
        return;
    if (event->key() == Qt::Key_Delete && m_editor.selected() >= 0)
        m_editor.removeSelected();
    else if (event->key() == Qt::Key_Escape && m_press.moved)
        cancelMove();
    else if (event->key() == Qt::Key_Escape && m_editor.selected() >= 0)
        m_editor.select(-1);
    else
        QWidget::keyPressEvent(event);
}

void SceneView::contextMenuEvent(QContextMenuEvent *event)
{
    // By the keyboard it is about the selected circles, by the pointer about what is under it.
    QPointF place = event->pos();
    const bool byKeyboard = event->reason() == QContextMenuEvent::Keyboard;
    if (byKeyboard) {
        const Simulation &simulation = m_document.simulation();
        const auto circles = simulation.recording().circles(simulation.current());
        place = selected() >= 0
                    ? m_camera.toPixels(circles[static_cast<std::size_t>(selected())].position)
                    : m_camera.middle();
    } else if (const int index = handleUnder(place).index; !m_editor.isSelected(index)) {
        m_editor.select(index);
    }
    const Vec2 at = m_camera.toMetres(place);
    Menu menu(this);
    menu.addAction(tr("Add circle here"), this, [this, at] { addCircle(at); });
    QAction *branch =
        menu.addAction(tr("Start a new run from here"), this, &SceneView::newRunRequested);
    branch->setEnabled(!m_document.simulation().atStart());
    menu.addSeparator();
    menu.addActions(m_actions->all());
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
