// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/menu.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>

namespace cradle {

/// The language of the window's menus.
struct MenuText {
    Q_DECLARE_TR_FUNCTIONS(MainMenu)
};

/// Adds an action that calls a slot of \p target; its shortcut holds in the whole window.
template <typename Target, typename Slot>
QAction *addEntry(Menu *menu, const QString &text, const QKeySequence &shortcut, Target *target,
                  Slot slot)
{
    QAction *action = menu->addAction(text);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::triggered, target, slot);
    return action;
}

/// Adds one that is on or off, and tells a slot of \p target which.
template <typename Target, typename Slot>
QAction *addToggle(Menu *menu, const QString &text, const QKeySequence &shortcut, bool on,
                   Target *target, Slot slot)
{
    QAction *action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(on);
    action->setShortcut(shortcut);
    QObject::connect(action, &QAction::toggled, target, slot);
    return action;
}

} // namespace cradle
