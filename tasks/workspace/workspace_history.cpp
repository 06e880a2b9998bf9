// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "model/files/preset_json.h"
#include "tasks/script/program_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace cradle {

// Who writes in the workspace, and what is kept of its past.

namespace {

struct HistoryText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

/// Whether a file of a step is newer than lab.lua, or the same.
bool isCovered(const QFileInfo &lab, const QByteArray &text, const QString &folder)
{
    for (const QFileInfo &step :
         QDir(folder + QStringLiteral("/steps")).entryInfoList({QStringLiteral("*.lua")})) {
        if (step.lastModified() >= lab.lastModified())
            return true;
        const auto there = readFile(step.filePath(), text.size());
        if (there && *there == text)
            return true;
    }
    return false;
}

} // namespace

std::optional<Error> Workspace::begin(const Lab &lab, const QString &currentTask)
{
    if (m_folder.isEmpty())
        return std::nullopt;
    if (auto error = makeFolder(m_folder)) {
        error->message = HistoryText::tr("your work cannot be saved here: %1").arg(error->message);
        return error;
    }
    m_lock = WorkspaceLock(m_folder);
    m_holder = m_lock.take();
    m_hasLock = m_lock.isHeld();
    m_readOnly = m_holder.has_value();
    auto fault = openHistory();
    const auto info = readWorkspaceInfo(m_folder);
    if (info)
        m_info = *info;
    if (m_readOnly)
        return fault;
    if (m_history && m_lock.killedSince().isValid())
        m_history->removeLocksSince(m_lock.killedSince());
    removeUnfinished(m_folder);
    removeUnfinished(m_folder + QStringLiteral("/steps"));
    m_info.labId = lab.id;
    m_info.labVersion = lab.version;
    m_info.labHash = lab.hash;
    if (auto error = saveInfo())
        return error;
    if (m_history && m_history->isEmpty()) {
        const QString message = QStringLiteral("Begin %1\n").arg(lab.id);
        if (auto error = m_history->commit(message, m_info.student))
            fault = error;
    }
    if (auto error = takeLabFile(currentTask))
        return error;
    return fault;
}

void Workspace::beginReading()
{
    m_readOnly = true;
    m_lookedAt = true;
    if (auto history = History::openExisting(m_folder))
        m_history = std::move(*history);
    if (const auto info = readWorkspaceInfo(m_folder))
        m_info = *info;
}

std::optional<Error> Workspace::openHistory()
{
    auto history = History::open(m_folder);
    if (!history)
        return history.error();
    m_history = std::move(*history);
    const QString exclude = m_history->gitFolder() + QStringLiteral("info/exclude");
    const auto text = readFile(exclude, 64 * 1024);
    const QByteArray wanted = QByteArray(lockFileName) + "*\n";
    if (!m_readOnly && (!text || !text->contains(wanted)))
        (void)writeFile(exclude, (text ? *text : QByteArray()) + wanted);
    return std::nullopt;
}

/// lab.lua as another program left it while no window was open.
std::optional<Error> Workspace::takeLabFile(const QString &currentTask)
{
    if (currentTask.isEmpty() || !QFile::exists(labPath()))
        return std::nullopt;
    const auto text = readProgram(labPath());
    if (!text || isCovered(QFileInfo(labPath()), text->toUtf8(), m_folder))
        return std::nullopt;
    if (const auto before = ownText(currentTask); before && *before)
        (void)keep(currentTask, **before, {.reason = VersionReason::Before});
    (void)keep(currentTask, *text, {.reason = VersionReason::Outside});
    return save(currentTask, *text);
}

/// Whether another window has taken the right to write since it was used last. A lock that is only
/// gone (with "git clean", say) is nobody's, and is taken again.
bool Workspace::wasTakenOver()
{
    if (!m_hasLock || m_lock.isHeld())
        return false;
    m_holder = m_lock.take();
    if (!m_holder)
        return false;
    m_hasLock = false;
    m_readOnly = true;
    return true;
}

void Workspace::takeOver()
{
    m_lock.takeOver();
    m_hasLock = m_lock.isHeld();
    m_readOnly = !m_hasLock;
    if (m_hasLock)
        m_holder.reset();
}

std::optional<Error> Workspace::keep(const QString &taskId, const QString &text,
                                     const VersionNote &note)
{
    if (!m_history || m_lookedAt)
        return std::nullopt;
    const QByteArray bytes = text.toUtf8();
    if (note.reason != VersionReason::Checked) {
        const auto newest = m_history->versions(taskId, 1);
        if (!newest.empty()) {
            const auto there = m_history->textOf(newest.front());
            if (there && *there == bytes)
                return std::nullopt;
        }
    }
    return m_history->keep(taskId, bytes, note, m_info.student);
}

std::optional<Preset> Workspace::passedScene(const QString &taskId) const
{
    const auto scene = readPreset(scenePath(taskId));
    return scene ? std::optional(*scene) : std::nullopt;
}

std::optional<Error> Workspace::commitPass(const CheckReport &report,
                                           const std::optional<QString> &program,
                                           const std::optional<Preset> &scene)
{
    if (!m_history || wasTakenOver() || m_readOnly)
        return std::nullopt;
    const QString path = scenePath(report.taskId);
    if (scene) {
        if (auto error = write(path, writePreset(*scene)))
            return error;
    } else if (QFile file(path); file.exists() && !file.remove()) {
        return Error{.message = file.errorString(), .file = path};
    }
    const QString subject = report.commit.isEmpty() ? report.taskId : report.commit;
    QMap<QString, QByteArray> judged;
    if (program)
        judged.insert(QStringLiteral("steps/%1.lua").arg(report.taskId), program->toUtf8());
    return m_history->commit(passMessage(report.taskId, subject,
                                         {.reason = VersionReason::Checked,
                                          .passed = true,
                                          .seed = report.seed,
                                          .labHash = report.labHash}),
                             m_info.student, judged);
}

std::optional<Error> Workspace::setStudent(const QString &name, const QString &number)
{
    m_info.student = name.simplified();
    m_info.studentId = number.simplified();
    return m_folder.isEmpty() || wasTakenOver() || m_readOnly ? std::nullopt : saveInfo();
}

/// Written only if it says something else, so that git sees no change.
std::optional<Error> Workspace::saveInfo()
{
    const auto there = readWorkspaceInfo(m_folder);
    if (there && *there == m_info && isWorkspace(m_folder))
        return std::nullopt;
    return write(m_folder + QStringLiteral("/cradle.json"), cradle::textOf(m_info));
}

} // namespace cradle
