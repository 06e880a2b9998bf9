// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/check_report.h"
#include "tasks/workspace/progress.h"

#include <QWidget>

class QLabel;
class QScrollArea;
class QHBoxLayout;
class QVBoxLayout;

namespace cradle {

class FormulaRenderer;

/// What the last check of the step found: the first failure in words, or that all passed; then
/// every check.
class ResultPane final : public QWidget
{
    Q_OBJECT
public:
    /// \param renderer  outlives the pane; nullptr: every text has its own
    explicit ResultPane(FormulaRenderer *renderer, QWidget *parent = nullptr);

    void setReport(const std::optional<CheckReport> &report);
    void setChecking(bool checking, int done, int total);
    void setStale(bool stale); ///< the scene was changed since the check
    /// The check passed, but the step counts only when the run of that work was shown.
    void setAwaitsRun(bool awaits);
    /// \param last       whether no step follows the open one
    /// \param stillOpen  numbers of the other steps that are not passed
    void setLast(bool last, const QStringList &stillOpen);

    /// Whether there is something to check: not in a scene without a step.
    void setHasStep(bool hasStep);
    /// Whether the step was passed, now or some time before.
    /// \param pass  what is left of that
    void setPassed(bool passed, const Pass &pass);
    /// Whether the student's program can be compared with the reference.
    void setOffersSolution(bool offers);
    /// Whether another scene is there than that with which the step was passed.
    void setOffersPassedScene(bool offers);

signals:
    void solutionRequested();
    void passedSceneRequested();
    void lineRequested(int line);
    void showMoment(const cradle::CheckOutcome &outcome);
    void nextStepRequested();

private:
    void rebuild();
    void showChecking();
    void showStale();
    void addFailure(QVBoxLayout *column);
    void addError(QVBoxLayout *column, const ProgramError &error);
    void addFindings(QVBoxLayout *column);
    void addRemark(QVBoxLayout *column, const Remark &remark);
    void addMessage(QVBoxLayout *column, const QString &message, const char *kind);
    void addLinks(QVBoxLayout *card, const CheckOutcome &outcome);
    void addLineLink(QHBoxLayout *row, int line);
    void addSuccess(QVBoxLayout *column);
    void addPass(QVBoxLayout *column);
    void addCommit(QVBoxLayout *column, const QString &commit);
    void addWayOn(QVBoxLayout *column);
    void addWayBack(QVBoxLayout *column);
    void addChecks(QVBoxLayout *column);
    QLabel *addText(QVBoxLayout *column, const QString &text, const char *kind);

    FormulaRenderer *m_renderer;
    QLabel *m_heading = nullptr;
    QLabel *m_progress = nullptr;
    QLabel *m_staleNote = nullptr;
    QScrollArea *m_scroll = nullptr;
    QWidget *m_body = nullptr; ///< what the report says; null if there is none
    std::optional<CheckReport> m_report;
    bool m_checking = false;
    int m_done = 0;
    int m_total = 0;
    bool m_stale = false;
    bool m_awaitsRun = false;
    bool m_hasStep = true;
    bool m_passed = false;
    Pass m_pass;
    bool m_last = false;
    bool m_offersSolution = false;
    bool m_offersPassedScene = false;
    QStringList m_stillOpen;
};

} // namespace cradle
