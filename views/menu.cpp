// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/menu.h"

#include "views/text_direction.h"

#include <QAbstractScrollArea>
#include <QMenuBar>
#include <QStyleOptionMenuItem>

namespace cradle {

Menu *Menu::addMenu(const QString &title)
{
    auto *menu = new Menu(title, this);
    addAction(menu->menuAction());
    return menu;
}

void Menu::initStyleOption(QStyleOptionMenuItem *option, const QAction *action) const
{
    QMenu::initStyleOption(option, action);
    const qsizetype tab = option->text.indexOf(QLatin1Char('\t')); // the keys stand behind it
    if (tab >= 0)
        option->text = option->text.left(tab + 1) + isolated(option->text.mid(tab + 1));
}

Menu *addMenu(QMenuBar &bar, const QString &title)
{
    auto *menu = new Menu(title, &bar);
    bar.addMenu(menu);
    return menu;
}

void offerActions(QWidget &widget)
{
    widget.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&widget, &QWidget::customContextMenuRequested, &widget,
                     [asked = &widget](const QPoint &at) {
                         Menu menu(asked);
                         menu.addActions(asked->actions());
                         const auto *area = qobject_cast<const QAbstractScrollArea *>(asked);
                         menu.exec((area ? area->viewport() : asked)->mapToGlobal(at));
                     });
}

} // namespace cradle
