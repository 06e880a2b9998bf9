// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/file_io.h"
#include "model/json_schema.h"
#include "tasks/script/script_limits.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <utility>

namespace cradle {

namespace {

struct WorkspaceText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

std::optional<Error> write(const QString &path, const QByteArray &text)
{
    auto error = makeFolder(QFileInfo(path).path());
    if (!error)
        error = writeFile(path, text);
    if (!error)
        return std::nullopt;
    return Error{
        .message = WorkspaceText::tr("your program cannot be saved here: %1").arg(error->message),
        .file = path};
}

} // namespace

Workspace::Workspace(QString folder)
    : m_folder(std::move(folder))
{
}

QString Workspace::pathOf(const QString &taskId) const
{
    return m_folder + QStringLiteral("/steps/%1.lua").arg(taskId);
}

std::optional<QString> Workspace::ownText(const QString &taskId) const
{
    if (m_folder.isEmpty()) {
        const auto found = m_texts.find(taskId);
        return found == m_texts.end() ? std::nullopt : std::optional(found->second);
    }
    if (!QFile::exists(pathOf(taskId)))
        return std::nullopt;
    const Result<QByteArray> text = readFile(pathOf(taskId), 4 * limits::sourceBytes);
    return text ? std::optional(QString::fromUtf8(*text)) : std::nullopt;
}

QString Workspace::textOf(const Lab &lab, int index) const
{
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    const std::optional<QString> own = ownText(task.id);
    return own ? *own : startOf(lab, index);
}

QString Workspace::startOf(const Lab &lab, int index) const
{
    for (int before = index - 1; before >= 0; --before) {
        if (const auto text = ownText(lab.tasks[static_cast<std::size_t>(before)].id))
            return *text;
    }
    return lab.tasks[static_cast<std::size_t>(index)].starter;
}

std::optional<Error> Workspace::save(const QString &taskId, const QString &text)
{
    if (m_folder.isEmpty()) {
        m_texts[taskId] = text;
        return std::nullopt;
    }
    if (auto error = write(pathOf(taskId), text.toUtf8()))
        return error;
    return write(m_folder + QStringLiteral("/lab.lua"), text.toUtf8());
}

} // namespace cradle
