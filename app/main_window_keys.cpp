// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The keyboard's ways through the window.
#include "app/main_window.h"

#include "app/focus_order.h"
#include "app/keys_dialog.h"
#include "app/notice_bar.h"
#include "views/code/code_editor.h"
#include "views/code/code_pane.h"
#include "views/inspector/inspector.h"
#include "views/mnemonics.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/text_direction.h"
#include "views/timeline.h"
#include "views/transport_bar.h"
#include "views/values_table.h"

#include <QApplication>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>

#include <algorithm>
#include <iterator>

namespace cradle {

namespace {

QString keys(const QKeySequence &sequence)
{
    return isolated(sequence.toString(QKeySequence::NativeText));
}

/// What stands in a menu within a menu is named with it: there are two that zoom in. Menus of
/// buttons have no name.
void addKeys(const QList<QAction *> &actions, std::vector<KeyRow> &rows, const QString &within = {})
{
    for (const QAction *action : actions) {
        const QString name = withoutMnemonic(action->text());
        if (action->menu())
            addKeys(action->menu()->actions(), rows,
                    name.isEmpty() ? within : name + QStringLiteral(" · "));
        else if (!action->shortcut().isEmpty() && !name.isEmpty())
            rows.emplace_back(within + name, keys(action->shortcut()));
    }
}

void addKeysOfMenus(const QMenuBar &bar, std::vector<KeyRow> &rows)
{
    for (const QAction *menu : bar.actions())
        addKeys(menu->menu()->actions(), rows);
}

} // namespace

/// What F6 goes round, as the eye does.
std::vector<QWidget *> MainWindow::focusRound() const
{
    std::vector<QWidget *> round{m_taskPane};
    std::vector<QWidget *> panes;
    for (const QDockWidget *pane : m_docks) {
        if (pane->widget() != m_taskPane)
            panes.push_back(pane->widget());
    }
    panes.push_back(m_scene);
    std::erase_if(panes, [](QWidget *pane) { return !isInSight(*pane); });
    sortByEye(panes, *this);
    round.insert(round.end(), panes.begin(), panes.end());
    round.push_back(m_timeline);
    round.push_back(m_transport);
    return round;
}

/// What Tab goes round: the controls of those, the titles of panes, and what is said above all.
std::vector<QWidget *> MainWindow::tabRound() const
{
    std::vector<QWidget *> parts = focusRound();
    const auto titles = findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly);
    std::copy_if(titles.begin(), titles.end(), std::back_inserter(parts),
                 [](const QTabBar *bar) { return isInSight(*bar); });
    std::erase_if(parts, [this](const QWidget *part) {
        return part->window() != this || part == m_timeline || part == m_transport;
    });
    sortByEye(parts, *this);
    parts.insert(parts.end(), {m_timeline, m_transport, m_notice});
    std::vector<QWidget *> controls;
    for (QWidget *part : parts) {
        const std::vector<QWidget *> found = controlsIn(*part);
        controls.insert(controls.end(), found.begin(), found.end());
    }
    return controls;
}

/// Qt goes in the order in which controls were made, so that a card that is made later comes last.
bool MainWindow::focusNextPrevChild(bool next)
{
    const std::vector<QWidget *> controls = tabRound();
    const auto here = std::find(controls.begin(), controls.end(), QApplication::focusWidget());
    if (here == controls.end())
        return QMainWindow::focusNextPrevChild(next);
    const auto count = static_cast<std::ptrdiff_t>(controls.size());
    const std::ptrdiff_t at = (here - controls.begin() + (next ? 1 : count - 1)) % count;
    focusByTab(*controls[static_cast<std::size_t>(at)], next);
    return true;
}

void MainWindow::focusNextPane(int direction)
{
    const std::vector<QWidget *> round = focusRound();
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
        if (pane == m_code)
            return m_code->editor().setFocus(Qt::ShortcutFocusReason);
        if (first != controls.end())
            return (*first)->setFocus(Qt::ShortcutFocusReason);
    }
}

void MainWindow::focusCode()
{
    if (!m_workbench.task())
        return;
    if (m_workbench.mode() != Mode::Code)
        chooseMode(1);
    dock("code")->show();
    dock("code")->raise();
    m_code->editor().setFocus(Qt::ShortcutFocusReason);
}

void MainWindow::showShortcuts()
{
    std::vector<KeyRow> menus;
    addKeysOfMenus(*menuBar(), menus);
    std::vector<KeyRow> program;
    addKeys(m_code->findChildren<QAction *>(), program);
    std::sort(program.begin(), program.end());
    program.erase(std::unique(program.begin(), program.end()), program.end());
    // Of the text alone: no menu has them.
    program.insert(program.end(),
                   {{tr("Comment lines, or not"), keys(Qt::CTRL | Qt::Key_Slash)},
                    {tr("Words that fit here"), keys(Qt::CTRL | Qt::Key_Space)},
                    {tr("What the call takes"), keys(Qt::CTRL | Qt::SHIFT | Qt::Key_Space)},
                    {tr("Out of the program"), tr("Esc, then Tab")}});
    const std::vector<KeyRow> scene{
        {tr("Select several circles"), tr("Ctrl+click, Shift+drag, Shift+arrows")},
        {tr("Move what is selected"), tr("drag; Ctrl+arrows, finer with Shift")},
        {tr("Drag free of the grid"), tr("Alt")},
        {tr("Take a drag back"), tr("Esc")},
        {tr("Remove what is selected"), keys(Qt::Key_Delete)},
        {tr("Move the view"), tr("drag on empty space, or the middle button")},
        {tr("Zoom at the pointer"), tr("wheel")}};
    const std::vector<KeyRow> time{
        {tr("A step back or on"), tr("Left, Right")},
        {tr("The hit before or after"), tr("PgUp, PgDown")},
        {tr("Start and end of the run"), tr("Home, End")},
        {tr("From curve to curve of a chart, from bar to bar of the speeds"), tr("Up, Down")},
        {tr("Hear that curve from left to right"), tr("Return")},
        {tr("Along the dots of the steps, and open"), tr("Left, Right, Return")}};
    const auto half = static_cast<std::ptrdiff_t>((menus.size() + 1) / 2);
    const QString still(QChar::Nbsp);
    KeysDialog({{{tr("Anywhere"), {menus.begin(), menus.begin() + half}}},
                {{still, {menus.begin() + half, menus.end()}},
                 {tr("On the timeline and the steps"), time}},
                {{tr("In the program"), program}, {tr("In the scene"), scene}}},
               this)
        .exec();
}

} // namespace cradle
