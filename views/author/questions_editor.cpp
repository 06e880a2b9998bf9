// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/questions_editor.h"

#include "model/files/expression.h"
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
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>

namespace cradle {

using namespace questions;

namespace {

using Kind = Question::Kind;

/// Whether what is typed says the same in other words: "2." while it becomes "2.5".
bool isSame(const QString &typed, const QString &text, bool isNumber)
{
    if (typed.trimmed() == text.trimmed())
        return true;
    const Result<double> a = evaluated(typed);
    const Result<double> b = evaluated(text);
    return isNumber && a && b && *a == *b;
}

/// As the student with those values finds it.
Question withValuesPut(const Question &question, const Values &values)
{
    const Result<QJsonObject> put = taskWithNumbers(jsonFrom(question), values);
    return put ? questionFrom(*put) : question;
}

} // namespace

void QuestionsEditor::wire()
{
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        if (!m_loading)
            showCurrent();
    });
    connect(m_add, &QToolButton::clicked, this, &QuestionsEditor::add);
    connect(m_remove, &QToolButton::clicked, this, &QuestionsEditor::remove);
    connect(m_up, &QToolButton::clicked, this, [this] { move(-1); });
    connect(m_down, &QToolButton::clicked, this, [this] { move(1); });
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
    connect(m_answers, &QListWidget::itemChanged, this, &QuestionsEditor::takeAnswers);
    connect(m_answers, &QListWidget::currentRowChanged, this, &QuestionsEditor::enableButtons);
    connect(m_addAnswer, &QToolButton::clicked, this, &QuestionsEditor::addAnswer);
    connect(m_removeAnswer, &QToolButton::clicked, this, &QuestionsEditor::removeAnswer);
    connect(m_answerUp, &QToolButton::clicked, this, [this] { moveAnswer(-1); });
    connect(m_answerDown, &QToolButton::clicked, this, [this] { moveAnswer(1); });
}

int QuestionsEditor::at() const
{
    return m_list->currentRow();
}

void QuestionsEditor::showQuestions(const std::vector<Question> &questions, const QString &step,
                                    const Values &values)
{
    m_values = values;
    const int before = step == m_step ? at() : 0;
    m_questions = questions;
    m_step = step;
    m_loading = true;
    setRowCount(m_list, static_cast<int>(questions.size()));
    for (int i = 0; i < m_list->count(); ++i)
        m_list->item(i)->setText(questions[static_cast<std::size_t>(i)].title);
    m_list->doItemsLayout();
    chooseRow(m_list, before);
    m_loading = false;
    m_heading->setText(tr("Questions · %1").arg(m_list->count()));
    std::vector<Question> shown;
    for (const Question &question : questions)
        shown.push_back(withValuesPut(question, values));
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
    enableButtons();
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
        QLineEdit *edit = m_lines[i];
        const QString value = valueText(line);
        const RefusedTexts::Text *refused = m_texts.find(edit->objectName(), value);
        const QString text = refused ? refused->typed : value;
        if (!isSame(edit->text(), text, line == Points || line == Number || line == Tolerance))
            edit->setText(text);
        markRefused(edit, refused != nullptr);
        m_captions[i]->setVisible(isShown(line));
        edit->setVisible(isShown(line));
    }
    showRefusal(m_refusal, m_texts.reason());
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
    const int row = m_answers->currentRow();
    setRowCount(m_answers, static_cast<int>(question.answers.size()));
    for (int i = 0; i < m_answers->count(); ++i) {
        QListWidgetItem *item = m_answers->item(i);
        Qt::ItemFlags flags = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
        if (!m_readOnly)
            flags |= Qt::ItemIsEditable;
        if (!m_readOnly && question.kind != Kind::Order)
            flags |= Qt::ItemIsUserCheckable;
        item->setFlags(flags);
        item->setText(question.answers[i]);
        if (question.kind == Kind::Order)
            item->setData(Qt::CheckStateRole, {});
        else
            item->setCheckState(isChosen(question, i) ? Qt::Checked : Qt::Unchecked);
    }
    chooseRow(m_answers, row);
}

void QuestionsEditor::enableButtons()
{
    const bool writable = !m_readOnly;
    const bool any = at() >= 0;
    m_add->setEnabled(writable && !m_step.isEmpty() && m_list->count() < mostQuestions);
    m_remove->setEnabled(writable && any);
    m_up->setEnabled(writable && at() > 0);
    m_down->setEnabled(writable && any && at() + 1 < m_list->count());
    m_kind->setEnabled(writable);
    m_text->setReadOnly(m_readOnly);
    for (QLineEdit *line : m_lines)
        line->setReadOnly(m_readOnly);
    const int answer = m_answers->currentRow();
    m_addAnswer->setEnabled(writable && m_answers->count() < mostAnswers);
    m_removeAnswer->setEnabled(writable && answer >= 0 && m_answers->count() > fewestAnswers);
    m_answerUp->setEnabled(writable && answer > 0);
    m_answerDown->setEnabled(writable && answer >= 0 && answer + 1 < m_answers->count());
}

void QuestionsEditor::setReadOnly(bool readOnly)
{
    m_readOnly = readOnly;
    showCurrent();
}

/// The window answers with showQuestions().
void QuestionsEditor::tell(const QString &field)
{
    const std::vector<Question> questions = m_questions;
    emit edited(questions,
                field.isEmpty() ? QString() : QStringLiteral("%1:%2").arg(at()).arg(field));
}

} // namespace cradle
