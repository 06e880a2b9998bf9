// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/prediction_card.h"

#include "views/markdown_view.h"
#include "views/on_change.h"
#include "views/task_pane/answer_row.h"
#include "views/task_pane/card_label.h"
#include "views/task_pane/growing_text.h"
#include "views/task_pane/message_text.h"
#include "views/theme.h"

#include <QButtonGroup>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace cradle {

namespace {

// A button group keeps −1 for itself.
constexpr int idOffset = 1;

MarkdownView *makeText(FormulaRenderer *renderer)
{
    auto *view = new MarkdownView(nullptr, renderer);
    view->setEmbedded(true);
    view->setFocusPolicy(Qt::NoFocus);
    growWithText(view);
    return view;
}

} // namespace

PredictionCard::PredictionCard(FormulaRenderer *renderer, QWidget *parent)
    : QFrame(parent)
    , m_title(makeCardLabel("cardTitle"))
    , m_question(makeText(renderer))
    , m_answers(new QWidget)
    , m_status(makeCardLabel("muted"))
    , m_reveal(new QPushButton)
    , m_own(makeCardLabel("cardTitle"))
    , m_outcome(makeText(renderer))
{
    setKind(this, "card");
    setKind(m_reveal, "link");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(4);
    for (QWidget *part : {static_cast<QWidget *>(m_title), static_cast<QWidget *>(m_question),
                          m_answers, static_cast<QWidget *>(m_status)})
        column->addWidget(part);
    column->addWidget(m_reveal, 0, Qt::AlignLeft);
    column->addWidget(m_own);
    column->addWidget(m_outcome);
    connect(m_reveal, &QPushButton::clicked, this, &PredictionCard::outcomeRequested);
    keepTranslated(this, &PredictionCard::retranslate);
}

void PredictionCard::setPrediction(const std::optional<Prediction> &prediction)
{
    const bool changed = prediction != m_prediction;
    m_prediction = prediction;
    setVisible(prediction.has_value());
    if (!prediction || !changed)
        return;
    m_question->setMarkdown(prediction->question, {});
    makeAnswers();
    showGuess();
}

void PredictionCard::setGuess(const Guess &guess)
{
    m_guess = guess;
    showGuess();
}

void PredictionCard::makeAnswers()
{
    auto *answers = new QWidget;
    delete layout()->replaceWidget(m_answers, answers);
    m_answers->hide();
    m_answers->deleteLater();
    m_answers = answers;
    m_group = new QButtonGroup(answers);
    auto *column = new QVBoxLayout(answers);
    column->setContentsMargins(0, 2, 0, 2);
    column->setSpacing(4);
    QWidget *before = nullptr;
    const auto count = static_cast<int>(m_prediction->answers.size());
    for (int i = 0; i <= count; ++i) {
        QRadioButton *button = addAnswer(column, i < count ? i : Guess::notSure);
        if (before)
            QWidget::setTabOrder(before, button);
        before = button;
    }
    QWidget::setTabOrder(before, m_reveal);
    connect(m_group, &QButtonGroup::idClicked, this,
            [this](int id) { emit answered(id - idOffset); });
}

QRadioButton *PredictionCard::addAnswer(QVBoxLayout *column, int answer)
{
    auto *button = new QRadioButton;
    addAnswerRow(column, button, textOf(answer));
    m_group->addButton(button, answer + idOffset);
    return button;
}

QString PredictionCard::textOf(int answer) const
{
    return answer == Guess::notSure ? tr("Not sure") : m_prediction->answers.value(answer);
}

QString PredictionCard::statusText() const
{
    if (!m_guess.answer)
        return m_guess.watched
                   ? tr("The scene has run already. What did you expect?")
                   : tr("Choose before you run the scene. The check does not count it.");
    return m_guess.watched ? tr("Kept. Did it come so?") : tr("Kept. Now run the scene and watch.");
}

QString PredictionCard::ownText() const
{
    if (!m_guess.answer)
        return {};
    if (*m_guess.answer == Guess::notSure)
        return tr("You were not sure.");
    const QString text = tr("You predicted: %1").arg(textOf(*m_guess.answer));
    return *m_guess.answer == m_prediction->right ? QStringLiteral("✓ ") + text : text;
}

void PredictionCard::showGuess()
{
    if (!m_prediction)
        return;
    if (m_guess.answer && *m_guess.answer >= m_prediction->answers.size())
        m_guess.answer.reset(); // of a prediction that the lab has changed since
    const bool open = !m_guess.revealed;
    m_title->setText(open ? tr("Predict") : tr("Prediction"));
    m_answers->setVisible(open);
    m_status->setVisible(open);
    m_status->setText(statusText());
    m_reveal->setVisible(open && (m_guess.answer || m_guess.watched));
    m_own->setVisible(!open && m_guess.answer);
    m_own->setText(withUnits(ownText()));
    setKind(m_own, m_guess.answer == m_prediction->right ? "successTitle" : "cardTitle");
    m_outcome->setVisible(!open);
    if (open)
        checkAnswer();
    else
        m_outcome->setMarkdown(QStringLiteral("**%1** %2")
                                   .arg(tr("What happens: %1.").arg(textOf(m_prediction->right)),
                                        m_prediction->outcome),
                               {});
}

void PredictionCard::checkAnswer()
{
    m_group->setExclusive(false); // else none could be left unchecked
    for (QAbstractButton *button : m_group->buttons())
        button->setChecked(m_guess.answer == m_group->id(button) - idOffset);
    m_group->setExclusive(true);
}

void PredictionCard::retranslate()
{
    setAccessibleName(tr("Prediction"));
    m_question->setAccessibleName(tr("Question"));
    m_outcome->setAccessibleName(tr("What happens"));
    m_reveal->setText(tr("Show what happens ▸"));
    m_reveal->setAccessibleName(tr("Show what happens"));
    if (!m_prediction)
        return;
    makeAnswers();
    showGuess();
}

} // namespace cradle
