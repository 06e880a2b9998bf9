// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/scene/scene_editor.h"

class QAction;
class QWidget;

namespace cradle {

/// What can be done with the selected circles, for menus. Keys that mean something else in other
/// panes (copy, paste …) hold where the scene has the focus, the others in the whole window.
class SceneActions final : public QObject
{
    Q_OBJECT
public:
    /// \param scene  the widget whose keys these are; it owns them
    SceneActions(SceneEditor &editor, QWidget *scene);

    [[nodiscard]] const QList<QAction *> &all() const { return m_all; } ///< in the order of a menu

public slots:
    void retranslate();

private:
    QAction *add(const QKeySequence &key, Qt::ShortcutContext context, void (SceneEditor::*slot)());
    void followSelection();

    SceneEditor &m_editor;
    QWidget *m_scene;
    QAction *m_cut;
    QAction *m_copy;
    QAction *m_paste;
    QAction *m_duplicate;
    QAction *m_remove;
    QAction *m_stop;
    QAction *m_selectAll;
    QList<QAction *> m_all;
};

} // namespace cradle
