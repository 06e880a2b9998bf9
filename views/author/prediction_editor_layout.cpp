// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/prediction_editor.h"

#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/author/tool_buttons.h"
#include "views/boxes.h"
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
    layOutColumn(side, {12, 8, 12, 8}, -1, {makeNothing(side), makeForm(side), BoxPart::rest()});
    m_cardsPane = scrolled(makeCards(renderer));
    layOutSideBySide(this, {scrolled(side), m_cardsPane}, {500, 500});
}

QWidget *PredictionEditor::makeNothing(QWidget *parent)
{
    m_nothing = new QWidget(parent);
    m_none = makeMutedText(m_nothing);
    m_begin = new QPushButton(m_nothing);
    layOutColumn(m_nothing, {}, 8, {m_none, {m_begin, 0, Qt::AlignLeft}});
    return m_nothing;
}

QWidget *PredictionEditor::makeForm(QWidget *parent)
{
    m_form = new QWidget(parent);
    m_question = makeTextField(QStringLiteral("predictionQuestion"), questionHeight, m_form);
    m_answersCaption = new QLabel(m_form);
    m_answersCaption->setWordWrap(true);
    // In the order in which Tab goes through them.
    m_right = new QButtonGroup(m_form);
    for (int i = 0; i < mostAnswers; ++i)
        makeAnswer(i);
    m_add = new QPushButton(m_form);
    setKind(m_add, "link");
    m_outcome = makeTextField(QStringLiteral("predictionOutcome"), outcomeHeight, m_form);
    QLabel *outcome = makeCaption(m_outcome);
    outcome->setWordWrap(true);
    m_refusal = makeRefusal(m_form);
    m_removeAll = new QPushButton(m_form);
    setKind(m_removeAll, "link");
    auto *column = layOutColumn(
        m_form, {}, 6, {makeCaption(m_question), m_question, BoxPart::space(4), m_answersCaption});
    for (const AnswerRow &row : m_rows)
        column->addWidget(row.widget);
    column->addWidget(m_add, 0, Qt::AlignLeft);
    column->addSpacing(4);
    column->addWidget(outcome);
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
    layOutRow(row.widget, {}, 8, {row.right, {row.text, 1}, row.remove});
}

QWidget *PredictionEditor::makeCards(FormulaRenderer *renderer)
{
    m_cards = new QWidget;
    m_cards->setAttribute(Qt::WA_TransparentForMouseEvents); // they are to be looked at
    m_beforeCaption = makeMutedText(m_cards);
    m_before = new PredictionCard(renderer, m_cards);
    m_afterCaption = makeMutedText(m_cards);
    m_after = new PredictionCard(renderer, m_cards);
    layOutColumn(
        m_cards, {12, 8, 12, 8}, 8,
        {m_beforeCaption, m_before, BoxPart::space(8), m_afterCaption, m_after, BoxPart::rest()});
    return m_cards;
}

} // namespace cradle
