// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/work_dialogs.h"

#include "app/grade_dialog.h"
#include "app/hand_in_dialog.h"
#include "app/keeping_desk.h"
#include "app/notice_bar.h"
#include "app/report_dialog.h"
#include "app/share_dialog.h"

namespace cradle {

WorkDialogs::WorkDialogs(Workbench &workbench, KeepingDesk &keeping, NoticeBar &notice,
                         QWidget &window)
    : m_workbench(workbench)
    , m_keeping(keeping)
    , m_notice(notice)
    , m_window(window)
{
    connect(&workbench.check(), &WorkCheck::labFinished, this, [this] { lookBack(true); });
}

/// Says so where nothing of the work is kept, or by whom.
bool WorkDialogs::hasWork()
{
    const Workspace &workspace = m_workbench.code().workspace();
    if (m_workbench.task() && workspace.history())
        return true;
    m_notice.showNotice(m_workbench.task() ? tr("Nothing of this work is kept on a disk.")
                                           : tr("Open a step of a lab first."));
    return false;
}

void WorkDialogs::lookBack(bool finished)
{
    if (!hasWork())
        return;
    m_keeping.saveNote();
    auto *dialog = new ReportDialog(m_workbench, finished, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ReportDialog::handInRequested, this, &WorkDialogs::openHandIn);
    dialog->open();
}

void WorkDialogs::openReport()
{
    lookBack(false);
}

void WorkDialogs::openGrading()
{
    if (!m_workbench.task()) {
        m_notice.showNotice(tr("Open a step of a lab first."));
        return;
    }
    auto *dialog = new GradeDialog(m_workbench.lab(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void WorkDialogs::openHandIn()
{
    if (!hasWork())
        return;
    m_keeping.saveNote();
    auto *dialog = new HandInDialog(m_workbench, &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

void WorkDialogs::shareWork()
{
    if (!hasWork())
        return;
    auto *dialog = new ShareDialog(m_workbench.code().workspace(), &m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->open();
}

} // namespace cradle
