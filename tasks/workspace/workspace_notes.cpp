// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/json_schema.h"

#include <QCoreApplication>
#include <QFile>

namespace cradle {

// What the student notes about the steps.

namespace {

struct NotesText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

constexpr qint64 noteBytes = 256 * 1024;

/// A file that is no such text is shown as far as it can be, and kept before it is replaced.
bool isNote(const QByteArray &bytes)
{
    return !bytes.contains('\0') && QString::fromUtf8(bytes).toUtf8() == bytes;
}

} // namespace

QString Workspace::notePath(const QString &taskId) const
{
    return m_folder + QStringLiteral("/notes/%1.md").arg(taskId);
}

QString Workspace::noteOf(const QString &taskId) const
{
    if (const auto found = m_notes.find(taskId); found != m_notes.end())
        return found->second;
    const QString path = notePath(taskId);
    m_known.erase(path);
    if (m_folder.isEmpty() || !QFile::exists(path))
        return {};
    const auto bytes = readFile(path, noteBytes);
    if (!bytes)
        return {};
    if (isNote(*bytes))
        m_known[path] = *bytes;
    return QString::fromUtf8(*bytes);
}

std::optional<Error> Workspace::saveNote(const QString &taskId, const QString &text)
{
    if (m_folder.isEmpty()) {
        m_notes[taskId] = text;
        return std::nullopt;
    }
    const QString path = notePath(taskId);
    const auto there = readFile(path, noteBytes);
    if (m_lookedAt
        || (!m_notes.contains(taskId) && text == QString::fromUtf8(there ? *there : QByteArray())))
        return std::nullopt;
    m_notes[taskId] = text;
    if (wasTakenOver() || m_readOnly)
        return Error{.message = NotesText::tr("another window works on this lab now; this one "
                                              "saves nothing more"),
                     .file = path};
    auto others = keepOthersNote(taskId);
    if (auto error = write(path, text.toUtf8()))
        return error;
    m_notes.erase(taskId);
    return others;
}

/// What another program has made of the note, before it is replaced. \return where it is now
std::optional<Error> Workspace::keepOthersNote(const QString &taskId)
{
    const QString path = notePath(taskId);
    if (!QFile::exists(path))
        return std::nullopt;
    const auto bytes = readFile(path, noteBytes);
    const auto known = m_known.find(path);
    if (bytes && known != m_known.end() && known->second == *bytes)
        return std::nullopt;
    if (bytes && isNote(*bytes) && m_history
        && !m_history->keepNote(taskId, *bytes, m_info.student))
        return Error{.message = NotesText::tr("another program has changed this note; yours "
                                              "stays, and the other is kept in git as "
                                              "refs/cradle/notes/%1")
                                    .arg(taskId),
                     .file = path};
    const auto kept = moveAside(path);
    if (!kept)
        return kept.error();
    return Error{.message = NotesText::tr("this file is no note; it is kept as %1").arg(*kept),
                 .file = path};
}

std::optional<Error> Workspace::keepNote(const QString &taskId)
{
    if (!m_history || m_lookedAt)
        return std::nullopt;
    const auto bytes = readFile(notePath(taskId), noteBytes);
    return bytes ? m_history->keepNote(taskId, *bytes, m_info.student) : std::nullopt;
}

} // namespace cradle
