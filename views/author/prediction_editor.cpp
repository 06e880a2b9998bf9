// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/prediction_editor.h"

#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/on_change.h"
#include "views/task_pane/prediction_card.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>

namespace cradle {

namespace {

// The bounds of task.schema.json, in characters.
constexpr int longestQuestion = 400;
constexpr int longestOutcome = 1000;
constexpr int fewestGuesses = 2;

bool fits(const QString &text, int longest)
{
    return !text.isEmpty() && text.size() <= longest;
}

} // namespace

PredictionEditor::PredictionEditor(FormulaRenderer *renderer, QWidget *parent)
    : QWidget(parent)
{
    makeLayout(renderer);
    keepTranslated(this, &PredictionEditor::retranslate);
    wire();
    setPrediction({});
}

void PredictionEditor::wire()
{
    connect(m_begin, &QPushButton::clicked, this, &PredictionEditor::begin);
    connect(m_add, &QPushButton::clicked, this, &PredictionEditor::addAnswer);
    connect(m_removeAll, &QPushButton::clicked, this, [this] {
        setPrediction({});
        emit edited(m_prediction, {});
    });
    connect(m_question, &MarkdownEditor::edited, this,
            [this] { take(QStringLiteral("question")); });
    connect(m_outcome, &MarkdownEditor::edited, this, [this] { take(QStringLiteral("outcome")); });
    connect(m_right, &QButtonGroup::idClicked, this, [this] { take(QStringLiteral("right")); });
    for (int i = 0; i < mostAnswers; ++i) {
        const AnswerRow &row = m_rows[static_cast<std::size_t>(i)];
        connect(row.text, &QLineEdit::textEdited, this,
                [this, i] { take(QStringLiteral("answer%1").arg(i)); });
        connect(row.remove, &QToolButton::clicked, this, [this, i] { removeAnswer(i); });
    }
}

void PredictionEditor::showPrediction(const std::optional<Prediction> &prediction, bool readOnly)
{
    m_readOnly = readOnly;
    setPrediction(prediction);
}

void PredictionEditor::setPrediction(const std::optional<Prediction> &prediction)
{
    m_prediction = prediction;
    m_nothing->setVisible(!prediction);
    m_form->setVisible(prediction.has_value());
    m_cardsPane->setVisible(prediction.has_value());
    showRefusal(m_refusal, {});
    if (prediction) {
        m_question->showText(prediction->question);
        m_outcome->showText(prediction->outcome);
        showAnswers();
        showCards();
    }
    enableFields();
}

void PredictionEditor::showAnswers()
{
    const auto count = static_cast<int>(m_prediction->answers.size());
    m_right->setExclusive(false); // else none could be left unchecked
    for (int i = 0; i < mostAnswers; ++i) {
        const AnswerRow &row = m_rows[static_cast<std::size_t>(i)];
        row.widget->setVisible(i < count);
        row.right->setChecked(i == m_prediction->right);
        if (row.text->text() != m_prediction->answers.value(i))
            row.text->setText(m_prediction->answers.value(i));
        markRefused(row.text, false);
    }
    m_right->setExclusive(true);
}

void PredictionEditor::showCards()
{
    m_before->setPrediction(m_prediction);
    m_after->setPrediction(m_prediction);
    for (QRadioButton *answer : m_cards->findChildren<QRadioButton *>())
        answer->setFocusPolicy(Qt::NoFocus); // of a picture
    m_after->setGuess({.answer = m_prediction->right, .watched = true, .revealed = true});
}

void PredictionEditor::enableFields()
{
    const bool writable = !m_readOnly;
    const auto count = m_prediction ? m_prediction->answers.size() : 0;
    m_begin->setEnabled(writable);
    m_question->setReadOnly(m_readOnly);
    m_outcome->setReadOnly(m_readOnly);
    m_add->setEnabled(writable && count < mostAnswers);
    m_removeAll->setEnabled(writable);
    for (const AnswerRow &row : m_rows) {
        row.right->setEnabled(writable);
        row.text->setReadOnly(m_readOnly);
        row.remove->setEnabled(writable && count > fewestGuesses);
    }
}

void PredictionEditor::begin()
{
    setPrediction(Prediction{.question = tr("What will happen?"),
                             .answers = {tr("The first answer"), tr("The second answer")},
                             .right = 0,
                             .outcome = tr("What happens, and why.")});
    emit edited(m_prediction, {});
    m_question->setFocus();
    m_question->selectAll();
}

void PredictionEditor::addAnswer()
{
    Prediction prediction = *m_prediction;
    prediction.answers.append(tr("Another answer"));
    setPrediction(prediction);
    emit edited(m_prediction, {});
    const AnswerRow &last = m_rows[static_cast<std::size_t>(prediction.answers.size() - 1)];
    last.text->setFocus();
    last.text->selectAll();
}

void PredictionEditor::removeAnswer(int answer)
{
    Prediction prediction = *m_prediction;
    prediction.answers.removeAt(answer);
    if (prediction.right == answer)
        prediction.right = 0;
    else if (prediction.right > answer)
        --prediction.right;
    setPrediction(prediction);
    emit edited(m_prediction, {});
}

/// What keeps \p prediction from being written; marks the answers that are at fault.
QString PredictionEditor::faultOf(const Prediction &prediction)
{
    QString fault;
    if (!fits(prediction.question, longestQuestion))
        fault = tr("A question of 1 to %1 characters is right").arg(longestQuestion);
    else if (!fits(prediction.outcome, longestOutcome))
        fault = tr("A text of 1 to %1 characters on what happens is right").arg(longestOutcome);
    for (int i = 0; i < static_cast<int>(prediction.answers.size()); ++i) {
        const bool empty = prediction.answers[i].isEmpty(); // a field takes no longer ones
        markRefused(m_rows[static_cast<std::size_t>(i)].text, empty);
        if (empty)
            fault = tr("An answer of 1 to 100 characters is right");
    }
    return fault;
}

void PredictionEditor::take(const QString &field)
{
    if (!m_prediction)
        return;
    Prediction prediction = *m_prediction;
    prediction.question = m_question->toPlainText();
    prediction.outcome = m_outcome->toPlainText();
    for (int i = 0; i < static_cast<int>(prediction.answers.size()); ++i)
        prediction.answers[i] = m_rows[static_cast<std::size_t>(i)].text->text();
    if (m_right->checkedId() >= 0)
        prediction.right = m_right->checkedId();
    const QString fault = faultOf(prediction);
    showRefusal(m_refusal, fault);
    if (!fault.isEmpty() || prediction == *m_prediction)
        return;
    m_prediction = prediction;
    showCards();
    emit edited(m_prediction, field);
}

void PredictionEditor::retranslate()
{
    m_none->setText(tr("This step asks for no prediction. A question that is asked before the "
                       "scene is watched, and answered after it, makes students look."));
    m_begin->setText(tr("Ask for a prediction"));
    nameField(m_question, tr("Question"));
    m_answersCaption->setText(tr("Answers: two to four that students truly believe; mark the one "
                                 "that comes true"));
    for (int i = 0; i < mostAnswers; ++i) {
        const AnswerRow &row = m_rows[static_cast<std::size_t>(i)];
        row.right->setAccessibleName(tr("Answer %1 comes true").arg(i + 1));
        row.right->setToolTip(row.right->accessibleName());
        row.text->setAccessibleName(tr("Answer %1").arg(i + 1));
        row.remove->setAccessibleName(tr("Remove answer %1").arg(i + 1));
        row.remove->setToolTip(row.remove->accessibleName());
    }
    m_add->setText(tr("Add an answer"));
    nameField(m_outcome, tr("What happens, and why; told after the step was passed"), {},
              tr("What happens, and why"));
    m_removeAll->setText(tr("Remove the prediction"));
    m_beforeCaption->setText(tr("What the student sees before"));
    m_afterCaption->setText(tr("And after"));
}

} // namespace cradle
