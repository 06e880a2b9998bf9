// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/keeping_desk.h"

#include "views/code/versions_pane.h"
#include "views/notes_pane.h"

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

constexpr int saveDelay = 250;     ///< ms after the first key that is not saved
constexpr int mostVersions = 300;  ///< that are shown
constexpr int keepDelay = 600'000; ///< ms of changed notes, for a version of them

/// The newest versions of a step, and the last that passed, however old.
std::vector<ShownVersion> shownVersions(const History &history, const QString &taskId)
{
    std::vector<ShownVersion> shown;
    const auto show = [&](const Version &version) {
        if (const auto text = history.textOf(version))
            shown.push_back({version, QString::fromUtf8(*text)});
    };
    for (const Version &version : history.versions(taskId, mostVersions))
        show(version);
    if (std::any_of(shown.begin(), shown.end(),
                    [](const ShownVersion &each) { return each.version.note.passed == true; }))
        return shown;
    const std::vector<Version> passes = history.passes();
    const auto last = std::find_if(passes.begin(), passes.end(),
                                   [&](const Version &pass) { return pass.taskId == taskId; });
    if (last != passes.end())
        show(*last);
    return shown;
}

} // namespace

KeepingDesk::KeepingDesk(Workbench &workbench, VersionsPane &versions, NotesPane &notes,
                         QObject *parent)
    : QObject(parent)
    , m_workbench(workbench)
    , m_versions(versions)
    , m_notes(notes)
{
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(saveDelay);
    m_keepSoon.setSingleShot(true);
    m_keepSoon.setInterval(keepDelay);
    CodeSession *code = &workbench.code();
    connect(code, &CodeSession::versionsChanged, this, &KeepingDesk::showVersions);
    connect(code, &CodeSession::stateChanged, this, &KeepingDesk::showPresent);
    connect(&workbench, &Workbench::modeChanged, this, &KeepingDesk::showPresent);
    connect(&versions, &VersionsPane::goBackRequested, code, &CodeSession::replace);
    // Before the workspace, or the step, is another one.
    connect(code, &CodeSession::opened, this, &KeepingDesk::keepNote);
    connect(&notes, &NotesPane::edited, this, [this] {
        m_noteEdited = true;
        if (!m_saveSoon.isActive())
            m_saveSoon.start();
        if (!m_keepSoon.isActive())
            m_keepSoon.start();
    });
    connect(&m_saveSoon, &QTimer::timeout, this, &KeepingDesk::saveNote);
    connect(&m_keepSoon, &QTimer::timeout, this, &KeepingDesk::keepNote);
    connect(&workbench, &Workbench::taskChanged, this, &KeepingDesk::openNote);
    showVersions();
    openNote();
}

KeepingDesk::~KeepingDesk()
{
    keepNote();
}

void KeepingDesk::showVersions()
{
    const CodeSession &code = m_workbench.code();
    const History *history = code.isOpen() ? code.workspace().history() : nullptr;
    m_versions.setVersions(history ? shownVersions(*history, code.taskId())
                                   : std::vector<ShownVersion>(),
                           code.text(), mayReplace());
}

bool KeepingDesk::mayReplace() const
{
    const CodeSession &code = m_workbench.code();
    return code.isEditable() && code.run().isActive();
}

void KeepingDesk::showPresent()
{
    const CodeSession &code = m_workbench.code();
    m_versions.setPresent(code.text(), mayReplace());
}

void KeepingDesk::openNote()
{
    keepNote();
    const CodeSession &code = m_workbench.code();
    m_noteTask = code.taskId();
    m_notes.setText(code.isOpen() ? code.workspace().noteOf(m_noteTask) : QString(),
                    code.isOpen() && code.workspace().mayWrite());
}

void KeepingDesk::saveNote()
{
    m_saveSoon.stop();
    if (!std::exchange(m_noteEdited, false) || m_noteTask.isEmpty())
        return;
    Workspace &workspace = m_workbench.code().workspace();
    const auto error = workspace.saveNote(m_noteTask, m_notes.text());
    if (workspace.hasUnsaved())
        m_workbench.code().save(); // says so, and tries again
    else if (error)
        emit m_workbench.failed(*error);
}

void KeepingDesk::keepNote()
{
    saveNote();
    if (!m_keepSoon.isActive())
        return;
    m_keepSoon.stop();
    if (const auto error = m_workbench.code().workspace().keepNote(m_noteTask))
        emit m_workbench.failed(*error);
}

} // namespace cradle
