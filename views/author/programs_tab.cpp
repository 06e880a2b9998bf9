// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/programs_tab.h"

#include "tasks/authoring/free_name.h"
#include "views/author/form_rows.h"
#include "views/author/other_mistakes_menu.h"
#include "views/author/program_files.h"
#include "views/author/program_page.h"
#include "views/author/remark_editor.h"
#include "views/author/rows_list.h"
#include "views/code/code_editor.h"
#include "views/icons.h"
#include "views/menu.h"
#include "views/on_change.h"

#include <QBoxLayout>
#include <QSplitter>
#include <QToolButton>

#include <utility>

namespace cradle {

namespace {

constexpr int fileRole = Qt::UserRole;
constexpr int programsWidth = 230; ///< px

} // namespace

ProgramsTab::ProgramsTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    keepTranslated(this, &ProgramsTab::retranslate);
    wire();
    reload();
}

void ProgramsTab::makeLayout()
{
    auto *side = new QWidget(this);
    m_list = new RowsList(QStringLiteral("programs"), side,
                          {RowsList::Add, RowsList::Rename, RowsList::Remove});
    m_list->setIconSize(iconSquare(14));
    m_list->setEditTriggers(QAbstractItemView::DoubleClicked);
    QToolButton *add = m_list->button(RowsList::Add);
    m_addMenu = new Menu(add);
    m_otherMenu = new OtherMistakesMenu(m_document, m_addMenu);
    add->setMenu(m_addMenu);
    add->setPopupMode(QToolButton::InstantPopup);
    side->setLayout(m_list->underHeading());
    m_page = new ProgramPage(m_document, this);

    layOutSideBySide(this, {side, m_page}, {programsWidth, 800})->setStretchFactor(1, 1);
}

void ProgramsTab::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &ProgramsTab::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &ProgramsTab::reload);
    connect(&m_document, &AuthorDocument::languageChanged, this, &ProgramsTab::reload);
    connect(&m_document, &AuthorDocument::opened, &m_page->remark().refusedTexts(),
            &RefusedTexts::clear);
    connect(m_list, &RowsList::currentRowChanged, this, [this](int row) {
        if (m_loading || row < 0)
            return;
        m_program = m_list->item(row)->data(fileRole).toString();
        showProgram();
    });
    connect(m_list, &RowsList::itemChanged, this, &ProgramsTab::takeName);
    connect(m_list, &RowsList::renameRequested, this, &ProgramsTab::renameProgram);
    connect(m_list, &RowsList::removeRequested, this, &ProgramsTab::removeProgram);
    connect(m_addMenu, &QMenu::aboutToShow, m_otherMenu, &OtherMistakesMenu::fill);
    connect(m_otherMenu, &OtherMistakesMenu::chosen, this, &ProgramsTab::takeOver);
}

void ProgramsTab::reload()
{
    setEnabled(!m_document.step().isEmpty());
    fillList();
    showProgram();
}

void ProgramsTab::fillList()
{
    const LabFiles &files = m_document.files();
    const QString &step = m_document.step();
    const auto isThere = [&](const QString &file) {
        return files.contents.contains(m_document.inStep(file));
    };
    QStringList programs{QStringLiteral("starter.lua")};
    for (const QString &language : languagesOf(files).mid(1)) {
        const QString translated = QStringLiteral("starter.%1.lua").arg(language);
        if (isThere(programs.front()) || isThere(translated))
            programs.append(translated);
    }
    programs.append(QStringLiteral("solution.lua"));
    programs.append(knownPrograms(files, step));
    if (!programs.contains(m_program))
        m_program = QStringLiteral("solution.lua");
    m_loading = true;
    const QString listed = step + programs.join(QLatin1Char('\n'));
    if (listed != m_listed) {
        m_listed = listed;
        m_list->clear();
        for (const QString &program : programs) {
            auto *item =
                new QListWidgetItem(kindOfProgram(program) ? nameOfProgram(program) : program);
            item->setData(fileRole, program);
            item->setToolTip(program);
            if (kindOfProgram(program))
                item->setFlags(item->flags() | Qt::ItemIsEditable);
            const bool remark = kindOfProgram(program) == KnownKind::Remark;
            if (kindOfProgram(program))
                item->setIcon(remark ? icon(u"hint", IconTint::Accent)
                                     : icon(u"failed", IconTint::Warning));
            m_list->addItem(item);
        }
    }
    m_list->setCurrentRow(static_cast<int>(programs.indexOf(m_program)));
    m_loading = false;
}

void ProgramsTab::showProgram()
{
    const bool writable = !m_document.isReadOnly();
    const bool known = kindOfProgram(m_program).has_value();
    const bool there = m_document.files().contents.contains(path());
    m_list->enableButtons(writable);
    m_list->button(RowsList::Rename)->setEnabled(writable && known);
    m_list->button(RowsList::Remove)->setEnabled(writable && (known || there));
    m_page->showProgram(m_program);
}

QString ProgramsTab::path() const
{
    return m_document.inStep(m_program);
}

QStringList ProgramsTab::refusedRemarks() const
{
    return m_page->remark().refusedTexts().subjects();
}

CodeEditor &ProgramsTab::editor()
{
    return m_page->editor();
}

void ProgramsTab::addMistake()
{
    addKnown(KnownKind::Mistake);
}

void ProgramsTab::addRemark()
{
    addKnown(KnownKind::Remark);
}

void ProgramsTab::addKnown(KnownKind kind)
{
    const LabFiles &files = m_document.files();
    const bool mistake = kind == KnownKind::Mistake;
    const QStringList taken = knownNames(files, m_document.step(), kind);
    const QString name = freeName(mistake ? QStringLiteral("mistake") : QStringLiteral("remark"),
                                  [&](const QString &each) { return taken.contains(each); });
    const QString comment =
        mistake ? tr("-- What went wrong, in a few words\n--\n-- What was observed, what it means, "
                     "and where to look.\n")
                : tr("-- What is good about it, in a few words\n--\n-- What it does otherwise than "
                     "most, and what that is worth.\n");
    const QString solution = textOf(files, m_document.inStep(QStringLiteral("solution.lua")));
    m_program = fileOfProgram(kind, name);
    if (m_document.edit(mistake ? tr("Add a mistake") : tr("Add a remark"),
                        withKnownAdded(files, m_document.step(), kind, name,
                                       comment + QLatin1Char('\n') + solution)))
        renameProgram();
}

void ProgramsTab::takeOver(const OtherMistake &mistake)
{
    const QString before =
        std::exchange(m_program, fileOfProgram(KnownKind::Mistake, mistake.name));
    if (!m_document.edit(tr("Take over a mistake"),
                         withOtherMistake(m_document.files(), m_document.step(), mistake)))
        m_program = before;
}

void ProgramsTab::removeProgram()
{
    const auto kind = kindOfProgram(m_program);
    const QString name = nameOfProgram(m_program);
    if (kind == KnownKind::Remark)
        m_page->remark().refusedTexts().forget(m_document.inStep(name));
    if (kind)
        m_document.edit(tr("Remove a program"),
                        withKnownRemoved(m_document.files(), m_document.step(), *kind, name));
    else
        m_document.edit(tr("Remove a program"), withoutFile(m_document.files(), path()));
}

void ProgramsTab::renameProgram()
{
    QListWidgetItem *item = m_list->currentItem();
    if (!item || m_document.isReadOnly() || !kindOfProgram(m_program))
        return;
    m_list->setFocus();
    m_list->editItem(item);
}

void ProgramsTab::takeName(QListWidgetItem *item)
{
    const QString file = item->data(fileRole).toString();
    const auto kind = kindOfProgram(file);
    const QString name = item->text().trimmed();
    if (m_loading || !kind || name == nameOfProgram(file))
        return;
    // Queued: the list is filled anew by the edit, and its editor is still at work.
    QMetaObject::invokeMethod(
        this, [this, file, name] { renameTo(file, name); }, Qt::QueuedConnection);
}

void ProgramsTab::renameTo(const QString &file, const QString &name)
{
    const auto kind = kindOfProgram(file);
    const Result<LabFiles> renamed =
        withKnownRenamed(m_document.files(), m_document.step(), *kind, nameOfProgram(file), name);
    if (renamed && m_program == file) {
        m_program = fileOfProgram(*kind, name);
        if (kind == KnownKind::Remark)
            m_page->remark().refusedTexts().rename(m_document.inStep(name));
    }
    m_listed.clear();
    if (!m_document.edit(tr("Rename a program"), renamed))
        reload();
}

void ProgramsTab::openProgram(const QString &file, int line)
{
    m_program = file;
    reload();
    if (line > 0)
        editor().goToLine(line);
    editor().setFocus();
}

void ProgramsTab::openRemark(const QString &name)
{
    m_program = fileOfProgram(KnownKind::Remark, name);
    reload();
    m_page->showRecognition();
}

void ProgramsTab::retranslate()
{
    m_list->setTexts(tr("Programs of the step"),
                     {{RowsList::Add, tr("Add a program")},
                      {RowsList::Rename, tr("Rename the program")},
                      {RowsList::Remove, tr("Remove the program")}},
                     tr("Programs"));
    m_addMenu->clear();
    m_addMenu->addAction(tr("A &mistake that students make"), this, &ProgramsTab::addMistake);
    m_addMenu->addAction(tr("A &remark on work that passes"), this, &ProgramsTab::addRemark);
    m_otherMenu->retranslate();
    m_addMenu->setToolTipsVisible(true);
    m_addMenu->addMenu(m_otherMenu);
}

} // namespace cradle
