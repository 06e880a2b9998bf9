// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include <QFileInfo>

#include <chrono>
#include <utility>

namespace cradle {

// The program on disk: what is saved, what others change, what of it is kept.

namespace {

using namespace std::chrono_literals;

constexpr auto retryDelay = 2s; ///< after what could not be saved

} // namespace

void CodeSession::setWorkspace(Workspace workspace)
{
    m_workspace = std::move(workspace);
}

void CodeSession::save()
{
    m_saveSoon.stop();
    if (m_unsaved) {
        takeOutside();
        m_unsaved = false;
        finishSaving(m_workspace.save(m_taskId, m_text));
    } else if (m_workspace.hasUnsaved()) {
        finishSaving(m_workspace.saveUnsaved());
    }
}

/// What could not be saved is kept by the workspace, and tried again, unless another window has it.
void CodeSession::finishSaving(const std::optional<Error> &error)
{
    if (error) {
        if (m_workspace.mayWrite())
            m_saveSoon.start(retryDelay);
        if (!std::exchange(m_failing, true) || !m_workspace.mayWrite())
            emit failed(*error);
    } else {
        if (std::exchange(m_failing, false))
            emit savedAgain();
        watch();
    }
    emit stateChanged();
}

/// Watches the files of the open step; a file that is replaced must be watched anew.
void CodeSession::watch()
{
    if (m_workspace.folder().isEmpty() || !m_workspace.mayWrite()) {
        m_watcher.reset();
        return;
    }
    if (!m_watcher) {
        m_watcher = std::make_unique<QFileSystemWatcher>();
        const auto lookSoon = [this] { m_lookSoon.start(); };
        connect(m_watcher.get(), &QFileSystemWatcher::fileChanged, this, lookSoon);
        connect(m_watcher.get(), &QFileSystemWatcher::directoryChanged, this, lookSoon);
    }
    QStringList paths{m_workspace.folder(), m_workspace.folder() + QStringLiteral("/steps"),
                      m_workspace.labPath(), m_workspace.pathOf(m_taskId)};
    paths.removeIf([this](const QString &path) {
        return !QFile::exists(path) || m_watcher->files().contains(path)
               || m_watcher->directories().contains(path);
    });
    if (!paths.isEmpty())
        m_watcher->addPaths(paths);
}

void CodeSession::lookOutside()
{
    if (!isEditable())
        return;
    watch();
    if (takeOutside())
        save();
}

/// Keeps what another program has made of the files. Where nothing was typed meanwhile the newest
/// becomes the program. \return whether there was anything
bool CodeSession::takeOutside()
{
    const std::vector<OutsideEdit> edits = m_workspace.outsideEdits(m_taskId);
    if (edits.empty())
        return false;
    const bool taken = !m_unsaved && edits.back().text.has_value();
    if (taken)
        keepVersion(m_text, {.reason = VersionReason::Before});
    bool isProgram = false;
    for (const OutsideEdit &edit : edits) {
        isProgram = isProgram || edit.text.has_value();
        const auto kept = m_workspace.keepOutside(m_taskId, edit);
        if (!kept)
            emit failed(kept.error());
        else if (!kept->isEmpty())
            emit setAside(QFileInfo(edit.path).fileName(), QFileInfo(*kept).fileName());
    }
    emit versionsChanged();
    m_unsaved = true; // the two files are to be alike again
    if (taken) {
        m_text = *edits.back().text;
        emit textReplaced(m_text);
        emit edited();
        apply();
    }
    if (isProgram)
        emit changedOutside(taken);
    return true;
}

void CodeSession::keepVersion(const QString &text, const VersionNote &note)
{
    if (!isOpen())
        return;
    if (text == m_text)
        m_keepSoon.stop();
    if (const auto error = m_workspace.keep(m_taskId, text, note))
        emit failed(*error);
    emit versionsChanged();
}

void CodeSession::keepTyped()
{
    if (m_keepSoon.isActive())
        keepVersion(m_text, {.reason = VersionReason::Typed});
}

void CodeSession::takeOver(const Lab &lab, int index)
{
    m_workspace.takeOver();
    open(lab, index);
}

void CodeSession::replaceForeign(const Lab &lab, int index, bool convert)
{
    if (!m_foreign || !m_workspace.mayWrite())
        return;
    if (const auto error = m_workspace.replaceForeign(lab, index, convert))
        emit failed(*error);
    open(lab, index);
}

} // namespace cradle
