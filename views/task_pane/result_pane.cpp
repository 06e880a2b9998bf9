// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/task_pane/result_pane.h"

#include "views/focus_ring.h"
#include "views/on_change.h"
#include "views/task_pane/check_row.h"
#include "views/task_pane/finding_card.h"
#include "views/task_pane/message_text.h"
#include "views/task_pane/result_cards.h"
#include "views/theme.h"

#include <QGraphicsColorizeEffect>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace cradle {

ResultPane::ResultPane(FormulaRenderer *renderer, QWidget *parent)
    : QWidget(parent)
    , m_renderer(renderer)
{
    m_heading = new QLabel(this);
    m_heading->setFont(headingFont());
    m_heading->setContentsMargins(12, 8, 12, 6);
    setKind(m_heading, "heading");
    m_progress = new QLabel(this);
    m_progress->setContentsMargins(12, 0, 12, 8);
    m_progress->hide();
    m_staleNote = new QLabel(this);
    m_staleNote->setContentsMargins(12, 0, 12, 4);
    m_staleNote->setWordWrap(true);
    setKind(m_staleNote, "muted");
    m_scroll = new QScrollArea(this);
    ringFocus(m_scroll);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_heading);
    column->addWidget(m_progress, 1, Qt::AlignTop);
    column->addWidget(m_staleNote);
    column->addWidget(m_scroll, 1);
    keepTranslated(this, &ResultPane::rebuild);
}

void ResultPane::setReport(const std::optional<CheckReport> &report)
{
    m_report = report;
    m_checking = false;
    m_stale = false;
    rebuild();
}

void ResultPane::setChecking(bool checking, int done, int total)
{
    const bool changed = checking != m_checking;
    m_checking = checking;
    m_done = done;
    m_total = total;
    if (changed)
        rebuild();
    else
        showChecking();
}

void ResultPane::setStale(bool stale)
{
    if (stale == m_stale)
        return;
    m_stale = stale;
    showStale();
}

void ResultPane::setAwaitsRun(bool awaits)
{
    if (awaits == m_awaitsRun)
        return;
    m_awaitsRun = awaits;
    rebuild();
}

void ResultPane::setHasStep(bool hasStep)
{
    if (hasStep == m_hasStep)
        return;
    m_hasStep = hasStep;
    rebuild();
}

void ResultPane::setPassed(bool passed, const Pass &pass)
{
    if (passed == m_passed && pass == m_pass)
        return;
    m_passed = passed;
    m_pass = pass;
    rebuild();
}

void ResultPane::setOffersSolution(bool offers)
{
    if (offers == m_offersSolution)
        return;
    m_offersSolution = offers;
    rebuild();
}

void ResultPane::setOffersPassedScene(bool offers)
{
    if (offers == m_offersPassedScene)
        return;
    m_offersPassedScene = offers;
    rebuild();
}

void ResultPane::setLast(bool last, const QStringList &stillOpen)
{
    if (last == m_last && stillOpen == m_stillOpen)
        return;
    m_last = last;
    m_stillOpen = stillOpen;
    rebuild();
}

void ResultPane::showChecking()
{
    m_progress->setVisible(m_checking);
    m_progress->setText(m_total > 0 ? tr("Checking… %1 of %2").arg(m_done).arg(m_total)
                                    : tr("Checking…"));
    m_scroll->setVisible(!m_checking);
    showStale();
}

/// What was read stays where it is, and without colours as readable: by these words a student
/// mends.
void ResultPane::showStale()
{
    const bool isStale = m_stale && m_body && !m_checking;
    m_staleNote->setVisible(isStale);
    if (m_body)
        m_body->graphicsEffect()->setEnabled(isStale);
}

/// Makes the content anew; the old one goes when no signal of its own is under way.
void ResultPane::rebuild()
{
    m_heading->setText(tr("Result"));
    m_scroll->setAccessibleName(tr("Result"));
    m_staleNote->setText(tr("Changed since this check"));
    m_body = nullptr;
    showChecking();
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(12, 0, 12, 12);
    column->setSpacing(6);
    if (!m_hasStep) {
        addText(column, tr("Nothing to check: this scene belongs to no step."), "muted");
    } else if (!m_report && m_passed) {
        addPass(column);
        addWayBack(column);
    } else if (!m_report) {
        addText(column, tr("Press Check (Ctrl+Return) when you are done."), "muted");
    } else {
        auto *body = new QWidget(content);
        auto *inner = new QVBoxLayout(body);
        inner->setContentsMargins(0, 0, 0, 0);
        inner->setSpacing(6);
        if (m_report->passed)
            addSuccess(inner);
        else
            addFailure(inner);
        auto *grey = new QGraphicsColorizeEffect(body);
        grey->setColor(Qt::black);
        body->setGraphicsEffect(grey);
        m_body = body;
        column->addWidget(body);
        addWayBack(column);
    }
    column->addStretch(1);
    if (QWidget *old = m_scroll->takeWidget())
        old->deleteLater();
    m_scroll->setWidget(content);
    showStale();
}

QLabel *ResultPane::addText(QVBoxLayout *column, const QString &text, const char *kind)
{
    auto *label = new QLabel(text);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    setKind(label, kind);
    column->addWidget(label);
    return label;
}

void ResultPane::addFailure(QVBoxLayout *column)
{
    const auto &checks = m_report->checks;
    const auto failed = std::find_if(checks.begin(), checks.end(),
                                     [](const CheckOutcome &check) { return !check.passed; });
    if (m_report->error)
        addError(column, *m_report->error);
    else if (m_report->diagnosis())
        addFindings(column);
    else if (failed != checks.end()) {
        QVBoxLayout *card =
            addCard(column, "warningCard", tr("Not yet: %1").arg(withUnits(failed->title)));
        addMessage(card, failed->message, "plain");
        addLinks(card, *failed);
    }
    addChecks(column);
}

void ResultPane::addError(QVBoxLayout *column, const ProgramError &error)
{
    const HeadedText text = describeError(error);
    QVBoxLayout *card = addCard(column, "warningCard", text.headline);
    addMessage(card, text.body, "plain");
    auto *row = new QHBoxLayout;
    card->addLayout(row);
    addLineLink(row, error.line);
    row->addStretch(1);
}

/// What is wrong, in the order in which to mend it; the first is open, with what was observed.
void ResultPane::addFindings(QVBoxLayout *column)
{
    bool first = true;
    for (const Finding &finding : m_report->findings) {
        auto *card = new FindingCard(finding, first, m_renderer);
        column->addWidget(card);
        const auto outcome =
            std::find_if(m_report->checks.begin(), m_report->checks.end(),
                         [&](const CheckOutcome &check) { return check.id == finding.check; });
        if (outcome != m_report->checks.end()) {
            CheckOutcome shown = *outcome;
            shown.line = finding.line > 0 ? finding.line : shown.line;
            if (first)
                addMessage(card->body(), shown.message, "muted");
            addLinks(card->body(), shown);
        }
        first = false;
    }
}

void ResultPane::addMessage(QVBoxLayout *column, const QString &message, const char *kind)
{
    addText(column, asSentence(message), kind)->setTextInteractionFlags(Qt::TextSelectableByMouse);
}

/// To the moment, and to the line that made it.
void ResultPane::addLinks(QVBoxLayout *card, const CheckOutcome &outcome)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(16);
    card->addLayout(row);
    if (hasMoment(outcome)) {
        QPushButton *link = makeMomentLink();
        row->addWidget(link);
        connect(link, &QPushButton::clicked, this, [this, outcome] { emit showMoment(outcome); });
    }
    addLineLink(row, outcome.line);
    row->addStretch(1);
}

void ResultPane::addLineLink(QHBoxLayout *row, int line)
{
    if (line <= 0)
        return;
    auto *link = new QPushButton(tr("Line %1 ▸").arg(line));
    link->setAccessibleName(tr("Show line %1 of the program").arg(line));
    setKind(link, "link");
    row->addWidget(link);
    connect(link, &QPushButton::clicked, this, [this, line] { emit lineRequested(line); });
}

void ResultPane::addChecks(QVBoxLayout *column)
{
    for (const CheckOutcome &check : m_report->checks) {
        auto *row = new CheckRow(check);
        column->addWidget(row);
        connect(row, &CheckRow::showMoment, this, &ResultPane::showMoment);
    }
}

} // namespace cradle
