// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/code/code_actions.h"

#include "views/icons.h"

#include <QAction>
#include <QMenu>
#include <QWidget>

namespace cradle {

CodeActions::CodeActions(QWidget *pane)
    : QObject(pane)
{
    const auto make = [this, pane](const QKeySequence &keys, bool reacts = true) {
        auto *action = new QAction(this);
        action->setShortcut(keys);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        if (reacts)
            pane->addAction(action);
        return action;
    };
    run = make(Qt::CTRL | Qt::SHIFT | Qt::Key_Return);
    stepLine = make(Qt::Key_F10);
    finishStep = make(Qt::CTRL | Qt::Key_F10);
    afresh = make({});
    solution = make({});
    help = make(Qt::Key_F1);
    find = make(QKeySequence::Find);
    replace = make(Qt::CTRL | Qt::Key_H);
    findNext = make(Qt::Key_F3);
    findPrevious = make(Qt::SHIFT | Qt::Key_F3);
    // What runs the program does so wherever the focus is, like the keys of the transport bar.
    for (QAction *action : {run, stepLine, finishStep})
        action->setShortcutContext(Qt::WindowShortcut);
    // The editor itself takes these keys; here they are only named.
    zoomIn = make(QKeySequence::ZoomIn, false);
    zoomOut = make(QKeySequence::ZoomOut, false);
    zoomReset = make(Qt::CTRL | Qt::Key_0, false);
    stepLine->setEnabled(false);
    finishStep->setEnabled(false);
    retranslate();
}

void CodeActions::retranslate()
{
    const auto name = [](QAction *action, const QString &text, const QString &tip = {}) {
        action->setText(text);
        action->setIconText(text);
        action->setToolTip(tip.isEmpty() ? text : tip);
    };
    name(run, tr("Run code"), tr("Run the program as it stands now, from the start"));
    name(stepLine, tr("Step into line"), tr("Run one line of the program"));
    name(finishStep, tr("Finish step"), tr("Run the rest of this step"));
    name(afresh, tr("Start this step afresh…"),
         tr("Go back to the program that this step begins with"));
    name(help, tr("API reference"), tr("What the program may use"));
    name(find, tr("Find…"));
    name(replace, tr("Replace…"));
    name(findNext, tr("Find next"));
    name(findPrevious, tr("Find previous"));
    name(zoomIn, tr("Larger text"));
    name(zoomOut, tr("Smaller text"));
    name(zoomReset, tr("Usual text size"));
    setSolutionShown(m_solutionShown);
}

void CodeActions::fillMenu(QMenu *menu) const
{
    menu->setToolTipsVisible(true);
    menu->addActions({help, find, replace});
    menu->addSeparator();
    menu->addActions({zoomIn, zoomOut, zoomReset});
    menu->addSeparator();
    menu->addActions({afresh, solution});
}

void CodeActions::setSolutionAvailable(bool available)
{
    m_solutionAvailable = available;
    setSolutionShown(m_solutionShown);
}

void CodeActions::setSolutionShown(bool shown)
{
    m_solutionShown = shown;
    solution->setEnabled(m_solutionAvailable || shown);
    solution->setText(shown ? tr("Hide the reference solution")
                            : tr("Show the reference solution"));
    solution->setToolTip(m_solutionAvailable || shown
                             ? tr("A program that passes this step, beside yours")
                             : tr("After you have passed this step, or opened all its hints"));
}

} // namespace cradle
