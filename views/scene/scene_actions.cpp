// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/scene/scene_actions.h"

#include <QAction>
#include <QWidget>

namespace cradle {

SceneActions::SceneActions(SceneEditor &editor, QWidget *scene)
    : QObject(scene)
    , m_editor(editor)
    , m_scene(scene)
{
    constexpr auto here = Qt::WidgetWithChildrenShortcut;
    constexpr auto anywhere = Qt::WindowShortcut;
    m_cut = add(QKeySequence::Cut, here, &SceneEditor::cutSelected);
    m_copy = add(QKeySequence::Copy, here, &SceneEditor::copySelected);
    m_paste = add(QKeySequence::Paste, here, &SceneEditor::paste);
    m_duplicate = add(Qt::CTRL | Qt::Key_D, anywhere, &SceneEditor::duplicateSelected);
    m_remove = add(Qt::CTRL | Qt::Key_Backspace, anywhere, &SceneEditor::removeSelected);
    m_stop = add({}, here, &SceneEditor::stopSelected);
    m_selectAll = add(QKeySequence::SelectAll, here, &SceneEditor::selectAll);
    connect(&editor, &SceneEditor::selectionChanged, this, &SceneActions::followSelection);
    retranslate();
    followSelection();
}

QAction *SceneActions::add(const QKeySequence &key, Qt::ShortcutContext context,
                           void (SceneEditor::*slot)())
{
    auto *action = new QAction(this);
    action->setShortcut(key);
    action->setShortcutContext(context);
    connect(action, &QAction::triggered, &m_editor, slot);
    m_scene->addAction(action);
    m_all.append(action);
    return action;
}

void SceneActions::followSelection()
{
    const bool any = !m_editor.selection().empty();
    for (QAction *action : {m_cut, m_copy, m_duplicate, m_remove, m_stop})
        action->setEnabled(any);
}

void SceneActions::retranslate()
{
    m_cut->setText(tr("Cu&t circles"));
    m_copy->setText(tr("&Copy circles"));
    m_paste->setText(tr("&Paste circles"));
    m_duplicate->setText(tr("&Duplicate circles"));
    m_remove->setText(tr("Re&move circles"));
    m_stop->setText(tr("Set velocities to &zero"));
    m_selectAll->setText(tr("Select a&ll circles"));
}

} // namespace cradle
