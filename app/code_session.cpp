// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/code_session.h"

#include <QFileInfo>

#include <chrono>
#include <utility>

namespace cradle {

namespace {

using namespace std::chrono_literals;

constexpr auto saveDelay = 200ms;  ///< after the first key that is not saved
constexpr auto applyDelay = 400ms; ///< after the last key: a word is seldom a program
constexpr auto keepDelay = 10min;  ///< of changed text, for a version of it
constexpr auto lookDelay = 300ms;  ///< other programs write a file in several steps
constexpr auto retryDelay = 2s;    ///< after what could not be saved

} // namespace

CodeSession::CodeSession(Simulation &simulation, QObject *parent)
    : QObject(parent)
    , m_simulation(simulation)
    , m_run(simulation)
{
    m_saveSoon.setSingleShot(true);
    m_saveSoon.setInterval(saveDelay);
    m_applySoon.setSingleShot(true);
    m_applySoon.setInterval(applyDelay);
    m_keepSoon.setSingleShot(true);
    m_keepSoon.setInterval(keepDelay);
    m_lookSoon.setSingleShot(true);
    m_lookSoon.setInterval(lookDelay);
    connect(&m_saveSoon, &QTimer::timeout, this, &CodeSession::save);
    connect(&m_keepSoon, &QTimer::timeout, this,
            [this] { keepVersion(m_text, {.reason = VersionReason::Typed}); });
    connect(&m_lookSoon, &QTimer::timeout, this, &CodeSession::lookOutside);
    connect(&m_applySoon, &QTimer::timeout, this, &CodeSession::apply);
}

CodeSession::~CodeSession()
{
    save();
    keepTyped();
    m_run.close(); // who hears of it may still ask the session
}

void CodeSession::open(const Lab &lab, int index)
{
    open(lab, index, m_run.isActive(), [this](Program *program) {
        if (m_run.isActive())
            m_simulation.setProgram(program);
    });
}

void CodeSession::open(const Lab &lab, int index, bool active, const CodeRun::Start &start)
{
    save();
    keepTyped();
    m_applySoon.stop();
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    m_taskId = task.id;
    const Result<QString> text = m_workspace.textOf(lab, index);
    m_foreign = text ? std::nullopt : std::optional(text.error());
    m_text = text ? *text : QString();
    m_unsaved = false;
    watch();
    m_run.open(m_text, task.locked, active, [&](Program *program) {
        emit opened(m_text);
        start(program);
    });
    emit versionsChanged();
    emit stateChanged();
}

void CodeSession::close()
{
    save();
    keepTyped();
    m_applySoon.stop();
    m_watcher.reset();
    m_taskId.clear();
    m_text.clear();
    m_foreign.reset();
    m_unsaved = false;
    m_run.close();
    emit opened({});
    emit versionsChanged();
    emit stateChanged();
}

bool CodeSession::isEditable() const
{
    return isOpen() && !m_foreign && m_workspace.mayWrite();
}

void CodeSession::setAppliesAtOnce(bool atOnce)
{
    m_atOnce = atOnce;
    if (atOnce)
        apply();
    else
        m_applySoon.stop();
}

void CodeSession::edit(const QString &text)
{
    if (!isEditable() || text == m_text)
        return;
    m_text = text;
    m_unsaved = true;
    // Never started again by the next key: who types without a pause is saved, too.
    if (!m_saveSoon.isActive())
        m_saveSoon.start(saveDelay);
    if (!m_keepSoon.isActive())
        m_keepSoon.start();
    if (m_atOnce)
        m_applySoon.start();
    emit edited();
    emit stateChanged();
}

void CodeSession::replace(const QString &text)
{
    if (!isEditable())
        return;
    keepVersion(m_text, {.reason = VersionReason::Before});
    edit(text);
    emit textReplaced(m_text);
    apply();
}

void CodeSession::apply()
{
    m_applySoon.stop();
    if (!isOpen())
        return;
    m_run.apply(m_text);
    emit stateChanged();
}

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
