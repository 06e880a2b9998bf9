// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening.h"

#include "app/lab_drop.h"
#include "app/language.h"
#include "app/named_opening.h"
#include "app/notice_bar.h"
#include "app/workbench.h"
#include "model/files/preset_json.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/work/work_archive.h"

#include <QFileDialog>

namespace cradle {

Opening::Opening(Workbench &workbench, NoticeBar &notice, QWidget &window)
    : m_workbench(workbench)
    , m_notice(notice)
    , m_window(window)
{
    connect(new LabDrop(&window), &LabDrop::dropped, this, &Opening::openLab);
}

void Opening::openLabFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(&m_window, tr("Open a lab's folder"));
    if (!folder.isEmpty())
        openLab(folder);
}

void Opening::openLabFile()
{
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Open a lab in one file"), {},
                                     tr("Labs and work (*.cradle *.cradle-work);;All files "
                                        "(*)"));
    if (!path.isEmpty())
        openLab(path);
}

void Opening::openLab(const QString &path)
{
    if (isWorkArchive(path) || isWorkspace(path)) {
        if (const auto error = openNamed(m_workbench, path, {}, userLabsFolder()))
            m_notice.showNotice(error->toString());
        return;
    }
    const Result<QString> folder = labFolder(path, &m_window);
    if (!folder)
        m_notice.showNotice(folder.error().toString());
    else if (folder->isEmpty())
        return;
    else if (const auto error = m_workbench.openLab(*folder, currentLanguage()))
        m_notice.showNotice(error->toString());
}

void Opening::openPresetFile()
{
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open a scene"), {},
                                                      tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = m_workbench.openPreset(path))
        m_notice.showNotice(error->toString());
}

void Opening::openExample(Example example)
{
    if (const auto error = m_workbench.openExample(example))
        m_notice.showNotice(error->toString());
}

void Opening::savePresetAs()
{
    const QString path =
        QFileDialog::getSaveFileName(&m_window, tr("Save the scene"), QStringLiteral("scene.json"),
                                     tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = savePreset(m_workbench.document().own(), path))
        m_notice.showNotice(error->toString());
}

} // namespace cradle
