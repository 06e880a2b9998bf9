// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/report/report_text.h"
#include "views/icons.h"
#include "views/task_pane/result_cards.h"
#include "views/task_pane/result_pane.h"
#include "views/theme.h"

#include <QClipboard>
#include <QFrame>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>

namespace cradle {

// What a ResultPane shows of work that passed.

void ResultPane::addSuccess(QVBoxLayout *column)
{
    const auto count = static_cast<int>(m_report->checks.size());
    addText(column,
            hasQuestions(*m_report) ? tr("✓ Passed: all %1 checks and answers").arg(count)
            : count == 1            ? tr("✓ Passed: the check")
                                    : tr("✓ Passed: all %1 checks").arg(count),
            "successTitle");
    if (m_awaitsRun)
        addText(column, tr("The step counts as passed as soon as the run of this work was shown."),
                "plain");
    for (const Remark &remark : m_report->remarks)
        addRemark(column, remark);
    if (!m_report->commit.isEmpty())
        addCommit(column, m_report->commit);
    addWayOn(column);
    addChecks(column);
}

/// Of a step that was passed before: what is left when the report is gone.
void ResultPane::addPass(QVBoxLayout *column)
{
    addText(column, tr("✓ You have passed this step"), "successTitle");
    if (m_pass.when.isValid()) {
        const QDateTime when = m_pass.when.toLocalTime();
        addText(column,
                tr("on %1 at %2")
                    .arg(when.toString(QStringLiteral("yyyy-MM-dd")),
                         when.toString(QStringLiteral("HH:mm"))),
                "muted");
    }
    if (!m_pass.commit.isEmpty())
        addCommit(column, m_pass.commit);
    addWayOn(column);
}

/// To the next step, or what is left of the lab.
void ResultPane::addWayOn(QVBoxLayout *column)
{
    if (m_last) {
        addText(column, tr("That was the last step."), "plain");
        if (!m_stillOpen.isEmpty())
            addText(column, tr("Still open: %1").arg(m_stillOpen.join(QStringLiteral(", "))),
                    "plain");
        return;
    }
    auto *next = new QPushButton(tr("Next step ▸"));
    next->setAccessibleName(tr("Next step"));
    next->setAutoDefault(true); // Return presses it when it has the focus
    setKind(next, "primary");
    next->setToolTip(tr("Next step (Ctrl+Page Down)"));
    column->addWidget(next, 0, Qt::AlignLeft);
    if (m_offersSolution) {
        auto *solution = new QPushButton(tr("Compare with the reference ▸"));
        solution->setAccessibleName(tr("Compare with the reference"));
        setKind(solution, "link");
        solution->setToolTip(tr("Shows the reference solution beside your program"));
        column->addWidget(solution, 0, Qt::AlignLeft);
        connect(solution, &QPushButton::clicked, this, &ResultPane::solutionRequested);
    }
    connect(next, &QPushButton::clicked, this, &ResultPane::nextStepRequested);
}

/// To the scene with which the step was passed, if that is not there any more.
void ResultPane::addWayBack(QVBoxLayout *column)
{
    if (!m_offersPassedScene)
        return;
    auto *back = new QPushButton(tr("Back to the scene that passed ▸"));
    back->setAccessibleName(tr("Back to the scene that passed"));
    setKind(back, "link");
    back->setToolTip(tr("Sets the values with which you passed this step; Undo takes that back"));
    column->addWidget(back, 0, Qt::AlignLeft);
    connect(back, &QPushButton::clicked, this, &ResultPane::passedSceneRequested);
}

/// The commit message, to take along.
void ResultPane::addCommit(QVBoxLayout *column, const QString &commit)
{
    auto *card = new QFrame;
    setKind(card, "card");
    auto *grid = new QGridLayout(card);
    grid->setContentsMargins(12, 8, 8, 8);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    auto *caption = new QLabel(tr("Commit message"));
    setKind(caption, "muted");
    auto *message = new QLabel(commit);
    message->setWordWrap(true);
    message->setTextFormat(Qt::PlainText);
    message->setTextInteractionFlags(Qt::TextSelectableByMouse);
    message->setAccessibleName(tr("Commit message"));
    auto *copy = new QPushButton(icon(u"copy"), QString());
    copy->setToolTip(tr("Copy the commit message"));
    copy->setAccessibleName(tr("Copy the commit message"));
    setKind(copy, "small");
    grid->addWidget(caption, 0, 0);
    grid->addWidget(message, 1, 0);
    grid->addWidget(copy, 0, 1, 2, 1, Qt::AlignTop);
    column->addWidget(card);
    connect(copy, &QPushButton::clicked, this,
            [text = commit] { QGuiApplication::clipboard()->setText(text); });
}

void ResultPane::addRemark(QVBoxLayout *column, const Remark &remark)
{
    const HeadedText text = splitHeadline(remark.message);
    addMarkdown(addCard(column, "card", text.headline), text, m_renderer);
}

} // namespace cradle
