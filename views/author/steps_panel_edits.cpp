// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/steps_panel.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/rows_list.h"

#include <QListWidget>

namespace cradle {

// What its buttons, its menu and a drag do.

void StepsPanel::addStep()
{
    const QStringList steps = m_document.steps();
    const QString name = freeStepName(m_document.files(), QStringLiteral("step"));
    const auto at = static_cast<int>(steps.indexOf(m_document.step())) + 1;
    if (m_document.editStep(tr("Add a step"),
                            withStepAdded(m_document.files(), name, tr("New step"), at), name))
        renameStep();
}

void StepsPanel::duplicateStep()
{
    const QString name = freeStepName(m_document.files(), m_document.step());
    m_document.editStep(tr("Duplicate the step"),
                        withStepDuplicated(m_document.files(), m_document.step(), name), name);
}

void StepsPanel::removeStep()
{
    const QStringList steps = m_document.steps();
    const auto at = steps.indexOf(m_document.step());
    if (at < 0)
        return;
    const QString next = at + 1 < steps.size() ? steps[at + 1] : steps.value(at - 1);
    const QStringList foreign = foreignFiles(m_document.files(), m_document.step());
    const bool done = m_document.editStep(
        tr("Remove the step"), withStepRemoved(m_document.files(), m_document.step()), next);
    if (done && !foreign.isEmpty())
        emit said(
            tr("Files that the step did not use stay: %1").arg(foreign.join(QStringLiteral(", "))));
}

void StepsPanel::renameStep()
{
    if (QListWidgetItem *item = m_list->currentItem(); item && !m_document.isReadOnly()) {
        m_loading = true;
        item->setText(item->data(TitleRole).toString()); // without its number
        m_loading = false;
        m_list->setFocus();
        m_list->editItem(item);
    }
}

void StepsPanel::takeTitle(QListWidgetItem *item)
{
    if (m_loading)
        return;
    const QString step = item->data(FolderRole).toString();
    const QString number = QStringLiteral("%1 · ").arg(m_list->row(item) + 1);
    QString title = item->text().trimmed();
    if (title.startsWith(number))
        title.remove(0, number.size());
    if (title.isEmpty())
        return;
    // Queued: the list is filled anew by the edit, and its editor is still at work.
    QMetaObject::invokeMethod(
        this, [this, step, title] { setTitle(step, title); }, Qt::QueuedConnection);
}

void StepsPanel::setTitle(const QString &step, const QString &title)
{
    Result<TaskForm> form = taskForm(m_document.files(), step, m_document.language());
    if (!form)
        return;
    form->title = title;
    m_document.edit(tr("Rename the step"),
                    withTask(m_document.files(), step, *form, m_document.language()));
}

void StepsPanel::moveUp()
{
    move(-1);
}

void StepsPanel::moveDown()
{
    move(1);
}

void StepsPanel::move(int by)
{
    const QStringList steps = m_document.steps();
    const auto from = static_cast<int>(steps.indexOf(m_document.step()));
    if (from < 0 || from + by < 0 || from + by >= steps.size())
        return;
    m_document.edit(tr("Move the step"),
                    withStepMoved(m_document.files(), m_document.step(), from + by));
}

void StepsPanel::takeOrder()
{
    if (m_loading || m_list->count() != m_document.steps().size())
        return;
    const QStringList steps = m_document.steps();
    QStringList order;
    for (int i = 0; i < m_list->count(); ++i)
        order.append(m_list->item(i)->data(FolderRole).toString());
    if (order == steps)
        return;
    // One step was dragged: without it both orders are the same.
    for (const QString &step : steps) {
        QStringList rest = steps;
        QStringList dragged = order;
        rest.removeAll(step);
        dragged.removeAll(step);
        if (rest == dragged) {
            m_document.editStep(
                tr("Move the step"),
                withStepMoved(m_document.files(), step, static_cast<int>(order.indexOf(step))),
                step);
            return;
        }
    }
    reload();
}

} // namespace cradle
