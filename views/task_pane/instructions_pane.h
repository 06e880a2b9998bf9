// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"

#include <QWidget>

class QPushButton;
class QScrollArea;
class QTextBrowser;

namespace cradle {

class FormulaRenderer;
class MarkdownView;
class PredictionCard;
class QuestionsCard;

/// The instructions of a step with its prediction and questions, and below them its hints, opened
/// one at a time.
class InstructionsPane final : public QWidget
{
    Q_OBJECT
public:
    /// \param renderer  of formulas, which lives longer; one of its own if there is none
    explicit InstructionsPane(QWidget *parent = nullptr, FormulaRenderer *renderer = nullptr);
    ~InstructionsPane() override;

    void showTask(const Task &task, int hintsOpened); ///< at its beginning
    /// The step as it is written: what is in sight stays there, as far as it can.
    void followTask(const Task &task);
    void setHintsOpened(int count);
    /// What the student expects of the step; once it is revealed, it comes in sight.
    void setGuess(const Guess &guess);
    /// What the student answers to its questions; after showTask().
    void setAnswers(const QJsonObject &answers);
    /// Sets formulas; for other views that live no longer than this one.
    [[nodiscard]] FormulaRenderer *renderer() const { return m_renderer; }
    [[nodiscard]] int hintsOpened() const { return m_opened; }

signals:
    void hintOpened(int count); ///< how many are open now
    void stepRequested(const QString &taskId);
    void predicted(int answer); ///< from 0, or Guess::notSure
    void outcomeRequested();
    void answered(const QString &question, const QJsonValue &answer); ///< see Answers

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeLayout();
    void addView(MarkdownView *view);
    void retranslate();
    void showHints();
    void revealHints(); ///< they are last
    void revealPrediction();

    FormulaRenderer *m_renderer = nullptr;
    QScrollArea *m_scroll = nullptr;
    MarkdownView *m_instructions = nullptr; ///< all, or what stands before the prediction
    PredictionCard *m_prediction = nullptr;
    MarkdownView *m_rest = nullptr; ///< of the instructions, after the prediction
    QuestionsCard *m_questions = nullptr;
    MarkdownView *m_hints = nullptr; ///< those that are open, below each other
    QPushButton *m_nextHint = nullptr;
    Task m_task;
    int m_opened = 0;
    bool m_revealed = false; ///< the outcome of the prediction
};

} // namespace cradle
