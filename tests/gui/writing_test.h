// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/author_window.h"
#include "tasks/authoring/lab_edits.h"
#include "tests/gui/open_author.h"
#include "tests/gui/story_programs.h"
#include "tests/gui/typed_cell.h"
#include "tests/patience.h"

#include <memory>

namespace cradle::windows {

inline QString utf8(const char *text)
{
    return QString::fromUtf8(text);
}

/// A test in which an author writes by widgets, as authors do.
class WritingTest : public QObject
{
protected:
    /// Sets id, title, commit and instructions of the open step, and one hint less to think of.
    void retitle(const char *id, const char *title, const char *text)
    {
        m_author->window.panes().showTab(AuthorWindow::Text);
        m_author->fill("stepId", utf8(id));
        QCOMPARE(m_author->document().step(), utf8(id));
        m_author->fill("stepTitle", utf8(title));
        m_author->fill("stepCommit", utf8(title));
        auto *parts = m_author->find<QComboBox>("textPart");
        parts->setCurrentIndex(0);
        auto *editor = m_author->find<MarkdownEditor>("markdown");
        editor->setFocus();
        editor->selectAll();
        editor->insertPlainText(utf8(text)); // as from the clipboard
        QCOMPARE(textOf(m_author->files(), utf8(id) + QStringLiteral("/instructions.md")),
                 utf8(text));
    }

    void addStep(const char *title)
    {
        m_author->choose(QStringLiteral("Add"));
        m_author->typeInPlace(m_author->find<QListWidget>("authorSteps"), utf8(title));
    }

    /// Replaces the text of one of the step's own programs.
    void makeOwn(const char *program, const char *text)
    {
        m_author->window.panes().showTab(AuthorWindow::Programs);
        m_author->window.programsTab().openProgram(utf8(program));
        retype(m_author->window.programsTab().editor(), utf8(text));
        QCOMPARE(textOf(m_author->files(),
                        m_author->document().step() + QLatin1Char('/') + utf8(program)),
                 utf8(text));
    }

    /// The template's mistake is about gravity.
    void removePrograms()
    {
        m_author->window.panes().showTab(AuthorWindow::Programs);
        m_author->window.programsTab().openProgram(QStringLiteral("mistakes/upward.lua"));
        m_author->click(QStringLiteral("Remove the program"));
        QVERIFY(knownNames(m_author->files(), m_author->document().step(), KnownKind::Mistake)
                    .isEmpty());
    }

    void addMistake(const char *name, const story::Mistake &mistake)
    {
        ProgramsTab &programs = m_author->window.programsTab();
        programs.addMistake(); // an entry of the menu of the plus
        auto *list = programs.findChild<QListWidget *>();
        m_author->typeInPlace(list, utf8(name));
        QCOMPARE(programs.program(), QStringLiteral("mistakes/%1.lua").arg(utf8(name)));
        const QString solution = textOf(m_author->files(), m_author->document().step()
                                                               + QStringLiteral("/solution.lua"));
        QVERIFY2(solution.count(utf8(mistake.right)) == 1, name);
        retype(programs.editor(),
               utf8(mistake.comment) + QLatin1Char('\n')
                   + QString(solution).replace(utf8(mistake.right), utf8(mistake.wrong)));
    }

    void addCircle() { m_author->click(QStringLiteral("Add circle")); }

    void typeCell(int row, int column, const char *text)
    {
        typeIntoCell(m_author->window.sceneTab().findChild<QTableView *>(), row, column,
                     utf8(text));
    }

    void beginCheck(const char *id, const char *title, const char *kind, const char *circles)
    {
        m_author->window.panes().showTab(AuthorWindow::Checks);
        m_author->click(QStringLiteral("Add a check"));
        m_author->fill("checkId", utf8(id));
        m_author->fill("checkTitle", utf8(title));
        m_author->pick("checkKind", utf8(kind));
        m_author->fill("checkCircles", utf8(circles));
    }

    void writeScript(const char *script)
    {
        CodeEditor &editor = m_author->window.checksTab().scriptEditor();
        QTRY_VERIFY(editor.isVisible());
        retype(editor, utf8(script));
        QCOMPARE(editor.errorLine(), 0);
    }

    /// No scene with laws alone passes the checks of this lab.
    void removeSceneThatPasses()
    {
        m_author->window.panes().showTab(AuthorWindow::Scene);
        m_author->window.sceneTab().openSolution();
        m_author->click(QStringLiteral("Remove this scene"));
        m_author->window.sceneTab().openStart();
    }

    std::unique_ptr<OpenAuthor> m_author;
};

} // namespace cradle::windows
