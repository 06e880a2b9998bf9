// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/lab/lab.h"
#include "tasks/workspace/progress.h"

#include <QWidget>

class QSplitter;

namespace cradle {

class InstructionsPane;
class ResultPane;
class StepsList;

/// The student's side of a lab: its steps, the instructions of the open one with its hints, and
/// the result of the last check.
class TaskPane final : public QWidget
{
    Q_OBJECT
public:
    explicit TaskPane(QWidget *parent = nullptr);

    void setLab(const Lab &lab);
    /// \param passed   one per step
    /// \param current  the open step; −1: the scene belongs to none
    /// \param pass     what is left of the check that the open step passed
    void setProgress(const std::vector<bool> &passed, int current, const Pass &pass = {});
    void showTask(const Task &task, int hintsOpened);
    void setHintsOpened(int count);
    /// What the student expects of the open step; after showTask().
    void setGuess(const Guess &guess);
    /// What the student answers to its questions; after showTask().
    void setAnswers(const QJsonObject &answers);
    /// Shows a report, or that there is none yet; ends setChecking and setStale.
    void setReport(const std::optional<CheckReport> &report);
    void setChecking(bool checking, int done = 0, int total = 0);
    /// Whether a student who passed can compare his program with the reference.
    void setOffersSolution(bool offers);
    /// Whether another scene is there than that with which the step was passed.
    void setOffersPassedScene(bool offers);
    void setStale(bool stale);      ///< the scene was changed since the check
    void setAwaitsRun(bool awaits); ///< it passed, but its run was not shown yet

signals:
    void stepChosen(int step);  ///< from the list, or by a link in the instructions
    void hintOpened(int count); ///< how many hints of the step are open now
    void predicted(int answer); ///< from 0, or Guess::notSure
    void outcomeRequested();    ///< of the prediction
    void answered(const QString &question, const QJsonValue &answer); ///< see Answers
    void showMoment(const cradle::CheckOutcome &outcome);
    void nextStepRequested();
    void solutionRequested();
    void passedSceneRequested();
    void lineRequested(int line); ///< of the program

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void chooseById(const QString &taskId);
    void shareHeight();

    StepsList *m_steps = nullptr;
    InstructionsPane *m_instructions = nullptr;
    ResultPane *m_result = nullptr;
    QSplitter *m_splitter = nullptr;
    bool m_hasReport = false;
    bool m_hasPassed = false;
    bool m_shared = false; ///< by the student's hand
    QStringList m_taskIds;
};

} // namespace cradle
