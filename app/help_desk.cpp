// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_desk.h"

#include "app/keys_dialog.h"
#include "app/panes.h"
#include "app/room.h"
#include "app/tour.h"
#include "app/workbench.h"
#include "views/code/code_pane.h"
#include "views/inspector/inspector.h"
#include "views/markdown_view.h"
#include "views/mnemonics.h"
#include "views/scene/scene_view.h"
#include "views/task_pane/task_pane.h"
#include "views/text_direction.h"
#include "views/theme.h"
#include "views/timeline.h"
#include "views/transport_bar.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QFile>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include <algorithm>

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

HelpDesk::HelpDesk(Workbench &workbench, Panes &panes, Room &room, QMainWindow &window)
    : m_workbench(workbench)
    , m_panes(panes)
    , m_room(room)
    , m_window(window)
{
}

void HelpDesk::showTour()
{
    m_room.showSceneAlone(false);
    const bool code = m_workbench.mode() == Mode::Code;
    m_panes.momentumDock->raise();
    m_panes.workplace(m_workbench.mode())->raise();
    new Tour(
        &m_window,
        {{m_panes.task, tr("The step"),
          tr("Here stands what to do and why. The dots are the steps of the lab; hints wait below "
             "the text.")},
         {code ? static_cast<QWidget *>(m_panes.code) : m_panes.inspector,
          code ? tr("Your program") : tr("The scene in numbers"),
          code ? tr("You keep one program through all steps. It is saved and runs as you type; "
                    "F1 explains the word under the cursor.")
               : tr("World, laws and circles: what you change here or by dragging in the scene "
                    "starts the run anew.")},
         {m_panes.scene, tr("The scene"),
          tr("What your circles do. At a hit, arrows show the parts of the velocities along and "
             "across the normal.")},
         {m_panes.momentumDock, tr("Charts"),
          tr("Momentum and energy of the same run. Click where you want the numbers of that "
             "moment; every hit is marked.")},
         {m_panes.timeline, tr("Any moment again"),
          tr("Drag to any moment of the run, or press Next hit. Space runs and pauses.")},
         {m_panes.transport, tr("Run and check"),
          tr("Run to watch; Check when you are done: it says what is right, what is not, and "
             "why.")}});
}

void HelpDesk::showCSharpSheet()
{
    if (!m_sheet) {
        m_sheet = new MarkdownView(&m_window);
        m_sheet->setWindowFlag(Qt::Window);
        m_sheet->setAttribute(Qt::WA_DeleteOnClose);
        m_sheet->resize(QSize(scaledByText(760), scaledByText(640)).boundedTo(m_window.size()));
    }
    //: The file of the page in your language: docs/lua-for-csharp.LANGUAGE.md, if there is one
    QFile page(tr(":/help/lua-for-csharp.md"));
    if (page.open(QIODevice::ReadOnly))
        m_sheet->setMarkdown(QString::fromUtf8(page.readAll()), {});
    m_sheet->setWindowTitle(tr("Lua for C# people"));
    m_sheet->setAccessibleName(m_sheet->windowTitle());
    m_sheet->moveCursor(QTextCursor::Start);
    m_sheet->show();
    m_sheet->raise();
    m_sheet->activateWindow();
}

void HelpDesk::showShortcuts()
{
    std::vector<KeyRow> menus;
    addKeysOfMenus(*m_window.menuBar(), menus);
    std::vector<KeyRow> program;
    addKeys(m_panes.code->findChildren<QAction *>(), program);
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
    const std::vector<KeyRow> charts{
        {tr("Zoom to a box"), tr("Shift+drag")},
        {tr("Zoom at the pointer"), tr("wheel; values alone with Ctrl")},
        {tr("Move along"), tr("drag with the middle button")},
        {tr("Reset the zoom"), tr("double click")}};
    const auto half = static_cast<std::ptrdiff_t>((menus.size() + 1) / 2);
    const QString still(QChar::Nbsp);
    KeysDialog({{{tr("Anywhere"), {menus.begin(), menus.begin() + half}}},
                {{still, {menus.begin() + half, menus.end()}},
                 {tr("On the timeline and the steps"), time}},
                {{tr("In the program"), program},
                 {tr("In the scene"), scene},
                 {tr("In a chart"), charts}}},
               &m_window)
        .exec();
}

void HelpDesk::showAbout()
{
    QMessageBox::about(&m_window, tr("About Cradle"),
                       tr("<h3>Cradle %1</h3><p>Learn how a physics engine works by writing one."
                          "</p><p>Free software under the GNU General Public License, version 3 or "
                          "later. Built with Qt, Lua, QScintilla, MathJax and valijson.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

} // namespace cradle
