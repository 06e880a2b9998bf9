// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/workspace/workspace.h"

#include "model/files/file_io.h"
#include "model/files/json_schema.h"
#include "tasks/script/program_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace cradle {

namespace {

struct WorkspaceText {
    Q_DECLARE_TR_FUNCTIONS(Workspace)
};

constexpr qint64 mostBytes = 64 * 1024 * 1024; ///< of a file that is no program, to be compared

std::optional<QByteArray> contentOf(const QString &path)
{
    if (!QFile::exists(path))
        return std::nullopt;
    const auto bytes = readFile(path, mostBytes);
    return bytes ? std::optional(*bytes) : std::nullopt;
}

/// A name beside \p path that nobody has.
QString besideOf(const QString &path)
{
    QString beside = path + QStringLiteral(".original");
    for (int number = 2; QFile::exists(beside); ++number)
        beside = path + QStringLiteral(".original-%1").arg(number);
    return beside;
}

/// The first step of those that build on each other up to \p index: each starts from the solution
/// of one before it.
int beginningOf(const Lab &lab, int index)
{
    for (bool found = true; found;) {
        found = false;
        const QString &starter = lab.tasks[static_cast<std::size_t>(index)].starter;
        for (int before = index - 1; before >= 0 && !found; --before) {
            const QString &solution = lab.tasks[static_cast<std::size_t>(before)].solution;
            found = !solution.isEmpty() && solution == starter;
            if (found)
                index = before;
        }
    }
    return index;
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

QString Workspace::labPath() const
{
    return m_folder + QStringLiteral("/lab.lua");
}

Result<std::optional<QString>> Workspace::ownText(const QString &taskId) const
{
    if (const auto found = m_texts.find(taskId); found != m_texts.end())
        return std::optional(found->second);
    const QString path = pathOf(taskId);
    if (m_folder.isEmpty())
        return std::optional<QString>();
    if (!QFile::exists(path)) {
        m_known.erase(path);
        return std::optional<QString>();
    }
    const auto bytes = readFile(path, mostBytes);
    if (!bytes)
        return bytes.error();
    m_known[path] = *bytes;
    const auto text = programFrom(*bytes, path);
    return text ? Result<std::optional<QString>>(std::optional(*text)) : text.error();
}

Result<QString> Workspace::textOf(const Lab &lab, int index) const
{
    const Task &task = lab.tasks[static_cast<std::size_t>(index)];
    if (!m_folder.isEmpty()) {
        // One that is no program is not known: before it is replaced, it is kept.
        if (const auto bytes = contentOf(labPath()); bytes && programFrom(*bytes, labPath()))
            m_known[labPath()] = *bytes;
    }
    const auto own = ownText(task.id);
    if (!own)
        return own.error();
    return *own ? **own : startOf(lab, index);
}

bool Workspace::has(const QString &taskId) const
{
    return m_texts.contains(taskId) || (!m_folder.isEmpty() && QFile::exists(pathOf(taskId)));
}

QString Workspace::startOf(const Lab &lab, int index) const
{
    for (int before = index - 1; before >= 0; --before) {
        const auto own = ownText(lab.tasks[static_cast<std::size_t>(before)].id);
        if (own && *own)
            return **own;
    }
    return lab.tasks[static_cast<std::size_t>(beginningOf(lab, index))].starter;
}

std::optional<Error> Workspace::write(const QString &path, const QByteArray &text)
{
    auto error = makeFolder(QFileInfo(path).path());
    if (!error)
        error = writeFile(path, text);
    if (!error) {
        m_known[path] = text;
        return std::nullopt;
    }
    return Error{.message =
                     WorkspaceText::tr("your program cannot be saved here: %1").arg(error->message),
                 .file = path};
}

std::optional<Error> Workspace::save(const QString &taskId, const QString &text)
{
    if (m_folder.isEmpty()) {
        m_texts[taskId] = text;
        return std::nullopt;
    }
    if (wasTakenOver())
        (void)keep(taskId, text, {.reason = VersionReason::Unsaved});
    if (m_readOnly)
        return Error{.message = WorkspaceText::tr("another window works on this lab now; this one "
                                                  "saves nothing more, and what was typed last "
                                                  "here is among the versions of the step"),
                     .file = pathOf(taskId)};
    // lab.lua first: the older of the two is never taken for an edit by somebody else.
    auto error = write(labPath(), text.toUtf8());
    if (!error)
        error = write(pathOf(taskId), text.toUtf8());
    if (error)
        m_texts[taskId] = text;
    else
        m_texts.erase(taskId);
    return error;
}

std::optional<Error> Workspace::saveUnsaved()
{
    const auto texts = m_texts;
    for (const auto &[taskId, text] : texts) {
        if (auto error = save(taskId, text))
            return error;
    }
    const auto notes = m_notes;
    for (const auto &[taskId, text] : notes) {
        if (auto error = saveNote(taskId, text))
            return error;
    }
    return std::nullopt;
}

std::vector<OutsideEdit> Workspace::outsideEdits(const QString &taskId) const
{
    std::vector<OutsideEdit> edits;
    if (m_folder.isEmpty() || m_readOnly)
        return edits;
    for (const QString &path : {pathOf(taskId), labPath()}) {
        const auto known = m_known.find(path);
        const auto now = contentOf(path);
        // A file that is gone is written again with the next key; one that is new is an edit.
        if (!QFile::exists(path) || (now && known != m_known.end() && known->second == *now))
            continue;
        const auto text = now ? programFrom(*now, path) : Result<QString>(Error{});
        edits.push_back({path, text ? std::optional(*text) : std::nullopt});
    }
    std::stable_sort(edits.begin(), edits.end(), [](const auto &a, const auto &b) {
        return QFileInfo(a.path).lastModified() < QFileInfo(b.path).lastModified();
    });
    return edits;
}

Result<QString> Workspace::keepOutside(const QString &taskId, const OutsideEdit &edit)
{
    std::optional<QString> text = edit.text;
    QString beside;
    if (text) {
        m_known[edit.path] = text->toUtf8();
    } else {
        const auto content = contentOf(edit.path);
        text = content ? convertedProgram(*content) : std::nullopt;
        auto moved = moveAside(edit.path);
        if (!moved)
            return moved;
        beside = *moved;
    }
    if (text) {
        if (const auto error = keep(taskId, *text, {.reason = VersionReason::Outside}))
            return *error;
    }
    return beside;
}

/// \return its new name
Result<QString> Workspace::moveAside(const QString &path)
{
    const QString beside = besideOf(path);
    if (!QFile::rename(path, beside))
        return Error{.message = WorkspaceText::tr("the file cannot be moved aside"), .file = path};
    m_known.erase(path);
    return beside;
}

bool Workspace::canConvert(const QString &taskId) const
{
    const auto bytes = contentOf(pathOf(taskId));
    return bytes && convertedProgram(*bytes);
}

std::optional<Error> Workspace::replaceForeign(const Lab &lab, int index, bool convert)
{
    const QString &taskId = lab.tasks[static_cast<std::size_t>(index)].id;
    const QString path = pathOf(taskId);
    const auto bytes = contentOf(path);
    const auto text = bytes && convert ? convertedProgram(*bytes) : std::nullopt;
    if (const auto moved = moveAside(path); !moved)
        return moved.error();
    // lab.lua is replaced with it, and may be another file that is no program.
    if (const auto mirror = contentOf(labPath()); mirror && !programFrom(*mirror, labPath()))
        (void)moveAside(labPath());
    return save(taskId, text ? *text : startOf(lab, index));
}

std::optional<Error> Workspace::saveSaid(const QString &name, const QByteArray &text)
{
    const QString path = m_folder + QLatin1Char('/') + name;
    if (m_folder.isEmpty() || wasTakenOver() || m_readOnly
        || contentOf(path).value_or("{\n}\n") == text)
        return std::nullopt;
    return write(path, text);
}

} // namespace cradle
