// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/author/author_document.h"
#include "views/author/proof_job.h"
#include "views/author/scene_visit.h"

#include <QWidget>

QT_BEGIN_NAMESPACE
class QLabel;
class QProgressBar;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

class ProofMatrix;
class ProofRows;

/// The proof that the checks of a step work: every program judged, the matrix of programs and
/// checks, what is not as it should be with a way to see it, and mistakes that the step does not
/// know yet.
class ProofTab final : public QWidget
{
    Q_OBJECT
public:
    explicit ProofTab(AuthorDocument &document, QWidget *parent = nullptr);

    /// What was found of the open step, if it was verified.
    [[nodiscard]] const VerifiedTask *result() const;
    [[nodiscard]] bool isRunning() const { return m_job.isRunning(); }

public slots:
    void verifyStep();
    void verifyAll();
    void suggest(); ///< mistakes of the open step
    void stop();

signals:
    /// A program of the open step: "solution", "mistakes/NAME".
    void programRequested(const QString &program);
    void checkRequested(const QString &id);
    /// The run of a program in a scene of a check, at the step where it first went wrong.
    /// \param finding  why it is worth a look
    void runRequested(const cradle::SceneVisit &run, const QString &finding);

private:
    void makeLayout();
    void wire();
    void retranslate();
    void verify(const QString &only); ///< a task's id; empty: all
    void setRunning(bool running);
    void takeVerified(const std::vector<VerifiedTask> &tasks);
    void takeSuggested(const Suggestions &suggestions);
    void showStep();
    void showSummary();
    void showOthers();
    void showRows();
    /// \param wrong  else they are only worth a look
    void showFindings(const QString &heading, const std::vector<LabFinding> &findings, bool wrong);
    void addFinding(const LabFinding &finding, bool wrong);
    void addSuggestion(const Suggestion &suggestion);
    [[nodiscard]] QString summaryOf(const VerifiedTask &verified) const;
    [[nodiscard]] int missingChecks() const; ///< suggestions that pass every check
    void showSuggestions();
    void showRun(const LabFinding &finding);
    [[nodiscard]] const CheckOutcome *outcomeOf(const LabFinding &finding) const;
    void adopt(const Suggestion &suggestion); ///< as a mistake of the step
    [[nodiscard]] QString sourceOf(const QString &program) const;
    [[nodiscard]] const VerifiedTask *resultOf(const QString &task) const;
    [[nodiscard]] QString taskId() const;

    AuthorDocument &m_document;
    ProofJob m_job;
    std::vector<VerifiedTask> m_verified;
    LabFiles m_verifiedFiles; ///< that m_verified is about
    Suggestions m_suggestions;
    LabFiles m_suggestedFiles;    ///< that m_suggestions are about
    QString m_suggestedFor;       ///< id of the step
    bool m_suggestedLast = false; ///< then the suggestions stand above the findings
    QPushButton *m_verifyStep = nullptr;
    QPushButton *m_verifyAll = nullptr;
    QPushButton *m_suggest = nullptr;
    QPushButton *m_stop = nullptr;
    QProgressBar *m_progress = nullptr;
    QLabel *m_summary = nullptr;
    QLabel *m_stale = nullptr;
    QLabel *m_others = nullptr;       ///< steps with findings, to be opened
    QWidget *m_focusBefore = nullptr; ///< the button that began what runs
    ProofMatrix *m_matrix = nullptr;
    QLabel *m_empty = nullptr;
    ProofRows *m_rows = nullptr; ///< hidden while there is none
};

} // namespace cradle
