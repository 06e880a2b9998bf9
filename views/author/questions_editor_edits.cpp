// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "model/files/expression.h"
#include "model/files/unit.h"
#include "tasks/authoring/free_name.h"
#include "tasks/values/put_values.h"
#include "views/author/form_rows.h"
#include "views/author/question_bounds.h"
#include "views/author/rows_list.h"

#include <QComboBox>

#include <algorithm>

namespace cradle {

// What an author does to the questions.

using namespace questions;

namespace {

using Kind = Question::Kind;

} // namespace

void QuestionsEditor::add()
{
    Question question{.id = {}, .title = tr("A new question"), .text = tr("What is asked?")};
    question.id = freeName(QStringLiteral("question"), [this](const QString &id) {
        return std::any_of(m_questions.begin(), m_questions.end(),
                           [&](const Question &each) { return each.id == id; });
    });
    const int to = at() + 1;
    m_questions.insert(m_questions.begin() + to, question);
    tell({});
    m_list->setCurrentRow(to);
    m_lines[Title]->setFocus();
    m_lines[Title]->selectAll();
}

void QuestionsEditor::remove()
{
    m_texts.forget(m_step + QLatin1Char('/') + current().id);
    m_questions.erase(m_questions.begin() + at());
    tell({});
}

void QuestionsEditor::move(int from, int to)
{
    std::swap(m_questions[static_cast<std::size_t>(from)],
              m_questions[static_cast<std::size_t>(to)]);
    tell({});
    m_list->setCurrentRow(to);
}

/// A kind that needs answers begins with two.
void QuestionsEditor::takeKind()
{
    if (at() < 0)
        return;
    Question &question = current();
    question.kind = kinds[m_kind->currentIndex()];
    if (hasAnswers(question.kind) && question.answers.size() < fewestAnswers)
        question.answers = {tr("The first answer"), tr("The second answer")};
    if (!hasAnswers(question.kind))
        question.answers.clear();
    if (question.kind == Kind::One)
        question.chosen.resize(1, 0);
    else if (question.kind == Kind::Several && question.chosen.empty())
        question.chosen = {0};
    else if (question.kind != Kind::Several)
        question.chosen.clear();
    tell({});
}

/// Takes the text of a line into the question.
/// \return why it cannot be taken; empty if it was
QString QuestionsEditor::takeText(Line line, const QString &text)
{
    Question &question = current();
    const Result<double> number = evaluated(withoutMarks(text), m_values, question.unit);
    bool isPlain = false;
    (void)text.toDouble(&isPlain);
    switch (line) {
    case Title:
        if (text.isEmpty())
            return tr("A title of 1 to 200 characters is right");
        question.title = text;
        break;
    case Id:
        if (const QString fault = faultOfId(text); !fault.isEmpty())
            return fault;
        if (std::any_of(m_questions.begin(), m_questions.end(), [&](const Question &each) {
                return &each != &question && each.id == text;
            }))
            return tr("Another question has this id already");
        question.id = text;
        break;
    case Points:
        // The same for everybody: without values.
        if (const Result<double> points = pointsFrom(text))
            question.points = *points;
        else
            return points.error().message;
        break;
    case Number:
        if (!number)
            return number.error().message;
        question.number = *number;
        question.expression = isPlain ? QString() : text;
        break;
    case Tolerance:
        if (!text.isEmpty() && (!number || *number < 0.0))
            return tr("Tolerance: a number from 0 is right");
        question.tolerance = text.isEmpty() ? 0.0 : *number;
        question.toleranceExpression = isPlain ? QString() : text;
        break;
    case Unit:
        if (!unitFrom(text))
            return tr("%1 is no unit; one like m/s, kg m/s, N s, J, ° or % is right").arg(text);
        question.unit = text;
        break;
    case LineCount:
        break;
    }
    return {};
}

void QuestionsEditor::takeLine(Line line)
{
    if (at() < 0)
        return;
    QLineEdit *edit = m_lines[line];
    const Question before = current();
    const QString value = lines[line].textIn(before);
    const QString reason = takeText(line, edit->text().trimmed());
    m_texts.judge(edit, value, reason);
    if (line == Id && reason.isEmpty())
        m_texts.rename(m_step + QLatin1Char('/') + current().id);
    if (!(current() == before))
        tell(edit->objectName());
}

/// Marks and texts of the answers; one that is emptied stays as it was.
void QuestionsEditor::takeAnswers()
{
    if (at() < 0)
        return;
    Question &question = current();
    const Question before = question;
    std::vector<int> marked;
    for (int i = 0; i < m_answers->count(); ++i) {
        const QString text = m_answers->item(i)->text().trimmed().left(longestAnswer);
        if (!text.isEmpty())
            question.answers[i] = text;
        if (m_answers->item(i)->checkState() == Qt::Checked)
            marked.push_back(i);
    }
    if (question.kind == Kind::One) // the mark moves
        marked.erase(std::remove_if(marked.begin(), marked.end(),
                                    [&](int each) { return isChosen(before, each); }),
                     marked.end());
    if (!marked.empty() && question.kind != Kind::Order)
        question.chosen = marked;
    if (question == before)
        showAnswers();
    else
        tell(QStringLiteral("answers"));
}

void QuestionsEditor::addAnswer()
{
    current().answers.append(tr("Another answer"));
    tell({});
    m_answers->setCurrentRow(m_answers->count() - 1);
    m_answers->setFocus();
    m_answers->editItem(m_answers->currentItem());
}

void QuestionsEditor::removeAnswer()
{
    const int answer = m_answers->currentRow();
    Question &question = current();
    question.answers.removeAt(answer);
    std::vector<int> chosen;
    for (const int each : question.chosen) {
        if (each != answer)
            chosen.push_back(each > answer ? each - 1 : each);
    }
    if (chosen.empty() && question.kind != Kind::Order)
        chosen = {0};
    question.chosen = chosen;
    tell({});
}

void QuestionsEditor::moveAnswer(int from, int to)
{
    Question &question = current();
    question.answers.swapItemsAt(from, to);
    for (int &each : question.chosen)
        each = each == from ? to : each == to ? from : each;
    std::sort(question.chosen.begin(), question.chosen.end());
    tell({});
    m_answers->setCurrentRow(to);
}

} // namespace cradle
