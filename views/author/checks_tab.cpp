// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/checks_tab.h"

#include "tasks/authoring/free_name.h"
#include "views/author/check_editor.h"
#include "views/author/check_program.h"
#include "views/author/check_trial.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/boxes.h"
#include "views/icons.h"
#include "views/on_change.h"

#include <QLabel>
#include <QScrollArea>
#include <QSplitter>

#include <algorithm>

namespace cradle {

namespace {

constexpr int listWidth = 270; ///< px

/// \p wish, or with a number, such that no check has it.
QString freeId(const std::vector<CheckForm> &checks, const QString &wish)
{
    return freeName(wish, [&](const QString &id) {
        return std::any_of(checks.begin(), checks.end(),
                           [&](const CheckForm &check) { return check.id == id; });
    });
}

} // namespace

ChecksTab::ChecksTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    keepTranslated(this, &ChecksTab::retranslate);
    wire();
    reload();
}

void ChecksTab::makeLayout()
{
    auto *side = new QWidget(this);
    m_list = new RowsList(
        QStringLiteral("checks"), side,
        {RowsList::Add, RowsList::Duplicate, RowsList::Remove, RowsList::Up, RowsList::Down});
    m_list->wrapRows();
    side->setLayout(m_list->underHeading());

    m_empty = makeMutedText(this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_editor = new CheckEditor(this);
    m_script = new CheckProgram(m_document, this);
    m_splitter = makeSplitter(Qt::Vertical, {m_empty, scrolled(m_editor), m_script}, {});
    m_trial = new CheckTrial(m_document, this);
    auto *right = new QWidget(this);
    layOutColumn(right, {}, 0, {{m_splitter, 1}, m_trial});

    layOutSideBySide(this, {side, right}, {listWidth, 760})->setStretchFactor(1, 1);
}

void ChecksTab::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &ChecksTab::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &ChecksTab::reload);
    connect(&m_document, &AuthorDocument::languageChanged, this, &ChecksTab::reload);
    connect(m_list, &RowsList::currentRowChanged, this, &ChecksTab::showCurrent);
    connect(m_list, &RowsList::addRequested, this, &ChecksTab::addCheck);
    connect(m_list, &RowsList::duplicateRequested, this, &ChecksTab::duplicateCheck);
    connect(m_list, &RowsList::removeRequested, this, &ChecksTab::removeCheck);
    connect(m_list, &RowsList::moveRequested, this, &ChecksTab::move);
    connect(m_editor, &CheckEditor::edited, this, &ChecksTab::takeCheck);
    RefusedTexts &refused = m_editor->refusedTexts();
    connect(&refused, &RefusedTexts::changed, this, &ChecksTab::markRefused);
    connect(&m_document, &AuthorDocument::opened, &refused, &RefusedTexts::clear);
}

void ChecksTab::reload()
{
    const Result<TaskForm> form = m_document.form();
    setEnabled(form.ok());
    m_checks = form ? form->checks : std::vector<CheckForm>();
    const int before = m_shownStep == m_document.step() ? m_list->currentRow() : 0;
    m_shownStep = m_document.step();
    QStringList titles;
    for (const CheckForm &check : m_checks)
        titles.append(check.title.isEmpty() ? check.id : check.title);
    m_list->showRows(titles, before);
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setToolTip(m_checks[static_cast<std::size_t>(i)].id);
    showCurrent();
}

void ChecksTab::showCurrent()
{
    const int at = m_list->currentRow();
    m_empty->setVisible(at < 0);
    m_splitter->widget(1)->setVisible(at >= 0);
    m_editor->setReadOnly(m_document.isReadOnly());
    m_list->enableButtons(!m_document.isReadOnly());
    const CheckForm check = at >= 0 ? m_checks[static_cast<std::size_t>(at)] : CheckForm();
    if (at >= 0)
        m_editor->show(check, m_document.step());
    m_script->showCheck(check);
    m_trial->setVisible(at >= 0);
    m_trial->setCheck(check.id);
    markRefused();
}

/// Marks the checks in which something is typed that is no value.
void ChecksTab::markRefused()
{
    const QStringList refused = m_editor->refusedTexts().subjects();
    for (int i = 0; i < m_list->count() && i < static_cast<int>(m_checks.size()); ++i) {
        const QString subject = m_document.inStep(m_checks[static_cast<std::size_t>(i)].id);
        m_list->item(i)->setIcon(refused.contains(subject) ? icon(u"warning", IconTint::Warning)
                                                           : QIcon());
        if (i == m_list->currentRow())
            m_trial->setRefused(refused.contains(subject));
    }
}

QStringList ChecksTab::refusedChecks() const
{
    return m_editor->refusedTexts().subjects();
}

CodeEditor &ChecksTab::scriptEditor()
{
    return m_script->editor();
}

void ChecksTab::showCheck(const QString &id)
{
    for (int i = 0; i < static_cast<int>(m_checks.size()); ++i) {
        if (m_checks[static_cast<std::size_t>(i)].id == id)
            m_list->setCurrentRow(i);
    }
}

void ChecksTab::setProgram(const QString &file)
{
    m_trial->setProgram(file);
}

void ChecksTab::showScript(const QString &file)
{
    for (const CheckForm &check : m_checks) {
        if (CheckProgram::fileOf(check) == file)
            showCheck(check.id);
    }
}

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
    m_editor->refusedTexts().forget(m_document.inStep(checks[static_cast<std::size_t>(at)].id));
    checks.erase(checks.begin() + at);
    store(tr("Remove a check"), checks, std::min(at, static_cast<int>(checks.size()) - 1));
}

void ChecksTab::move(int from, int to)
{
    std::vector<CheckForm> checks = m_checks;
    std::swap(checks[static_cast<std::size_t>(from)], checks[static_cast<std::size_t>(to)]);
    store(tr("Move a check"), checks, to);
}

void ChecksTab::retranslate()
{
    m_list->setTexts(tr("Checks of the step"),
                     {{RowsList::Add, tr("Add a check")},
                      {RowsList::Duplicate, tr("Duplicate the check")},
                      {RowsList::Remove, tr("Remove the check")},
                      {RowsList::Up, tr("Move the check up")},
                      {RowsList::Down, tr("Move the check down")}},
                     tr("Checks · %1"));
    m_empty->setText(tr("No check yet. Add one with the plus, then say what is right."));
}

} // namespace cradle
