// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "model/world/shortest_number.h"
#include "tasks/questions/answers.h"
#include "tasks/questions/question_json.h"
#include "tasks/values/put_values.h"
#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/question_bounds.h"
#include "views/author/rows_list.h"
#include "views/task_pane/questions_card.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>

namespace cradle {

using namespace questions;

namespace {

using Kind = Question::Kind;

/// As the student with those values finds it.
Question withValuesPut(const Question &question, const Values &values)
{
    const Result<QJsonObject> put = taskWithNumbers(jsonFrom(question), values);
    return put ? questionFrom(*put) : question;
}

} // namespace

void QuestionsEditor::wire()
{
    connect(m_list, &RowsList::currentRowChanged, this, &QuestionsEditor::showCurrent);
    connect(m_list, &RowsList::addRequested, this, &QuestionsEditor::add);
    connect(m_list, &RowsList::removeRequested, this, &QuestionsEditor::remove);
    connect(m_list, &RowsList::moveRequested, this, &QuestionsEditor::move);
    connect(m_kind, &QComboBox::activated, this, &QuestionsEditor::takeKind);
    connect(m_text, &MarkdownEditor::edited, this, [this](const QString &text) {
        if (at() < 0)
            return;
        current().text = text;
        tell(QStringLiteral("text"));
    });
    for (int i = 0; i < LineCount; ++i)
        connect(m_lines[i], &QLineEdit::textEdited, this,
                [this, i] { takeLine(static_cast<Line>(i)); });
    connect(m_answers, &RowsList::itemChanged, this, &QuestionsEditor::takeAnswers);
    connect(m_answers, &RowsList::addRequested, this, &QuestionsEditor::addAnswer);
    connect(m_answers, &RowsList::removeRequested, this, &QuestionsEditor::removeAnswer);
    connect(m_answers, &RowsList::moveRequested, this, &QuestionsEditor::moveAnswer);
}

int QuestionsEditor::at() const
{
    return m_list->currentRow();
}

void QuestionsEditor::showQuestions(const std::vector<Question> &questions, const QString &step,
                                    const Values &values, bool readOnly)
{
    m_readOnly = readOnly;
    m_values = values;
    const int before = step == m_step ? at() : 0;
    m_questions = questions;
    m_step = step;
    QStringList titles;
    std::vector<Question> shown;
    for (const Question &question : questions) {
        titles.append(question.title);
        shown.push_back(withValuesPut(question, values));
    }
    m_list->showRows(titles, before);
    m_heading->setText(tr("Questions · %1").arg(m_list->count()));
    m_card->setQuestions(shown, {});
    m_card->setAnswers(rightAnswers(shown));
    m_cardCaption->setVisible(!questions.empty());
    showCurrent();
}

void QuestionsEditor::showCurrent()
{
    m_empty->setVisible(at() < 0);
    m_form->setVisible(at() >= 0);
    if (at() >= 0) {
        m_texts.setSubject(m_step + QLatin1Char('/') + current().id);
        m_kind->setCurrentIndex(m_kind->findData(nameOf(current().kind)));
        m_text->showText(current().text);
        showLines();
        showAnswers();
    }
    enableFields();
}

bool QuestionsEditor::isShown(Line line) const
{
    const bool ofNumbers = line == Number || line == Tolerance || line == Unit;
    return !ofNumbers || current().kind == Kind::Number;
}

QString QuestionsEditor::valueText(Line line) const
{
    const Question &question = current();
    switch (line) {
    case Title:
        return question.title;
    case Id:
        return question.id;
    case Points:
        return question.points == 1.0 ? QString() : fractionOrNumber(question.points);
    case Number:
        return question.expression.isEmpty() ? fractionOrNumber(question.number)
                                             : question.expression;
    case Tolerance:
        if (!question.toleranceExpression.isEmpty())
            return question.toleranceExpression;
        return question.tolerance == 0.0 ? QString() : fractionOrNumber(question.tolerance);
    case Unit:
        return question.unit;
    case LineCount:
        break;
    }
    return {};
}

void QuestionsEditor::showLines()
{
    for (int i = 0; i < LineCount; ++i) {
        const Line line = static_cast<Line>(i);
        m_texts.show(m_lines[i], valueText(line),
                     line == Points || line == Number || line == Tolerance);
        showField(m_lines[i], isShown(line));
    }
}

void QuestionsEditor::showAnswers()
{
    const QSignalBlocker blocker(m_answers);
    const Question &question = current();
    m_answersPart->setVisible(hasAnswers(question.kind));
    m_answersCaption->setText(question.kind == Kind::Order
                                  ? tr("Answers in the right order; students find them in another")
                              : question.kind == Kind::One
                                  ? tr("Answers; mark the right one")
                                  : tr("Answers; mark all that are right"));
    m_answers->showRows(question.answers, m_answers->currentRow());
    for (int i = 0; i < m_answers->count(); ++i) {
        QListWidgetItem *item = m_answers->item(i);
        Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
        if (!m_readOnly)
            flags |= Qt::ItemIsEditable;
        if (!m_readOnly && question.kind != Kind::Order)
            flags |= Qt::ItemIsUserCheckable;
        item->setFlags(flags);
        if (question.kind == Kind::Order)
            item->setData(Qt::CheckStateRole, {});
        else
            item->setCheckState(isChosen(question, i) ? Qt::Checked : Qt::Unchecked);
    }
}

void QuestionsEditor::enableFields()
{
    m_list->enableButtons(!m_readOnly, 0, m_step.isEmpty() ? 0 : mostQuestions);
    m_answers->enableButtons(!m_readOnly, fewestAnswers, mostAnswers);
    m_kind->setEnabled(!m_readOnly);
    m_text->setReadOnly(m_readOnly);
    for (QLineEdit *line : m_lines)
        line->setReadOnly(m_readOnly);
}

/// The window answers with showQuestions().
void QuestionsEditor::tell(const QString &field)
{
    const std::vector<Question> questions = m_questions;
    emit edited(questions,
                field.isEmpty() ? QString() : QStringLiteral("%1:%2").arg(at()).arg(field));
}

} // namespace cradle
