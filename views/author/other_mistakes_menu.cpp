// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/other_mistakes_menu.h"

#include "tasks/authoring/task_form.h"
#include "views/author/author_document.h"

namespace cradle {

OtherMistakesMenu::OtherMistakesMenu(const AuthorDocument &document, QWidget *parent)
    : Menu(parent)
    , m_document(document)
{
    setObjectName(QStringLiteral("otherMistakes"));
    setToolTipsVisible(true);
}

void OtherMistakesMenu::retranslate()
{
    setTitle(tr("A mistake of another &step"));
}

void OtherMistakesMenu::fill()
{
    clear();
    const LabFiles &files = m_document.files();
    const auto plain = [](QString text) {
        return text.replace(QLatin1Char('&'), QLatin1String("&&"));
    };
    const QStringList steps = stepsOf(files);
    QMap<QString, Menu *> menus;
    for (const OtherMistake &mistake : mistakesOfOtherSteps(files, m_document.step())) {
        Menu *&menu = menus[mistake.step];
        if (!menu) {
            const auto form = taskForm(files, mistake.step, m_document.language());
            menu = addMenu(QStringLiteral("%1 · %2")
                               .arg(steps.indexOf(mistake.step) + 1)
                               .arg(plain(form ? form->title : mistake.step)));
            menu->setToolTipsVisible(true);
        }
        QAction *action = menu->addAction(plain(mistake.headline), this,
                                          [this, mistake] { emit chosen(mistake); });
        action->setToolTip(mistake.name);
    }
    menuAction()->setEnabled(!isEmpty());
    menuAction()->setToolTip(
        isEmpty() ? tr("No mistake of another step applies to this solution that the "
                       "step does not have")
                  : QString());
}

} // namespace cradle
