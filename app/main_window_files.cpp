// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/main_window.h"

#include "app/author_window.h"
#include "app/lab_drop.h"
#include "app/language.h"
#include "app/named_opening.h"
#include "model/files/preset_json.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/work/work_archive.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>

#include <algorithm>
#include <utility>

namespace cradle {

// Dialogs of the window.

void MainWindow::openLabFolder()
{
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a lab's folder"));
    if (!folder.isEmpty())
        openLab(folder);
}

void MainWindow::openLabFile()
{
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Open a lab in one file"), {},
                                     tr("Labs and work (*.cradle *.cradle-work);;All files "
                                        "(*)"));
    if (!path.isEmpty())
        openLab(path);
}

void MainWindow::openLab(const QString &path)
{
    if (isWorkArchive(path) || isWorkspace(path)) {
        if (const auto error = openNamed(m_workbench, path, {}, userLabsFolder()))
            report(*error);
        return;
    }
    const Result<QString> folder = labFolder(path, this);
    if (!folder)
        report(folder.error());
    else if (folder->isEmpty())
        return;
    else if (const auto error = m_workbench.openLab(*folder, currentLanguage()))
        report(*error);
}

AuthorWindow *MainWindow::author() const
{
    const auto last = std::find_if(m_authors.rbegin(), m_authors.rend(),
                                   [](const auto &author) { return !author.isNull(); });
    return last == m_authors.rend() ? nullptr : last->data();
}

void MainWindow::authorLab()
{
    const QString folder = m_workbench.lab().folder;
    for (const QPointer<AuthorWindow> &author : std::as_const(m_authors)) {
        if (!author || QFileInfo(author->document().folder()) != QFileInfo(folder))
            continue;
        author->raise();
        author->activateWindow();
        return;
    }
    if (const auto error = openAuthor(folder))
        report(*error);
    else
        author()->show();
}

std::optional<Error> MainWindow::openAuthor(const QString &folder)
{
    auto author = std::make_unique<AuthorWindow>(m_settings);
    author->document().setLanguage(currentLanguage()); // the lab's own, if it has no such texts
    if (auto error = author->open(folder))
        return error;
    author->setAttribute(Qt::WA_DeleteOnClose);
    connect(author.get(), &AuthorWindow::studentRequested, this,
            [this](const QString &lab, const QString &task) {
                if (const auto error = m_workbench.openLab(lab, currentLanguage()))
                    report(*error);
                else
                    m_workbench.openTask(task);
                show();
                raise();
                activateWindow();
            });
    m_authors.removeIf([](const auto &window) { return !window; });
    m_authors.append(author.release());
    return std::nullopt;
}

void MainWindow::openPresetFile()
{
    const QString path = QFileDialog::getOpenFileName(this, tr("Open a scene"), {},
                                                      tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = m_workbench.openPreset(path))
        report(*error);
}

void MainWindow::openExample(Example example)
{
    if (const auto error = m_workbench.openExample(example))
        report(*error);
}

void MainWindow::savePresetAs()
{
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the scene"), QStringLiteral("scene.json"),
                                     tr("Scenes (*.json);;All files (*)"));
    if (path.isEmpty())
        return;
    if (const auto error = savePreset(m_workbench.document().own(), path))
        report(*error);
}

void MainWindow::showAbout()
{
    QMessageBox::about(this, tr("About Cradle"),
                       tr("<h3>Cradle %1</h3><p>Learn how a physics engine works by writing one."
                          "</p><p>Free software under the GNU General Public License, version 3 or "
                          "later. Built with Qt, Lua, QScintilla, MathJax and valijson.</p>")
                           .arg(QCoreApplication::applicationVersion()));
}

} // namespace cradle
