// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/author_document.h"

#include "tasks/authoring/lab_draft.h"

#include <QDirIterator>
#include <QFileSystemWatcher>

namespace cradle {

// The lab on disk: saving, and edits by others.

/// Changes of a window that was killed come back as one edit.
void AuthorDocument::takeDraft()
{
    if (m_drafts.isEmpty() || m_readOnly)
        return;
    const auto draft = findDraft(m_drafts, m_folder, m_onDisk);
    if (!draft)
        return;
    if (draft->files != m_files && edit(tr("Changes that were not saved"), draft->files)) {
        m_onDisk = draft->base; // what others changed since is asked about when it is saved
        keepDraft();            // as this window's, before the other goes
        emit draftTaken(draft->when);
    }
    QFile::remove(draft->path);
}

bool AuthorDocument::hasUnsavedDraft() const
{
    return !m_drafts.isEmpty() && findDraft(m_drafts, {}, {});
}

bool AuthorDocument::openUnsavedDraft()
{
    const auto draft = m_drafts.isEmpty() ? std::nullopt : findDraft(m_drafts, {}, {});
    if (!draft)
        return false;
    begin(draft->files);
    keepDraft();
    QFile::remove(draft->path);
    emit draftTaken(draft->when);
    return true;
}

/// A draft that cannot be kept is none: the lab can still be saved, and saving says what is wrong.
void AuthorDocument::keepDraft()
{
    m_draftTimer.stop();
    if (m_drafts.isEmpty())
        return;
    if (isModified())
        (void)saveDraft(m_drafts, m_folder, m_files, m_onDisk);
    else
        removeDraft(m_drafts, m_folder);
}

void AuthorDocument::discardDraft()
{
    m_draftTimer.stop();
    if (!m_drafts.isEmpty())
        removeDraft(m_drafts, m_folder);
}

std::optional<Error> AuthorDocument::save(bool overwrite)
{
    if (auto error = saveLabFiles(m_files, m_onDisk, m_folder,
                                  overwrite ? OnConflict::Overwrite : OnConflict::Refuse))
        return error;
    m_onDisk = m_files;
    discardDraft();
    m_undoStack.setClean();
    watch();
    emit stateChanged();
    return std::nullopt;
}

std::optional<Error> AuthorDocument::saveCopy(const QString &folder, const LabFiles &files)
{
    const QDir target(folder);
    if (target.exists() && !target.isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden))
        return Error{.message = tr("the folder is not empty; a new or an empty one is right"),
                     .file = folder};
    if (auto error = saveLabFiles(files, {}, folder))
        return error;
    discardDraft(); // of what had no folder, or another
    if (files != m_files)
        m_undoStack.clear(); // it would take the old id back
    m_files = files;
    m_onDisk = m_files;
    m_folder = folder;
    m_readOnly = false;
    m_undoStack.setClean();
    watch();
    readSoon();
    emit stateChanged();
    emit changed(); // of a lab that was read-only every field may be edited now
    return std::nullopt;
}

std::optional<Error> AuthorDocument::reload()
{
    return readAgain(tr("Reload from the folder"), true);
}

std::optional<Error> AuthorDocument::takeTheirs()
{
    return readAgain(tr("Take what another program changed"), false);
}

/// \param whole  what is not saved goes; else only what is otherwise on disk than it was
std::optional<Error> AuthorDocument::readAgain(const QString &name, bool whole)
{
    std::vector<Error> findings;
    const Result<LabFiles> files = readLabFiles(m_folder, &findings);
    if (!files)
        return files.error();
    m_unread = findings;
    const LabFiles taken = whole ? *files : withTheirs(m_files, m_onDisk, *files);
    m_onDisk = *files;
    edit(name, taken);
    if (!steps().contains(m_step))
        setStep(steps().value(0));
    watch();
    emit stateChanged();
    return std::nullopt;
}

/// Listens to all folders and files of the lab, whoever changes them.
void AuthorDocument::watch()
{
    m_watcher.reset();
    if (m_folder.isEmpty() || m_readOnly)
        return;
    m_watcher = std::make_unique<QFileSystemWatcher>();
    QStringList paths{m_folder};
    for (auto it = m_onDisk.contents.keyBegin(); it != m_onDisk.contents.keyEnd(); ++it)
        paths.append(m_folder + QLatin1Char('/') + *it);
    QDirIterator folders(m_folder, QDir::Dirs | QDir::NoDotAndDotDot | QDir::NoSymLinks,
                         QDirIterator::Subdirectories);
    while (folders.hasNext())
        paths.append(folders.next());
    m_watcher->addPaths(paths);
    const auto lookSoon = [this] { m_lookTimer.start(); };
    connect(m_watcher.get(), &QFileSystemWatcher::fileChanged, this, lookSoon);
    connect(m_watcher.get(), &QFileSystemWatcher::directoryChanged, this, lookSoon);
}

/// Compares contents: a save of our own changes files too.
void AuthorDocument::lookOutside()
{
    const QStringList names = changedOnDisk(m_onDisk, m_folder);
    if (names.isEmpty())
        return;
    emit changedOutside(names.join(QStringLiteral(", ")));
    watch();
}

} // namespace cradle
