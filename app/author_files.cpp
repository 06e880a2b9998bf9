// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/author_files.h"

#include "app/author_notices.h"
#include "app/author_panes.h"
#include "app/lab_drop.h"
#include "app/new_folder_dialog.h"
#include "tasks/authoring/lab_edits.h"
#include "tasks/reading/lab_archive.h"
#include "tasks/text/spoken_locale.h"
#include "views/author/author_document.h"
#include "views/author/difference_dialog.h"
#include "views/author/lab_dialog.h"

#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>

namespace cradle {

AuthorFiles::AuthorFiles(AuthorDocument &document, const AuthorPanes &panes, AuthorNotices &notices,
                         QWidget &window)
    : m_document(document)
    , m_panes(panes)
    , m_notices(notices)
    , m_window(window)
{
    connect(&notices, &AuthorNotices::copyRequested, this, &AuthorFiles::saveAs);
    connect(&notices, &AuthorNotices::reloadRequested, this, &AuthorFiles::reload);
    connect(&notices, &AuthorNotices::unsavedLabRequested, this, [this] {
        if (mayDiscard())
            m_document.openUnsavedDraft();
    });
    // Queued: what is not saved is asked about when the drag is over.
    connect(new LabDrop(&window), &LabDrop::dropped, this, &AuthorFiles::openDropped,
            Qt::QueuedConnection);
}

std::optional<Error> AuthorFiles::open(const QString &folder)
{
    auto error = m_document.open(folder);
    if (!error && m_document.hasUnsavedDraft())
        m_notices.offerUnsavedLab();
    return error;
}

void AuthorFiles::newLab()
{
    if (!mayDiscard())
        return;
    bool ok = false;
    const QString title = QInputDialog::getText(&m_window, tr("New lab"), tr("Title of the lab:"),
                                                QLineEdit::Normal, tr("My lab"), &ok)
                              .trimmed();
    if (!ok || title.isEmpty())
        return;
    m_document.begin(cradle::newLab(nameFrom(title), title, m_document.language()));
}

void AuthorFiles::openFolder()
{
    if (!mayDiscard())
        return;
    openPath(QFileDialog::getExistingDirectory(&m_window, tr("Open a lab's folder")));
}

void AuthorFiles::openFile()
{
    if (mayDiscard())
        openPath(QFileDialog::getOpenFileName(&m_window, tr("Open a lab in one file"), {},
                                              tr("Labs (*.cradle);;All files (*)")));
}

void AuthorFiles::openDropped(const QString &path)
{
    if (mayDiscard())
        openPath(path);
}

/// A folder, or one file; an empty path is none.
void AuthorFiles::openPath(const QString &path)
{
    if (path.isEmpty())
        return;
    const Result<QString> folder = labFolder(path, &m_window);
    if (!folder)
        m_notices.report(folder.error());
    else if (folder->isEmpty())
        return;
    else if (const auto error = open(*folder))
        m_notices.report(*error);
}

bool AuthorFiles::save()
{
    if (m_document.folder().isEmpty() || m_document.isReadOnly())
        return saveAs();
    return saveInto(false);
}

bool AuthorFiles::saveInto(bool overwrite)
{
    const auto error = m_document.save(overwrite);
    if (!error) {
        tellRefused();
        return true;
    }
    if (!overwrite && !changedOnDisk(m_document.onDisk(), m_document.folder()).isEmpty())
        return settleWithTheirs(*error);
    m_notices.report(*error);
    return false;
}

/// Another program was faster: shows what it changed, and asks which is to stay.
bool AuthorFiles::settleWithTheirs(const Error &error)
{
    const Result<LabFiles> theirs = readLabFiles(m_document.folder());
    if (!theirs) {
        m_notices.report(theirs.error());
        return false;
    }
    // What they changed, and nothing of what only waits to be saved.
    const LabFiles merged = withTheirs(m_document.files(), m_document.onDisk(), *theirs);
    DifferenceDialog dialog(error.message, m_document.files(), merged, &m_window);
    enum { ReplaceTheirs = 1, TakeTheirs };
    dialog.addChoice(tr("Replace with mine"), ReplaceTheirs);
    dialog.addChoice(tr("Take theirs"), TakeTheirs);
    const int choice = dialog.exec();
    if (choice == ReplaceTheirs)
        return saveInto(true);
    if (choice == TakeTheirs) {
        if (const auto unread = m_document.takeTheirs()) {
            m_notices.report(*unread);
            return false;
        }
        m_notices.clear(); // that something changed
        return saveInto(false);
    }
    return false;
}

/// Takes the folder's files. What is not saved would go with that, so it asks first.
void AuthorFiles::reload()
{
    const Result<LabFiles> theirs = readLabFiles(m_document.folder());
    if (m_document.isModified() && theirs && *theirs != m_document.files()) {
        DifferenceDialog dialog(tr("You have changes that are not saved. If you take the files of "
                                   "the folder instead, Undo brings yours back."),
                                m_document.files(), *theirs, &m_window);
        dialog.addChoice(tr("Take theirs"), 1);
        if (dialog.exec() != 1) {
            m_notices.offerReload(
                changedOnDisk(m_document.onDisk(), m_document.folder()).join(QStringLiteral(", ")));
            return;
        }
    }
    if (const auto error = m_document.reload())
        m_notices.report(*error);
}

/// What is typed and is no value is not in the lab, and so not in what was saved.
void AuthorFiles::tellRefused()
{
    const QStringList fields = m_panes.refused();
    if (!fields.isEmpty())
        m_notices.say(
            tr("Saved, but for fields that hold no value yet: %1").arg(spokenList(fields)));
}

bool AuthorFiles::saveAs()
{
    // What was never saved has no other copy yet.
    LabFiles files = m_document.files();
    if (!m_document.folder().isEmpty() && labForm(files)) {
        LabDialog naming(m_document, LabDialog::Purpose::Copy, &m_window);
        if (naming.exec() != QDialog::Accepted)
            return false;
        files = naming.copy();
    }
    const Result<LabForm> lab = labForm(files);
    NewFolderDialog dialog(&m_window, tr("A new or empty folder for the lab"));
    dialog.setLabelText(QFileDialog::FileName, tr("Folder:"));
    dialog.selectFile(nameFrom(lab ? lab->title : m_document.title()));
    if (dialog.exec() != QDialog::Accepted)
        return false;
    if (const auto error = m_document.saveCopy(dialog.folder(), files)) {
        m_notices.report(*error);
        return false;
    }
    m_notices.clear();
    return true;
}

/// Saving does not keep what is no value: that goes with the window alone.
bool AuthorFiles::mayDropRefused()
{
    const QStringList fields = m_panes.refused();
    if (fields.isEmpty())
        return true;
    QMessageBox box(
        QMessageBox::Question, tr("Drop what was typed?"),
        tr("What is typed here is no value yet, and is not in the lab: %1").arg(spokenList(fields)),
        QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setDefaultButton(QMessageBox::Cancel);
    return box.exec() == QMessageBox::Discard;
}

bool AuthorFiles::mayDiscard()
{
    if (!mayDropRefused())
        return false;
    if (!m_document.isModified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Save the lab?"),
                    tr("The lab has changes that are not saved."),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return save();
    case QMessageBox::Discard:
        m_document.discardDraft();
        return true;
    default:
        return false;
    }
}

} // namespace cradle
