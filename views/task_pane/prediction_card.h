// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/prediction.h"

#include <QFrame>

#include <vector>

class QButtonGroup;
class QLabel;
class QPushButton;
class QRadioButton;
class QVBoxLayout;

namespace cradle {

class FormulaRenderer;
class MarkdownView;

/// Asks what the student expects of a step; later it shows that beside what happens.
class PredictionCard final : public QFrame
{
    Q_OBJECT
public:
    /// \param renderer  sets formulas; outlives the card
    explicit PredictionCard(FormulaRenderer *renderer, QWidget *parent = nullptr);

    /// Hides the card if there is nothing to ask.
    void setPrediction(const std::optional<Prediction> &prediction);
    void setGuess(const Guess &guess);

signals:
    void answered(int answer); ///< from 0, or Guess::notSure
    void outcomeRequested();

private:
    void makeAnswers();
    QRadioButton *addAnswer(QVBoxLayout *column, int answer);
    void retranslate();
    void showGuess();
    void checkAnswer();
    [[nodiscard]] QString textOf(int answer) const;
    [[nodiscard]] QString statusText() const;
    [[nodiscard]] QString ownText() const;

    std::optional<Prediction> m_prediction;
    Guess m_guess;
    QLabel *m_title = nullptr;
    MarkdownView *m_question = nullptr;
    QWidget *m_answers = nullptr; ///< made anew for each prediction
    QButtonGroup *m_group = nullptr;
    QLabel *m_status = nullptr;
    QPushButton *m_reveal = nullptr;
    QLabel *m_own = nullptr; ///< what the student expected
    MarkdownView *m_outcome = nullptr;
};

} // namespace cradle
