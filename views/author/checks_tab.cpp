// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/checks_tab.h"

#include "views/author/check_editor.h"
#include "views/author/check_program.h"
#include "views/author/check_trial.h"
#include "views/author/form_rows.h"
#include "views/author/rows_list.h"
#include "views/author/tool_buttons.h"
#include "views/icons.h"
#include "views/on_change.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QScrollArea>
#include <QSplitter>
#include <QToolButton>

namespace cradle {

namespace {

constexpr int listWidth = 270; ///< px

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
    m_heading = makeHeading(this);
    auto *side = new QWidget(this);
    m_list = makeRowsList(QStringLiteral("checks"), side);
    wrapRows(m_list);
    m_add = makeIconButton(QStringLiteral("add"), this);
    m_duplicate = makeIconButton(QStringLiteral("duplicate"), this);
    m_remove = makeIconButton(QStringLiteral("remove"), this);
    m_up = makeIconButton(QStringLiteral("up"), this);
    m_down = makeIconButton(QStringLiteral("down"), this);
    side->setLayout(
        makeRowsColumn(m_heading, {m_up, m_down, m_add, m_duplicate, m_remove}, m_list));
    setRowKeys(m_list, {.up = m_up, .down = m_down, .remove = m_remove, .rename = {}});

    m_empty = makeMutedText(this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_editor = new CheckEditor(this);
    m_script = new CheckProgram(m_document, this);
    m_splitter = new QSplitter(Qt::Vertical, this);
    m_splitter->addWidget(m_empty);
    m_splitter->addWidget(scrolled(m_editor));
    m_splitter->addWidget(m_script);
    m_splitter->setChildrenCollapsible(false);
    m_trial = new CheckTrial(m_document, this);
    auto *right = new QWidget(this);
    auto *column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_splitter, 1);
    column->addWidget(m_trial);

    layOutSideBySide(this, {side, right}, {listWidth, 760})->setStretchFactor(1, 1);
}

void ChecksTab::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &ChecksTab::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &ChecksTab::reload);
    connect(&m_document, &AuthorDocument::languageChanged, this, &ChecksTab::reload);
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        if (!m_loading)
            showCurrent();
    });
    connect(m_editor, &CheckEditor::edited, this, &ChecksTab::takeCheck);
    connect(m_editor, &CheckEditor::refusalsChanged, this, &ChecksTab::markRefused);
    connect(&m_document, &AuthorDocument::opened, m_editor, &CheckEditor::forgetTexts);
    connect(m_add, &QToolButton::clicked, this, &ChecksTab::addCheck);
    connect(m_duplicate, &QToolButton::clicked, this, &ChecksTab::duplicateCheck);
    connect(m_remove, &QToolButton::clicked, this, &ChecksTab::removeCheck);
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
}

void ChecksTab::reload()
{
    const Result<TaskForm> form =
        taskForm(m_document.files(), m_document.step(), m_document.language());
    setEnabled(form.ok());
    m_checks = form ? form->checks : std::vector<CheckForm>();
    const int before = m_shownStep == m_document.step() ? m_list->currentRow() : 0;
    m_shownStep = m_document.step();
    m_loading = true;
    setRowCount(m_list, static_cast<int>(m_checks.size()));
    for (int i = 0; i < m_list->count(); ++i) {
        const CheckForm &check = m_checks[static_cast<std::size_t>(i)];
        m_list->item(i)->setText(check.title.isEmpty() ? check.id : check.title);
        m_list->item(i)->setToolTip(check.id);
    }
    m_list->doItemsLayout(); // a title may take another number of lines now
    chooseRow(m_list, before);
    m_loading = false;
    m_heading->setText(tr("Checks · %1").arg(m_list->count()));
    showCurrent();
}

void ChecksTab::showCurrent()
{
    const int at = m_list->currentRow();
    const bool writable = !m_document.isReadOnly();
    m_empty->setVisible(at < 0);
    m_splitter->widget(1)->setVisible(at >= 0);
    m_editor->setReadOnly(!writable);
    m_add->setEnabled(writable);
    m_duplicate->setEnabled(writable && at >= 0);
    m_remove->setEnabled(writable && at >= 0);
    m_up->setEnabled(writable && at > 0);
    m_down->setEnabled(writable && at >= 0 && at + 1 < m_list->count());
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
        const QString subject =
            m_document.step() + QLatin1Char('/') + m_checks[static_cast<std::size_t>(i)].id;
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

void ChecksTab::retranslate()
{
    m_heading->setText(tr("Checks · %1").arg(m_list->count()));
    m_list->setAccessibleName(tr("Checks of the step"));
    m_empty->setText(tr("No check yet. Add one with the plus, then say what is right."));
    nameButton(m_add, tr("Add a check"));
    nameButton(m_duplicate, tr("Duplicate the check"));
    nameButton(m_remove, tr("Remove the check"), tr("Delete"));
    nameButton(m_up, tr("Move the check up"), tr("Alt+Up"));
    nameButton(m_down, tr("Move the check down"), tr("Alt+Down"));
}

} // namespace cradle
