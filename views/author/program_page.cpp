// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/program_page.h"

#include "tasks/script/student_script.h"
#include "tasks/text/line_diff.h"
#include "tasks/text/program_diff.h"
#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/program_files.h"
#include "views/author/remark_editor.h"
#include "views/author/text_languages.h"
#include "views/boxes.h"
#include "views/code/code_editor.h"
#include "views/fitted_tabs.h"
#include "views/markdown_view.h"
#include "views/on_change.h"

#include <QLabel>
#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>

namespace cradle {

namespace {

enum Below { Message, Recognition }; // the tabs below a program

} // namespace

ProgramPage::ProgramPage(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    keepTranslated(this, &ProgramPage::retranslate);
    connect(m_editor, &CodeEditor::textEdited, this, &ProgramPage::takeSource);
    connect(m_translation, &MarkdownEditor::edited, this, &ProgramPage::takeTranslation);
    connect(m_remark, &RemarkEditor::edited, this, &ProgramPage::takeRemark);
}

void ProgramPage::makeLayout()
{
    m_note = makeMutedText(this);
    m_note->setContentsMargins(12, 8, 12, 6);
    m_editor = new CodeEditor(this);
    m_below = new QTabWidget(this);
    m_below->setObjectName(QStringLiteral("belowProgram"));
    m_below->setDocumentMode(true);
    m_below->addTab(makeMessage(), QString());
    m_below->addTab(makeRecognition(), QString());
    new FittedTabs(*m_below->tabBar());
    QSplitter *splitter = makeSplitter(Qt::Vertical, {m_editor, m_below}, {340, 250});
    splitter->setStretchFactor(0, 1);
    layOutColumn(this, {}, 0, {m_note, {splitter, 1}});
}

QWidget *ProgramPage::makeMessage()
{
    auto *page = new QWidget(m_below);
    m_messageNote = makeMutedText(page);
    m_messageNote->setContentsMargins(12, 6, 12, 2);
    m_translation = new MarkdownEditor(page);
    m_translation->setObjectName(QStringLiteral("translation"));
    m_message = new MarkdownView(page);
    auto *texts = makeRow({}, 0, {{m_translation, 1}, {m_message, 1}});
    layOutColumn(page, {}, 0, {m_messageNote, {texts, 1}});
    return page;
}

QWidget *ProgramPage::makeRecognition()
{
    m_remark = new RemarkEditor(m_below);
    return scrolled(m_remark);
}

QString ProgramPage::path() const
{
    return m_document.inStep(m_program);
}

bool ProgramPage::isTranslation() const
{
    const Result<LabForm> form = labForm(m_document.files());
    return form && form->language != m_document.language();
}

void ProgramPage::showProgram(const QString &program)
{
    m_program = program;
    const LabFiles &files = m_document.files();
    const Result<QString> whole = programText(files, path());
    m_applies = whole.ok();
    const QString text = whole ? *whole : textOf(files, diffPathOf(path()));
    m_editor->setReadOnly(false); // a read-only area takes no text at all
    // Blanks that are being typed stay, though a difference keeps none at the end of a comment.
    const bool typed = m_applies && withProgramText(files, path(), m_editor->text()) == files;
    if (m_shownPath != path())
        m_editor->setText(text);
    else if (!typed)
        m_editor->replaceText(text);
    m_editor->setReadOnly(m_document.isReadOnly());
    m_editor->setAccessibleName(tr("Program %1").arg(m_program));
    const bool another = m_shownPath != path();
    m_shownPath = path();
    m_fault = whole ? Error{} : whole.error();
    checkSyntax();
    const int first = markDifference();
    if (another && first > 0)
        m_editor->revealLine(first);
    const auto kind = kindOfProgram(m_program);
    m_below->setVisible(kind.has_value());
    m_below->setTabVisible(Recognition, kind == KnownKind::Remark);
    showNote();
    showMessage();
    showRemark();
}

void ProgramPage::showRecognition()
{
    m_below->setCurrentIndex(Recognition);
}

void ProgramPage::showNote()
{
    const bool there = m_document.files().contents.contains(path());
    if (m_program == QLatin1String("starter.lua"))
        m_note->setText(there ? tr("What a student's program starts from in this step.")
                              : tr("None of its own: students go on from the solution of the step "
                                   "before. Write here to start from something else."));
    else if (m_program.startsWith(QLatin1String("starter.")))
        m_note->setText(tr("The starter for students who read %1: the same code, with comments in "
                           "that language. Without it they get starter.lua.")
                            .arg(languageWithCode(m_program.section(QLatin1Char('.'), 1, 1))));
    else if (m_program == QLatin1String("solution.lua"))
        m_note->setText(tr("The reference: it should pass every check, with every seed."));
    else if (!m_applies)
        m_note->setText(tr("The solution was changed where this difference changes it. Mend the "
                           "lines after @@ so that they say what stands in the solution now, and "
                           "what stands here instead."));
    else if (kindOfProgram(m_program) == KnownKind::Mistake)
        m_note->setText(tr("A whole program with one mistake: it fails by a check, and who wrote "
                           "the same reads the comment that it begins with.")
                        + differenceNote());
    else
        m_note->setText(tr("A whole program that passes and deserves a word.") + differenceNote());
}

QString ProgramPage::differenceNote() const
{
    return isDiff(m_document.files(), path())
               ? QLatin1Char(' ')
                     + tr("It is kept as its difference from the solution, which is marked, and "
                          "follows it.")
               : QString();
}

/// Marks the lines in which a mistake or remark is not the solution.
/// \return the first of them; 0 if there is none
int ProgramPage::markDifference()
{
    std::vector<int> lines;
    if (kindOfProgram(m_program) && m_applies) {
        const QString solution =
            textOf(m_document.files(), m_document.inStep(QStringLiteral("solution.lua")));
        const auto comment =
            static_cast<int>(firstCommentBlock(m_editor->text()).count(QLatin1Char('\n')) + 2);
        for (const DiffLine &line : lineDiff(solution, m_editor->text())) {
            if (line.kind == DiffLine::Kind::Added && line.after > comment)
                lines.push_back(line.after);
        }
    }
    m_editor->setChanged(lines);
    return lines.empty() ? 0 : lines.front();
}

void ProgramPage::checkSyntax()
{
    if (!m_applies) {
        m_editor->setError(m_fault.line, m_fault.message);
        return;
    }
    const auto error = findSyntaxError(m_editor->text());
    if (error)
        m_editor->setError(error->line, error->message);
    else
        m_editor->clearError();
}

void ProgramPage::showMessage()
{
    const auto kind = kindOfProgram(m_program);
    if (!kind)
        return;
    const Result<QString> whole = programText(m_document.files(), path());
    QString message = whole ? firstCommentBlock(*whole) : QString();
    m_translation->setVisible(isTranslation());
    m_translation->setReadOnly(m_document.isReadOnly());
    if (isTranslation()) {
        const QString own = knownText(m_document.files(), m_document.step(), *kind,
                                      nameOfProgram(m_program), m_document.language());
        m_translation->showText(own);
        m_translation->setPlaceholderText(message);
        if (!own.isEmpty())
            message = own;
    }
    // The first line is the headline, as in the result.
    const QString headline = message.section(QLatin1Char('\n'), 0, 0);
    m_message->setMarkdown(
        QStringLiteral("**%1**\n%2").arg(headline, message.section(QLatin1Char('\n'), 1)), {});
}

void ProgramPage::showRemark()
{
    const Result<TaskForm> form = m_document.form();
    for (std::size_t i = 0; form && i < form->remarks.size(); ++i) {
        if (fileOfProgram(KnownKind::Remark, form->remarks[i].id) == m_program)
            m_remark->show(form->remarks[i], m_document.step());
    }
    m_remark->setReadOnly(m_document.isReadOnly());
}

void ProgramPage::takeSource()
{
    const LabFiles &files = m_document.files();
    const QString text = m_editor->text();
    m_document.edit(tr("Edit a program"),
                    m_applies ? withProgramText(files, path(), text)
                              : withText(files, diffPathOf(path()), text),
                    QStringLiteral("program:") + path());
    checkSyntax();
    markDifference();
}

void ProgramPage::takeTranslation(const QString &text)
{
    if (const auto kind = kindOfProgram(m_program))
        m_document.edit(tr("Edit what the student reads"),
                        withKnownText(m_document.files(), m_document.step(), *kind,
                                      nameOfProgram(m_program), m_document.language(), text),
                        QStringLiteral("message:") + path());
}

void ProgramPage::takeRemark(const RemarkForm &remark, const QString &field)
{
    const auto take = [&](TaskForm &form) {
        for (RemarkForm &each : form.remarks) {
            if (each.id == remark.id)
                each = remark;
        }
    };
    if (!m_document.editTask(tr("Edit a remark"), take,
                             QStringLiteral("remark:%1:%2").arg(path(), field)))
        showRemark();
}

void ProgramPage::retranslate()
{
    m_below->setTabText(Message, tr("What the student reads"));
    m_below->setTabText(Recognition, tr("How it is recognised"));
    m_below->setAccessibleName(tr("About the program"));
    m_messageNote->setText(tr("The comment that the program begins with, or its translation"));
    m_translation->setAccessibleName(tr("What the student reads, translated"));
    m_message->setAccessibleName(tr("What the student reads"));
    showNote();
}

} // namespace cradle
