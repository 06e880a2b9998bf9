// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/prediction_editor.h"

#include "views/author/form_rows.h"
#include "views/author/markdown_editor.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/task_pane/prediction_card.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QToolButton>

namespace cradle {

namespace {

// The bounds of task.schema.json, in characters.
constexpr int longestQuestion = 400;
constexpr int longestOutcome = 1000;
constexpr int longestGuess = 100;
constexpr int fewestGuesses = 2;
constexpr int questionHeight = 72; ///< px
constexpr int outcomeHeight = 104; ///< px

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
    auto *answers = makeColumn({}, 6);
    for (const AnswerRow &row : m_rows)
        answers->addWidget(row.widget);
    layOutColumn(m_form, {}, 6,
                 {makeCaption(m_question),
                  m_question,
                  BoxPart::space(4),
                  m_answersCaption,
                  answers,
                  {m_add, 0, Qt::AlignLeft},
                  BoxPart::space(4),
                  outcome,
                  m_outcome,
                  m_refusal,
                  BoxPart::space(4),
                  {m_removeAll, 0, Qt::AlignLeft}});
    return m_form;
}

void PredictionEditor::makeAnswer(int answer)
{
    AnswerRow &row = m_rows[answer];
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

void PredictionEditor::wire()
{
    connect(m_begin, &QPushButton::clicked, this, &PredictionEditor::begin);
    connect(m_add, &QPushButton::clicked, this, &PredictionEditor::addAnswer);
    connect(m_removeAll, &QPushButton::clicked, this, [this] { change({}); });
    connect(m_question, &MarkdownEditor::edited, this,
            [this] { take(QStringLiteral("question")); });
    connect(m_outcome, &MarkdownEditor::edited, this, [this] { take(QStringLiteral("outcome")); });
    connect(m_right, &QButtonGroup::idClicked, this, [this] { take(QStringLiteral("right")); });
    for (int i = 0; i < mostAnswers; ++i) {
        const AnswerRow &row = m_rows[i];
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
        const AnswerRow &row = m_rows[i];
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

void PredictionEditor::change(const std::optional<Prediction> &prediction)
{
    setPrediction(prediction);
    emit edited(m_prediction, {});
}

void PredictionEditor::begin()
{
    change(Prediction{.question = tr("What will happen?"),
                      .answers = {tr("The first answer"), tr("The second answer")},
                      .right = 0,
                      .outcome = tr("What happens, and why.")});
    m_question->setFocus();
    m_question->selectAll();
}

void PredictionEditor::addAnswer()
{
    Prediction prediction = *m_prediction;
    prediction.answers.append(tr("Another answer"));
    change(prediction);
    QLineEdit *last = m_rows[prediction.answers.size() - 1].text;
    last->setFocus();
    last->selectAll();
}

void PredictionEditor::removeAnswer(int answer)
{
    Prediction prediction = *m_prediction;
    prediction.answers.removeAt(answer);
    if (prediction.right == answer)
        prediction.right = 0;
    else if (prediction.right > answer)
        --prediction.right;
    change(prediction);
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
        markRefused(m_rows[i].text, empty);
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
        prediction.answers[i] = m_rows[i].text->text();
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
        const AnswerRow &row = m_rows[i];
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
