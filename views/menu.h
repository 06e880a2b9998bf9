// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

QT_BEGIN_NAMESPACE
class QMenuBar;
QT_END_NAMESPACE

namespace cradle {

/// A menu whose keys stand as they are, also where one reads from the right: Qt's have "++Ctrl".
class Menu : public QMenu
{
    Q_OBJECT
public:
    using QMenu::addMenu;
    using QMenu::QMenu;

    /// A submenu of the same kind.
    Menu *addMenu(const QString &title);

protected:
    void initStyleOption(QStyleOptionMenuItem *option, const QAction *action) const override;
};

/// Adds one to \p bar, which owns it.
Menu *addMenu(QMenuBar &bar, const QString &title);

/// Offers the actions of \p widget in a menu, where it is asked for one.
void offerActions(QWidget &widget);

} // namespace cradle
