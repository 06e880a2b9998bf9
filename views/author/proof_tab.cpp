// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/proof_tab.h"

#include "views/author/form_rows.h"
#include "views/author/proof_matrix.h"
#include "views/author/proof_rows.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSplitter>

#include <algorithm>

namespace cradle {

ProofTab::ProofTab(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
{
    makeLayout();
    keepTranslated(this, &ProofTab::retranslate);
    wire();
    setRunning(false);
    showStep();
}

void ProofTab::makeLayout()
{
    m_verifyStep = new QPushButton(this);
    m_verifyAll = new QPushButton(this);
    m_suggest = new QPushButton(this);
    m_stop = new QPushButton(this);
    m_progress = new QProgressBar(this);
    m_progress->setTextVisible(false);
    m_progress->setFixedWidth(140);
    setKind(m_verifyStep, "primary");
    auto *top =
        makeRow({12, 8, 12, 8}, 8,
                {m_verifyStep, m_verifyAll, m_suggest, BoxPart::rest(), m_progress, m_stop});
    m_summary = new QLabel(this);
    m_summary->setWordWrap(true);
    m_others = new QLabel(this);
    m_others->setObjectName(QStringLiteral("otherSteps"));
    m_others->setTextFormat(Qt::RichText);
    m_others->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_others->setWordWrap(true);
    m_stale = makeMutedText(this);
    for (QLabel *label : {m_summary, m_others, m_stale})
        label->setContentsMargins(12, 0, 12, 6);
    m_empty = makeMutedText(this);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setContentsMargins(40, 40, 40, 40);
    m_matrix = new ProofMatrix(this);
    m_rows = new ProofRows(this);
    QSplitter *splitter = makeSplitter(Qt::Vertical, {m_matrix, m_rows}, {320, 220});
    layOutColumn(this, {}, 0, {top, m_summary, m_others, m_stale, {m_empty, 1}, {splitter, 1}});
}

void ProofTab::wire()
{
    connect(m_verifyStep, &QPushButton::clicked, this, &ProofTab::verifyStep);
    connect(m_verifyAll, &QPushButton::clicked, this, &ProofTab::verifyAll);
    connect(m_suggest, &QPushButton::clicked, this, &ProofTab::suggest);
    connect(m_stop, &QPushButton::clicked, this, &ProofTab::stop);
    connect(&m_job, &ProofJob::progressed, this, [this](int done, int total) {
        m_progress->setMaximum(total);
        m_progress->setValue(done);
    });
    connect(&m_job, &ProofJob::verified, this, &ProofTab::takeVerified);
    connect(&m_job, &ProofJob::suggested, this, &ProofTab::takeSuggested);
    connect(&m_job, &ProofJob::ended, this, [this] { setRunning(false); });
    connect(m_others, &QLabel::linkActivated, &m_document, &AuthorDocument::setStep);
    connect(&m_document, &AuthorDocument::stepChanged, this, &ProofTab::showStep);
    connect(&m_document, &AuthorDocument::changed, this, &ProofTab::showSummary);
    connect(&m_document, &AuthorDocument::opened, this, [this] {
        m_job.cancel();
        m_verified.clear();
        m_suggestions = {};
        m_suggestedFor.clear();
        showStep();
    });
    connect(m_matrix, &ProofMatrix::programChosen, this, &ProofTab::programRequested);
    connect(m_matrix, &ProofMatrix::checkChosen, this, &ProofTab::checkRequested);
}

QString ProofTab::taskId() const
{
    const Task *task = m_document.task();
    return task ? task->id : QString();
}

const VerifiedTask *ProofTab::result() const
{
    return resultOf(taskId());
}

const VerifiedTask *ProofTab::resultOf(const QString &task) const
{
    const auto found = std::find_if(m_verified.begin(), m_verified.end(),
                                    [&](const VerifiedTask &each) { return each.id == task; });
    return found == m_verified.end() || task.isEmpty() ? nullptr : &*found;
}

void ProofTab::verifyStep()
{
    m_document.readNow();
    if (taskId().isEmpty()) {
        showStep();
        return;
    }
    verify(taskId());
}

void ProofTab::verifyAll()
{
    m_document.readNow();
    verify({});
}

/// What was found before stays only as long as the lab is the same.
void ProofTab::verify(const QString &only)
{
    if (m_verifiedFiles != m_document.files()) {
        m_verified.clear();
        showStep();
    }
    m_verifiedFiles = m_document.files();
    setRunning(true);
    m_job.verify(m_document.lab(), only);
}

void ProofTab::suggest()
{
    m_document.readNow();
    const Task *task = m_document.task();
    if (!task)
        return;
    m_suggestedFor = task->id;
    m_suggestedFiles = m_document.files();
    m_suggestions = {}; // of before, or of another step
    setRunning(true);
    m_job.suggest(m_document.lab(), *task);
}

void ProofTab::stop()
{
    m_job.cancel();
}

void ProofTab::setRunning(bool running)
{
    // The keyboard goes to Stop and back, not on to the matrix.
    if (running)
        m_focusBefore = focusWidget();
    const bool goesOn = running ? m_focusBefore && m_focusBefore->hasFocus() : m_stop->hasFocus();
    m_progress->setRange(0, 0);
    m_progress->setVisible(running);
    for (QPushButton *button : {m_verifyStep, m_verifyAll, m_suggest})
        button->setEnabled(!running);
    if (running)
        m_stop->show();
    if (QWidget *next = running ? m_stop : m_focusBefore; goesOn && next)
        next->setFocus();
    m_stop->setVisible(running);
    showSummary();
}

/// What was found of other steps before stays.
void ProofTab::takeVerified(const std::vector<VerifiedTask> &tasks)
{
    for (const VerifiedTask &task : tasks) {
        std::erase_if(m_verified, [&](const VerifiedTask &old) { return old.id == task.id; });
        m_verified.push_back(task);
    }
    m_suggestedLast = false;
    showStep();
}

void ProofTab::takeSuggested(const Suggestions &suggestions)
{
    m_suggestions = suggestions;
    for (VerifiedTask &task : m_verified) {
        if (task.id == m_suggestedFor)
            dropNeeded(task, suggestions.alone);
    }
    m_suggestedLast = true;
    showStep();
}

void ProofTab::showStep()
{
    const VerifiedTask *verified = result();
    m_matrix->show(verified ? *verified : VerifiedTask());
    showRows();
    showSummary();
}

void ProofTab::showSummary()
{
    const VerifiedTask *verified = result();
    const bool suggested = m_suggestedFor == taskId() && !m_suggestedFor.isEmpty();
    m_matrix->setVisible(verified != nullptr);
    m_empty->setVisible(!verified && !suggested);
    m_empty->setText(m_job.isRunning()
                         ? tr("Every program runs through the checks…")
                         : tr("Press Verify this step: the starter should fail by a check, the "
                              "solution pass with every seed, and each mistake fail and be "
                              "recognised."));
    m_matrix->parentWidget()->setVisible(verified || suggested);
    m_summary->setVisible(verified != nullptr);
    m_stale->setVisible(verified && m_verifiedFiles != m_document.files());
    showOthers();
    if (!verified)
        return;
    const bool right = verified->findings.empty() && missingChecks() == 0;
    setKind(m_summary, right ? "successTitle" : "warningTitle");
    m_summary->setText(summaryOf(*verified));
}

int ProofTab::missingChecks() const
{
    if (m_suggestedFor != taskId() || m_suggestedFor.isEmpty())
        return 0;
    return static_cast<int>(std::count_if(
        m_suggestions.list.begin(), m_suggestions.list.end(),
        [](const Suggestion &each) { return each.kind == Suggestion::Kind::Passes; }));
}

/// No more than what was proven.
QString ProofTab::summaryOf(const VerifiedTask &verified) const
{
    const auto count = static_cast<int>(verified.findings.size());
    if (count > 0)
        return tr("Not as it should be: %1").arg(count);
    if (missingChecks() > 0)
        return tr("The solution passes, and every mistake fails and is recognised; but a check is "
                  "missing: changes of the solution that pass every check: %1")
            .arg(missingChecks());
    return verified.warnings.empty()
               ? tr("All is as it should be: the solution passes, every mistake fails and is "
                    "recognised, every check is needed.")
               : tr("All is as it should be: the solution passes, every mistake fails and is "
                    "recognised.");
}

void ProofTab::showRows()
{
    const VerifiedTask *verified = result();
    m_rows->clear();
    if (m_suggestedLast)
        showSuggestions();
    if (verified)
        showFindings(tr("Findings"), verified->findings, true);
    if (!m_suggestedLast)
        showSuggestions();
    if (verified) // what may well be so, and yet deserves a look
        showFindings(tr("Worth a look"), verified->warnings, false);
    m_rows->setVisible(!m_rows->isEmpty());
}

} // namespace cradle
