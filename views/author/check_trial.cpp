// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/author/check_trial.h"

#include "views/author/form_rows.h"
#include "views/author/program_files.h"
#include "views/boxes.h"
#include "views/on_change.h"
#include "views/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace cradle {

namespace {

constexpr qint64 trialSeed = 1; ///< as a student's first check has it

} // namespace

CheckTrial::CheckTrial(AuthorDocument &document, QWidget *parent)
    : QWidget(parent)
    , m_document(document)
    , m_try(new QPushButton(this))
    , m_program(new QComboBox(this))
    , m_result(makeMutedText(this))
{
    m_program->setObjectName(QStringLiteral("trialProgram"));
    m_result->setObjectName(QStringLiteral("trialResult"));
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    setKind(m_try, "small");
    layOutRow(this, {12, 6, 12, 6}, 8, {m_try, m_program, {m_result, 1}});
    retranslate();
    wire();
    reload();
    onChange(this, {QEvent::LanguageChange}, [this] {
        retranslate();
        forget();
    });
}

void CheckTrial::wire()
{
    connect(&m_document, &AuthorDocument::changed, this, &CheckTrial::reload);
    connect(&m_document, &AuthorDocument::stepChanged, this, &CheckTrial::reload);
    connect(m_program, &QComboBox::currentIndexChanged, this, &CheckTrial::forget);
    connect(m_try, &QPushButton::clicked, this, &CheckTrial::attempt);
    connect(&m_checker, &Checker::finished, this, &CheckTrial::tell);
}

void CheckTrial::reload()
{
    const QStringList programs =
        QStringList{QStringLiteral("solution.lua"), QStringLiteral("starter.lua")}
        + knownPrograms(m_document.files(), m_document.step());
    QStringList shown;
    for (int i = 0; i < m_program->count(); ++i)
        shown.append(m_program->itemText(i));
    if (shown != programs) {
        const QString before = m_program->currentText();
        m_program->clear();
        m_program->addItems(programs);
        m_program->setCurrentIndex(std::max(0, static_cast<int>(programs.indexOf(before))));
    }
    forget();
}

void CheckTrial::setCheck(const QString &id)
{
    m_try->setEnabled(!id.isEmpty());
    if (id == m_check)
        return;
    m_check = id;
    forget();
}

void CheckTrial::setRefused(bool refused)
{
    if (refused == m_refused)
        return;
    m_refused = refused;
    forget();
}

void CheckTrial::setProgram(const QString &file)
{
    if (const int index = m_program->findText(file); index >= 0)
        m_program->setCurrentIndex(index);
}

void CheckTrial::forget()
{
    m_checker.cancel();
    m_result->clear();
}

void CheckTrial::attempt()
{
    m_document.readNow();
    const Task *step = m_document.task();
    const Result<QString> program =
        programText(m_document.files(), m_document.inStep(m_program->currentText()));
    if (!program) {
        m_result->setText(program.error().toString());
        return;
    }
    Task task = step ? *step : Task();
    std::erase_if(task.checks, [this](const CheckSpec &check) { return check.id != m_check; });
    if (task.checks.empty()) {
        m_result->setText(tr("It cannot be tried before what is wrong in this step is mended."));
        return;
    }
    // Of this check alone: nothing is diagnosed and nothing asked.
    QString source = *program;
    if (source.isEmpty() && m_program->currentText() == QLatin1String("starter.lua"))
        source = task.starter; // the solution of the step before
    task.questions.clear();
    task.solution.clear();
    task.mistakes.clear();
    task.remarks.clear();
    m_result->setText(tr("Running…"));
    m_checker.start(m_document.lab(), task, Submission(task.preset, source), trialSeed);
}

void CheckTrial::tell(const CheckReport &report)
{
    const QString before = tr("This is the check as it was before: a field of it holds what is no "
                              "value.");
    m_result->setText(m_refused ? wordsOf(report) + QLatin1Char('\n') + before : wordsOf(report));
}

QString CheckTrial::wordsOf(const CheckReport &report) const
{
    const QString program = m_program->currentText();
    if (report.error && report.error->line > 0)
        return tr("%1 stops in line %2: %3")
            .arg(program)
            .arg(report.error->line)
            .arg(report.error->message);
    if (report.error)
        return tr("%1 stops: %2").arg(program, report.error->message);
    return report.passed ? tr("%1 passes.").arg(program)
                         : tr("%1 fails: %2")
                               .arg(program, report.checks.empty() ? QString()
                                                                   : report.checks.front().message);
}

void CheckTrial::retranslate()
{
    m_try->setText(tr("Try this check"));
    m_try->setToolTip(tr("On that program, with the first seed"));
    m_program->setAccessibleName(tr("Program to try the check on"));
    m_result->setAccessibleName(tr("How the check went"));
}

} // namespace cradle
