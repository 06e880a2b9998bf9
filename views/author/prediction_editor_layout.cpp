// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/prediction_editor.h"

#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/tool_buttons.h"
#include "views/task_pane/prediction_card.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace cradle {

namespace {

constexpr int questionHeight = 72; ///< px
constexpr int outcomeHeight = 104; ///< px
constexpr int longestGuess = 100;  ///< characters, as in task.schema.json

} // namespace

void PredictionEditor::makeLayout(FormulaRenderer *renderer)
{
    auto *side = new QWidget;
    auto *both = new QVBoxLayout(side);
    both->setContentsMargins(12, 8, 12, 8);
    both->addWidget(makeNothing(side));
    both->addWidget(makeForm(side));
    both->addStretch(1);
    m_cardsPane = scrolled(makeCards(renderer));
    layOutSideBySide(this, {scrolled(side), m_cardsPane}, {500, 500});
}

QWidget *PredictionEditor::makeNothing(QWidget *parent)
{
    m_nothing = new QWidget(parent);
    m_none = makeMutedText(m_nothing);
    m_begin = new QPushButton(m_nothing);
    auto *column = new QVBoxLayout(m_nothing);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(m_none);
    column->addWidget(m_begin, 0, Qt::AlignLeft);
    return m_nothing;
}

QWidget *PredictionEditor::makeForm(QWidget *parent)
{
    m_form = new QWidget(parent);
    m_questionCaption = new QLabel(m_form);
    m_question = makeTextField(QStringLiteral("predictionQuestion"), questionHeight, m_form);
    m_questionCaption->setBuddy(m_question);
    m_answersCaption = new QLabel(m_form);
    m_answersCaption->setWordWrap(true);
    // In the order in which Tab goes through them.
    m_right = new QButtonGroup(m_form);
    for (int i = 0; i < mostAnswers; ++i)
        makeAnswer(i);
    m_add = new QPushButton(m_form);
    setKind(m_add, "link");
    m_outcomeCaption = new QLabel(m_form);
    m_outcomeCaption->setWordWrap(true);
    m_outcome = makeTextField(QStringLiteral("predictionOutcome"), outcomeHeight, m_form);
    m_outcomeCaption->setBuddy(m_outcome);
    m_refusal = makeRefusal(m_form);
    m_removeAll = new QPushButton(m_form);
    setKind(m_removeAll, "link");
    auto *column = new QVBoxLayout(m_form);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(m_questionCaption);
    column->addWidget(m_question);
    column->addSpacing(4);
    column->addWidget(m_answersCaption);
    for (const AnswerRow &row : m_rows)
        column->addWidget(row.widget);
    column->addWidget(m_add, 0, Qt::AlignLeft);
    column->addSpacing(4);
    column->addWidget(m_outcomeCaption);
    column->addWidget(m_outcome);
    column->addWidget(m_refusal);
    column->addSpacing(4);
    column->addWidget(m_removeAll, 0, Qt::AlignLeft);
    return m_form;
}

void PredictionEditor::makeAnswer(int answer)
{
    AnswerRow &row = m_rows[static_cast<std::size_t>(answer)];
    row.widget = new QWidget(m_form);
    row.right = new QRadioButton(row.widget);
    row.text = new QLineEdit(row.widget);
    row.text->setObjectName(QStringLiteral("predictionAnswer%1").arg(answer + 1));
    row.text->setMaxLength(longestGuess);
    row.remove = makeIconButton(QStringLiteral("remove"), row.widget);
    m_right->addButton(row.right, answer);
    auto *line = new QHBoxLayout(row.widget);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    line->addWidget(row.right);
    line->addWidget(row.text, 1);
    line->addWidget(row.remove);
}

QWidget *PredictionEditor::makeCards(FormulaRenderer *renderer)
{
    m_cards = new QWidget;
    m_cards->setAttribute(Qt::WA_TransparentForMouseEvents); // they are to be looked at
    m_beforeCaption = makeMutedText(m_cards);
    m_before = new PredictionCard(renderer, m_cards);
    m_afterCaption = makeMutedText(m_cards);
    m_after = new PredictionCard(renderer, m_cards);
    auto *column = new QVBoxLayout(m_cards);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(8);
    column->addWidget(m_beforeCaption);
    column->addWidget(m_before);
    column->addSpacing(8);
    column->addWidget(m_afterCaption);
    column->addWidget(m_after);
    column->addStretch(1);
    return m_cards;
}

} // namespace cradle
