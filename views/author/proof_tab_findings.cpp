// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/proof_tab.h"

#include "tasks/authoring/free_name.h"
#include "tasks/authoring/lab_edits.h"
#include "views/author/proof_rows.h"

#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace cradle {

// What was found, and the ways from there.

/// The failed check that \p finding is about; nullptr if there is no run to be seen.
const CheckOutcome *ProofTab::outcomeOf(const LabFinding &finding) const
{
    const VerifiedTask *verified = result();
    if (!verified)
        return nullptr;
    for (const VerifiedProgram &program : verified->programs) {
        if (programPath(program) != finding.program)
            continue;
        for (const CheckReport &report : program.reports) {
            if (report.seed != finding.seed)
                continue;
            for (const CheckOutcome &outcome : report.checks) {
                const bool meant = finding.check.isEmpty() || outcome.id == finding.check;
                if (meant && !outcome.passed && outcome.scene)
                    return &outcome;
            }
        }
    }
    return nullptr;
}

QString ProofTab::sourceOf(const QString &program) const
{
    const Result<QString> source =
        programText(m_verifiedFiles, m_document.inStep(program + QStringLiteral(".lua")));
    return source ? *source : QString();
}

/// Who verifies the lab sees one of its steps: this tells of all the others.
void ProofTab::showOthers()
{
    QStringList links;
    int number = 0;
    bool allRight = true;
    for (const Task &task : m_document.lab().tasks) {
        ++number;
        const VerifiedTask *verified = resultOf(task.id);
        allRight = allRight && verified && verified->findings.empty();
        if (verified && !verified->findings.empty() && task.id != taskId())
            links.append(QStringLiteral("<a href=\"%1\">%2 · %3</a> (%4)")
                             .arg(QFileInfo(task.folder).fileName().toHtmlEscaped(),
                                  QString::number(number), task.title.toHtmlEscaped(),
                                  QString::number(verified->findings.size())));
    }
    m_others->setText(
        allRight
            ? tr("So it is in every step of the lab.")
            : tr("Not as it should be in other steps: %1").arg(links.join(QStringLiteral(", "))));
    m_others->setVisible(!links.isEmpty() || (allRight && number > 1));
}

void ProofTab::showFindings(const QString &heading, const std::vector<LabFinding> &findings,
                            bool wrong)
{
    if (findings.empty())
        return;
    m_rows->addHeading(heading);
    for (const LabFinding &finding : findings)
        addFinding(finding, wrong);
}

void ProofTab::showSuggestions()
{
    if (m_suggestedFor != taskId() || m_suggestedFor.isEmpty())
        return;
    m_rows->addHeading(m_suggestedFiles == m_document.files()
                           ? tr("Mistakes that this step does not know")
                           : tr("Mistakes that this step did not know before the last edits"));
    for (const Suggestion &suggestion : m_suggestions.list)
        addSuggestion(suggestion);
    if (m_suggestions.list.empty() && !m_job.isRunning() && m_suggestedFiles == m_document.files())
        m_rows->addRow(tr("None was found: each change of the solution is caught and explained."),
                       false, {});
}

void ProofTab::addFinding(const LabFinding &finding, bool wrong)
{
    using Kind = LabFinding::Kind;
    QString text = finding.message;
    if (!finding.program.isEmpty() && !text.startsWith(finding.program))
        text = QStringLiteral("%1: %2").arg(finding.program, text);
    const auto add = [&](const QString &action, const auto &go) {
        connect(m_rows->addRow(text, wrong, action), &QPushButton::clicked, this, go);
    };
    if (outcomeOf(finding))
        add(tr("Show the run"), [this, finding] { showRun(finding); });
    else if (!finding.program.isEmpty())
        add(finding.program == QLatin1String("solution-preset") ? tr("Open the scene")
                                                                : tr("Open the program"),
            [this, finding] { emit programRequested(finding.program); });
    else if (!finding.check.isEmpty())
        add(tr("Open the check"), [this, finding] { emit checkRequested(finding.check); });
    else if (finding.kind == Kind::TextUnfinished || finding.kind == Kind::QuestionEndless
             || finding.kind == Kind::ValueFails)
        m_rows->addRow(text, wrong, {});
    else
        add(tr("Open the programs"), [this] { emit programRequested(QStringLiteral("solution")); });
}

void ProofTab::showRun(const LabFinding &finding)
{
    if (const CheckOutcome *outcome = outcomeOf(finding))
        emit runRequested({.scene = *outcome->scene,
                           .pinned = outcome->pinned,
                           .program = finding.program + QStringLiteral(".lua"),
                           .source = sourceOf(finding.program),
                           .step = outcome->step},
                          finding.message);
}

void ProofTab::addSuggestion(const Suggestion &suggestion)
{
    const bool passes = suggestion.kind == Suggestion::Kind::Passes;
    const Mutant &mutant = suggestion.mutant;
    const auto plain = [](const QString &markdown) {
        return markdown.section(QLatin1Char('\n'), 0, 0).remove(QLatin1Char('`'));
    };
    const QString headline = plain(mutant.message);
    const QString line = QString::number(mutant.line);
    const QString change = mutant.change.trimmed();
    const QString where =
        change.isEmpty() ? tr("line %1").arg(line) : tr("line %1: %2").arg(line, change);
    const QString text =
        passes ? tr("Passes every check, so one is missing: %1 (%2)").arg(headline, where)
        : suggestion.kind == Suggestion::Kind::ToldByLaw
            ? tr("Fails by “%1”; students read: “%2”, of: %3 (%4)")
                  .arg(suggestion.check, plain(suggestion.finding), headline, where)
            : tr("Fails by “%1” without a word on why: %2 (%3)")
                  .arg(suggestion.check, headline, where);
    QPushButton *button = m_rows->addRow(text, passes, tr("Add as a mistake"));
    button->setEnabled(!m_document.isReadOnly());
    connect(button, &QPushButton::clicked, this, [this, suggestion, button] {
        button->setEnabled(false);
        adopt(suggestion);
    });
}

void ProofTab::adopt(const Suggestion &suggestion)
{
    const LabFiles &files = m_document.files();
    const QStringList taken = knownNames(files, m_document.step(), KnownKind::Mistake);
    const QString name =
        freeName(suggestion.mutant.name, [&](const QString &each) { return taken.contains(each); });
    if (!m_document.edit(tr("Add a suggested mistake"),
                         withKnownAdded(files, m_document.step(), KnownKind::Mistake, name,
                                        suggestion.mutant.source)))
        return;
    // It is answered; the others stay.
    std::erase_if(m_suggestions.list, [&](const Suggestion &each) {
        return each.mutant.source == suggestion.mutant.source;
    });
    showStep();
    emit programRequested(QStringLiteral("mistakes/") + name);
}

void ProofTab::retranslate()
{
    m_verifyStep->setText(tr("Verify this step"));
    m_verifyStep->setToolTip(tr("Judges every program of the step, the solution with five seeds"));
    m_verifyAll->setText(tr("Verify the lab"));
    m_suggest->setText(tr("Suggest mistakes"));
    m_suggest->setToolTip(tr("Changes the solution as students err, and tells which changes the "
                             "checks miss or cannot explain"));
    m_stop->setText(tr("Stop"));
    m_progress->setAccessibleName(tr("Progress of the proof"));
    m_stale->setText(tr("The lab was edited since."));
    showStep();
}

} // namespace cradle
