// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/scene_tab.h"

#include "tasks/script/locks.h"
#include "views/author/arrangement_dialog.h"
#include "views/author/scene_templates.h"
#include "views/menu.h"

#include <QPushButton>

namespace cradle {

// The menus of the tab: scenes to begin with, and what the student may not change.

void SceneTab::fillTemplates()
{
    m_templates->clear();
    for (const Preset &scene : sceneTemplates())
        m_templates->addAction(scene.name, this, [this, scene] { take(scene); });
    m_templates->addSeparator();
    using Pattern = Arrangement::Pattern;
    const std::pair<QString, Pattern> patterns[] = {{tr("&Rack…"), Pattern::Rack},
                                                    {tr("Gr&id…"), Pattern::Grid},
                                                    {tr("Ri&ng…"), Pattern::Ring}};
    for (const auto &[name, pattern] : patterns)
        m_templates->addAction(name, this, [this, pattern = pattern] { arrange(pattern); });
}

void SceneTab::take(const Preset &scene)
{
    m_preset.edit(tr("Take the template %1").arg(scene.name), scene);
}

/// Asks how many circles, and puts them into the scene.
void SceneTab::arrange(Arrangement::Pattern pattern)
{
    ArrangementDialog dialog(pattern, this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    if (const Result<Preset> made = cradle::presetOf(dialog.arrangement()))
        take(*made);
}

void SceneTab::fillLocks()
{
    const Preset &preset = m_preset.own();
    const QStringList fields = lockableFields(preset);
    QStringList names;
    for (const QString &field : fields) {
        const QString name = lockedName(field, preset);
        names.append(name.left(1).toUpper() + name.mid(1));
    }
    if (names == m_lockNames)
        return;
    m_lockNames = names;
    m_locks->clear();
    for (qsizetype i = 0; i < fields.size(); ++i) {
        const QString &field = fields[i];
        QAction *action = m_locks->addAction(names[i]);
        action->setCheckable(true);
        action->setData(field);
        connect(action, &QAction::triggered, this,
                [this, field](bool on) { setLocked(field, on); });
    }
}

void SceneTab::showLocks()
{
    fillLocks();
    const QStringList locked = lockedFields();
    for (QAction *action : m_locks->actions())
        action->setChecked(locked.contains(action->data().toString()));
    m_lockButton->setText(locked.isEmpty() ? tr("Lock…") : tr("Locked: %1").arg(locked.size()));
}

void SceneTab::setLocked(const QString &field, bool locked)
{
    const auto change = [&](TaskForm &form) {
        form.locked.removeAll(field);
        if (locked)
            form.locked.append(field);
    };
    if (!m_document.editTask(locked ? tr("Lock a field") : tr("Unlock a field"), change))
        showLocks();
}

} // namespace cradle
