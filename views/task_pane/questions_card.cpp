// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/questions_card.h"

#include "model/world/shortest_number.h"
#include "views/markdown_view.h"
#include "views/on_change.h"
#include "views/task_pane/card_label.h"
#include "views/task_pane/growing_text.h"
#include "views/task_pane/message_text.h"
#include "views/task_pane/question_field.h"
#include "views/theme.h"

#include <QVBoxLayout>

namespace cradle {

QuestionsCard::QuestionsCard(FormulaRenderer *renderer, QWidget *parent)
    : QFrame(parent)
    , m_renderer(renderer)
    , m_title(makeCardLabel("cardTitle"))
    , m_status(makeCardLabel("muted"))
    , m_body(new QWidget)
{
    setKind(this, "card");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(4);
    column->addWidget(m_title);
    column->addWidget(m_status);
    column->addWidget(m_body);
    keepTranslated(this, &QuestionsCard::makeFields);
}

void QuestionsCard::setQuestions(const std::vector<Question> &questions, const QUrl &folder)
{
    const bool changed = questions != m_questions || folder != m_folder;
    m_questions = questions;
    m_folder = folder;
    if (changed)
        makeFields();
}

void QuestionsCard::setAnswers(const Answers &answers)
{
    m_answers = answers;
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        m_fields[i]->showAnswer(answers.value(m_questions[i].id));
}

void QuestionsCard::makeFields()
{
    setVisible(!m_questions.empty());
    setAccessibleName(tr("Questions"));
    m_title->setText(tr("Questions"));
    m_status->setText(tr("The check counts your answers."));
    auto *body = new QWidget;
    auto *column = new QVBoxLayout(body);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(4);
    delete layout()->replaceWidget(m_body, body);
    m_body->hide();
    m_body->deleteLater();
    m_body = body;
    m_fields.clear();
    for (const Question &question : m_questions)
        addQuestion(column, question);
    setAnswers(m_answers);
}

void QuestionsCard::addQuestion(QVBoxLayout *column, const Question &question)
{
    auto *title = makeCardLabel("cardTitle");
    const QString points = shortestNumber(question.points);
    title->setText(withUnits(question.points == 1.0
                                 ? question.title
                                 : tr("%1 (%2 points)").arg(question.title, points)));
    auto *text = new MarkdownView(nullptr, m_renderer);
    text->setEmbedded(true);
    text->setFocusPolicy(Qt::NoFocus);
    text->setAccessibleName(question.title);
    growWithText(text);
    text->setMarkdown(question.text, m_folder);
    QuestionField *field = makeQuestionField(question).release(); // of the layout below
    connect(field, &QuestionField::answered, this, [this, id = question.id](const QJsonValue &it) {
        m_answers.insert(id, it);
        emit answered(id, it);
    });
    column->addWidget(title);
    column->addWidget(text);
    text->setHidden(question.text.trimmed().isEmpty());
    column->addWidget(field);
    column->addSpacing(6);
    m_fields.push_back(field);
}

} // namespace cradle
