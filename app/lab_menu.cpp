// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab_menu.h"

#include "app/language.h"
#include "app/main_window.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/reading/lab_list.h"
#include "views/menu.h"

#include <QActionGroup>
#include <QCoreApplication>

namespace cradle {

namespace {

struct LabMenuText {
    Q_DECLARE_TR_FUNCTIONS(LabMenu)
};

/// \param told  whether its version is, by which labs of one id are told apart
void addEntry(MainWindow &window, Menu *menu, QActionGroup *group, const ListedLab &lab, bool told)
{
    // An ampersand in a title is no mnemonic.
    QString title = told ? QStringLiteral("%1 · %2").arg(lab.title, lab.version) : lab.title;
    QAction *action = menu->addAction(title.replace(QLatin1Char('&'), QLatin1String("&&")));
    action->setCheckable(true);
    action->setChecked(lab.folder == window.workbench().lab().folder);
    group->addAction(action);
    QObject::connect(action, &QAction::triggered, &window,
                     [w = &window.opening(), folder = lab.folder] { w->openLab(folder); });
}

void fill(MainWindow &window, Menu *menu)
{
    menu->clear();
    // The group of the entries that were there before went with them.
    for (auto *old : menu->findChildren<QActionGroup *>())
        delete old;
    auto *group = new QActionGroup(menu);
    for (const ListedLab &lab : shippedLabs(currentLanguage()))
        addEntry(window, menu, group, lab, false);
    const std::vector<ListedLab> own = labsIn(userLabsFolder(), currentLanguage());
    if (own.empty())
        return;
    menu->addSeparator();
    for (const ListedLab &lab : own)
        addEntry(window, menu, group, lab, !lab.version.isEmpty());
}

} // namespace

void addLabs(MainWindow &window, Menu *menu)
{
    Menu *labs = menu->addMenu(LabMenuText::tr("&Labs"));
    fill(window, labs);
    QObject::connect(labs, &QMenu::aboutToShow, labs, [w = &window, labs] { fill(*w, labs); });
}

} // namespace cradle
