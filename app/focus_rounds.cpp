// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/focus_rounds.h"

#include "app/focus_order.h"
#include "app/notice_bar.h"
#include "app/panes.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QTabBar>

#include <algorithm>
#include <iterator>

namespace cradle {

FocusRounds::FocusRounds(QMainWindow &window, const Panes &panes)
    : m_window(window)
    , m_panes(panes)
{
}

/// What F6 goes round, as the eye does.
std::vector<QWidget *> FocusRounds::paneRound() const
{
    std::vector<QWidget *> round{m_panes.task};
    std::vector<QWidget *> panes;
    for (const QDockWidget *pane : m_panes.docks) {
        if (pane->widget() != m_panes.task)
            panes.push_back(pane->widget());
    }
    panes.push_back(m_panes.scene);
    std::erase_if(panes, [](QWidget *pane) { return !isInSight(*pane); });
    sortByEye(panes, m_window);
    round.insert(round.end(), panes.begin(), panes.end());
    round.push_back(m_panes.timeline);
    round.push_back(m_panes.transport);
    return round;
}

/// What Tab goes round: the controls of those, the titles of panes, and what is said above all.
std::vector<QWidget *> FocusRounds::controlRound() const
{
    std::vector<QWidget *> parts = paneRound();
    const auto titles = m_window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly);
    std::copy_if(titles.begin(), titles.end(), std::back_inserter(parts),
                 [](const QTabBar *bar) { return isInSight(*bar); });
    std::erase_if(parts, [this](const QWidget *part) {
        return part->window() != &m_window || part == m_panes.timeline || part == m_panes.transport;
    });
    sortByEye(parts, m_window);
    parts.insert(parts.end(), {m_panes.timeline, m_panes.transport, m_panes.notice});
    std::vector<QWidget *> controls;
    for (QWidget *part : parts) {
        const std::vector<QWidget *> found = controlsIn(*part);
        controls.insert(controls.end(), found.begin(), found.end());
    }
    return controls;
}

void FocusRounds::focusNextPane(int direction)
{
    const std::vector<QWidget *> round = paneRound();
    const auto count = static_cast<int>(round.size());
    const QWidget *focused = QApplication::focusWidget();
    const auto here = std::find_if(round.begin(), round.end(), [focused](const QWidget *pane) {
        return focused && (pane == focused || pane->isAncestorOf(focused));
    });
    int at =
        here == round.end() ? (direction > 0 ? -1 : count) : static_cast<int>(here - round.begin());
    for (int tried = 0; tried < count; ++tried) {
        at = (at + direction + count) % count;
        QWidget *pane = round[static_cast<std::size_t>(at)];
        const std::vector<QWidget *> controls = controlsIn(*pane);
        const auto first = std::find_if(controls.begin(), controls.end(),
                                        [](const QWidget *each) { return isInSight(*each); });
        if (pane == m_panes.code)
            return m_panes.code->editor().setFocus(Qt::ShortcutFocusReason);
        if (first != controls.end())
            return (*first)->setFocus(Qt::ShortcutFocusReason);
    }
}

bool FocusRounds::focusNextControl(bool next)
{
    const std::vector<QWidget *> round = controlRound();
    const auto here = std::find(round.begin(), round.end(), QApplication::focusWidget());
    if (here == round.end())
        return false;
    const auto count = static_cast<std::ptrdiff_t>(round.size());
    const std::ptrdiff_t at = (here - round.begin() + (next ? 1 : count - 1)) % count;
    focusByTab(*round[static_cast<std::size_t>(at)], next);
    return true;
}

} // namespace cradle
