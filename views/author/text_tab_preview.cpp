// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/text_tab.h"

#include "tasks/authoring/lab_edits.h"
#include "tasks/lab/mode.h"
#include "tasks/values/put_values.h"
#include "views/author/markdown_editor.h"
#include "views/choice_box.h"
#include "views/markdown_view.h"
#include "views/task_pane/instructions_pane.h"

#include <functional>
#include <utility>

namespace cradle {

// What a student will see of the text that is written.

namespace {

/// What stands among the instructions: prediction and questions, with \p shown of every text.
Task seenBy(const TaskForm &form, const std::function<QString(const QString &)> &shown)
{
    Task task;
    task.title = shown(form.title);
    task.prediction = form.prediction;
    task.questions = form.questions;
    if (task.prediction) {
        task.prediction->question = shown(task.prediction->question);
        task.prediction->outcome = shown(task.prediction->outcome);
        for (QString &answer : task.prediction->answers)
            answer = shown(answer);
    }
    for (Question &question : task.questions) {
        question.title = shown(question.title);
        question.text = shown(question.text);
        for (QString &answer : question.answers)
            answer = shown(answer);
    }
    return task;
}

} // namespace

void TextTab::showPreview()
{
    const QString folder = m_pictures.follow(m_document.files(), m_document.step());
    const Mode mode = m_mode->currentIndex() == 0 ? Mode::Code : Mode::Explore;
    // Students see numbers where values stand.
    const auto shown =
        [&, values = valuesOf(m_document.files(), m_document.step(), {})](const QString &typed) {
            const Result<QString> put = withNumbers(typed, values);
            return put ? *put : typed;
        };
    const QString text = shown(m_editor->toPlainText());
    m_student->setVisible(part() == Instructions);
    m_preview->setVisible(part() != Instructions);
    if (part() != Instructions) {
        m_preview->setMarkdown(text, QUrl::fromLocalFile(folder));
        return;
    }
    const Result<TaskForm> form = m_document.form();
    Task task = form ? seenBy(*form, shown) : Task();
    task.id = m_document.step();
    task.folder = folder;
    task.instructions = textFor(mode, text);
    if (std::exchange(m_previewed, task.id) == task.id)
        m_student->followTask(task);
    else
        m_student->showTask(task, 0);
}

} // namespace cradle
