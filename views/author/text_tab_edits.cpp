// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/text_tab.h"

#include "tasks/authoring/lab_edits.h"
#include "views/author/hints_list.h"
#include "views/author/markdown_editor.h"
#include "views/author/questions_editor.h"
#include "views/author/values_editor.h"
#include "views/choice_box.h"

namespace cradle {

// What is written in the tab, and where it goes.

void TextTab::takeText(const QString &text)
{
    if (m_loading)
        return;
    m_previewTimer.start();
    if (part() == Instructions) {
        m_document.edit(tr("Edit the text"), withText(m_document.files(), path(), text),
                        QStringLiteral("text:") + path());
        return;
    }
    const int hint = m_hints->current();
    QStringList hints = m_shownHints;
    if (hint < 0 || hint >= hints.size())
        return;
    hints[hint] = text;
    editHints(tr("Edit a hint"), hints,
              QStringLiteral("hint:%1:%2:%3").arg(m_document.step()).arg(int{part()}).arg(hint));
}

void TextTab::takeHints(const QStringList &hints, int current)
{
    editHints(tr("Change the hints"), hints, {});
    m_hints->setCurrent(current);
    m_editor->setFocus();
}

void TextTab::editHints(const QString &text, const QStringList &hints, const QString &mergeKey)
{
    const auto change = [&](TaskForm &form) {
        (part() == CodeHints ? form.codeHints : form.hints) = hints;
    };
    m_document.editTask(text, change, mergeKey);
}

void TextTab::takePrediction(const std::optional<Prediction> &prediction, const QString &field)
{
    const QString key = QStringLiteral("prediction:%1:%2").arg(m_document.step(), field);
    if (!m_document.editTask(
            tr("Edit the prediction"), [&](TaskForm &form) { form.prediction = prediction; },
            field.isEmpty() ? QString() : key))
        reload();
}

void TextTab::takeQuestions(const std::vector<Question> &questions, const QString &field)
{
    const QString key = QStringLiteral("questions:%1:%2").arg(m_document.step(), field);
    if (!m_document.editTask(
            tr("Edit the questions"), [&](TaskForm &form) { form.questions = questions; },
            field.isEmpty() ? QString() : key))
        reload();
}

void TextTab::open(Part part)
{
    m_part->setCurrentIndex(part);
    if (part == ValuesPart)
        m_values->setFocus();
}

void TextTab::openHint(bool ofProgram, int hint)
{
    open(ofProgram ? CodeHints : Hints);
    m_hints->setCurrent(hint);
    m_editor->setFocus();
}

void TextTab::openLine(int line)
{
    open(Instructions);
    m_editor->goToLine(line);
}

void TextTab::openValue(const QString &step, const QString &name)
{
    open(ValuesPart);
    m_values->showValue(step, name);
}

QStringList TextTab::refused() const
{
    return m_values->refused() + m_questions->refusedTexts().subjects();
}

void TextTab::insertFigure(const QString &name, const QString &description)
{
    open(Instructions);
    m_editor->insertParagraph(QStringLiteral("![%1](%2)").arg(description, name));
    m_editor->setFocus();
}

} // namespace cradle
