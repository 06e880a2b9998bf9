// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/authoring/free_name.h"
#include "views/author/check_program.h"
#include "views/author/checks_tab.h"

#include <QListWidget>

#include <algorithm>

namespace cradle {

namespace {

/// \p wish, or with a number, such that no check has it.
QString freeId(const std::vector<CheckForm> &checks, const QString &wish)
{
    return freeName(wish, [&](const QString &id) {
        return std::any_of(checks.begin(), checks.end(),
                           [&](const CheckForm &check) { return check.id == id; });
    });
}

} // namespace

void ChecksTab::store(const QString &text, const std::vector<CheckForm> &checks, int current,
                      const QString &mergeKey, const std::optional<LabFiles> &base)
{
    const LabFiles files = base.value_or(m_document.files());
    Result<TaskForm> form = taskForm(files, m_document.step(), m_document.language());
    if (!form)
        return;
    form->checks = checks;
    const bool done = m_document.edit(
        text, withTask(files, m_document.step(), *form, m_document.language()), mergeKey);
    if (!done)
        reload();
    else if (current >= 0)
        m_list->setCurrentRow(current);
}

void ChecksTab::takeCheck(const CheckForm &check, const QString &field)
{
    const int at = m_list->currentRow();
    if (at < 0)
        return;
    std::vector<CheckForm> checks = m_checks;
    checks[static_cast<std::size_t>(at)] = check;
    if (field == QLatin1String("kind") && check.kind == QLatin1String("script")) {
        beginScript(checks, at);
        return;
    }
    store(tr("Edit a check"), checks, at,
          QStringLiteral("check:%1:%2:%3").arg(m_document.step()).arg(at).arg(field));
}

void ChecksTab::beginScript(std::vector<CheckForm> checks, int at)
{
    const LabFiles files = CheckProgram::begin(m_document.files(), m_document.step(),
                                               checks[static_cast<std::size_t>(at)]);
    store(tr("Edit a check"), checks, at, {}, files);
}

void ChecksTab::addCheck()
{
    std::vector<CheckForm> checks = m_checks;
    CheckForm check;
    check.kind = QStringLiteral("start");
    check.id = freeId(checks, QStringLiteral("check"));
    check.title = tr("New check");
    check.scene = {{QStringLiteral("kind"), QStringLiteral("own")}};
    const int at = m_list->currentRow() + 1;
    checks.insert(checks.begin() + at, check);
    store(tr("Add a check"), checks, at);
}

void ChecksTab::duplicateCheck()
{
    const int at = m_list->currentRow();
    if (at < 0)
        return;
    std::vector<CheckForm> checks = m_checks;
    CheckForm copy = checks[static_cast<std::size_t>(at)];
    copy.id = freeId(checks, copy.id);
    // A program of its own, too: else an edit of the copy would change the other check.
    const LabFiles files = CheckProgram::copied(m_document.files(), m_document.step(), copy);
    checks.insert(checks.begin() + at + 1, copy);
    store(tr("Duplicate a check"), checks, at + 1, {}, files);
}

void ChecksTab::removeCheck()
{
    const int at = m_list->currentRow();
    if (at < 0)
        return;
    std::vector<CheckForm> checks = m_checks;
    checks.erase(checks.begin() + at);
    store(tr("Remove a check"), checks, std::min(at, static_cast<int>(checks.size()) - 1));
}

void ChecksTab::move(int by)
{
    const int at = m_list->currentRow();
    const int to = at + by;
    if (m_document.isReadOnly() || at < 0 || to < 0 || to >= m_list->count())
        return;
    std::vector<CheckForm> checks = m_checks;
    std::swap(checks[static_cast<std::size_t>(at)], checks[static_cast<std::size_t>(to)]);
    store(tr("Move a check"), checks, to);
}

} // namespace cradle
