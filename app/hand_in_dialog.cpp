// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hand_in_dialog.h"

#include "app/language.h"
#include "app/workbench.h"
#include "model/files/file_io.h"
#include "tasks/lab_report/report_html.h"
#include "views/report_printer.h"
#include "views/theme.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace cradle {

HandInDialog::HandInDialog(Workbench &workbench, QWidget *parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_name(new QLineEdit(this))
    , m_number(new QLineEdit(this))
    , m_steps(new QTreeWidget(this))
    , m_note(new QPlainTextEdit(this))
    , m_progress(new QProgressBar(this))
    , m_message(new QLabel(this))
{
    setWindowTitle(tr("Hand in %1").arg(workbench.lab().title));
    const WorkspaceInfo &info = workbench.code().workspace().info();
    m_name->setText(info.student);
    m_number->setText(info.studentId);
    if (workbench.lab().drawsValues && !info.studentId.isEmpty()) {
        m_number->setReadOnly(true);
        m_number->setToolTip(tr("The values of this lab were drawn by this number"));
    }
    m_steps->setRootIsDecorated(false);
    m_steps->setHeaderLabels({tr("Step"), tr("Title"), tr("What is handed in"), tr("Verdict")});
    fitColumns(); // also while every step is still judged
    m_steps->setAccessibleName(tr("Steps that are handed in"));
    setKind(m_note, "field");
    m_note->setTabChangesFocus(true);
    m_note->setAccessibleName(tr("Note to the teacher"));
    m_note->setMaximumHeight(90);
    m_message->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Name:"), m_name);
    form->addRow(tr("N&umber:"), m_number);
    auto *note = new QFormLayout;
    note->addRow(tr("Note to the &teacher:"), m_note);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_save = buttons->addButton(tr("&Save the file…"), QDialogButtonBox::AcceptRole);
    m_save->setEnabled(false);
    auto *column = new QVBoxLayout(this);
    column->addLayout(form);
    column->addWidget(m_steps, 1);
    column->addWidget(m_progress);
    column->addLayout(note);
    column->addWidget(m_message);
    column->addWidget(buttons);
    resize(760, 620);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_save, &QPushButton::clicked, this, &HandInDialog::chooseFile);
    connect(&m_job, &WorkJob::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
    });
    connect(&m_job, &WorkJob::finished, this, [this](const HandIn &handIn) {
        m_handIn = handIn;
        showVerdicts();
    });
    connect(&m_job, &WorkJob::failed, this,
            [this](const Error &error) { m_message->setText(error.toString()); });
    judge();
}

Sender HandInDialog::sender() const
{
    return {m_name->text().simplified(), m_number->text().simplified(), m_note->toPlainText()};
}

void HandInDialog::fitColumns()
{
    for (int column = 0; column < m_steps->columnCount(); ++column)
        m_steps->resizeColumnToContents(column);
}

void HandInDialog::judge()
{
    m_workbench.progress().save();
    if (!m_workbench.code().isSaved()) {
        m_message->setText(unsavedText());
        return;
    }
    m_message->setText(tr("Every step is judged once more…"));
    m_job.start(m_workbench.lab(), m_workbench.code().workspace().folder(), {});
}

void HandInDialog::showVerdicts()
{
    m_steps->clear();
    for (const StepReport &step : m_handIn->report.steps) {
        auto *row = new QTreeWidgetItem(m_steps);
        row->setText(0, step.id);
        row->setText(1, step.title);
        row->setText(2, step.verdict == StepVerdict::NotDone ? tr("nothing")
                        : step.byProgram                     ? tr("a program")
                                                             : tr("a scene"));
        row->setText(3, step.verdict == StepVerdict::Passed      ? tr("passes ✓")
                        : step.verdict == StepVerdict::NotPassed ? tr("does not pass")
                        : step.verdict == StepVerdict::Stopped   ? tr("stops with an error")
                                                                 : tr("not done"));
        row->setToolTip(3, step.explanation);
    }
    fitColumns();
    m_progress->hide();
    m_message->setText(tr("%1 of %2 steps pass. All of them are handed in as they are.")
                           .arg(m_handIn->report.passedCount())
                           .arg(m_handIn->report.steps.size()));
    m_save->setEnabled(true);
    m_save->setDefault(true);
}

std::optional<Error> HandInDialog::writeTo(const QString &path)
{
    const Sender who = sender();
    if (auto error = m_workbench.code().workspace().setStudent(who.name, who.number))
        return error;
    HandIn handIn = *m_handIn;
    nameSender(handIn, who);
    const LabReportPage page = labReportPage(handIn.report, Drawings::Numbered, currentLanguage());
    const auto packed =
        packHandIn(handIn, QStringLiteral("report.pdf"), printedPdf(page, titleOf(handIn.report)));
    return packed ? writeFile(path, *packed) : std::optional(packed.error());
}

void HandInDialog::chooseFile()
{
    QString path = QFileDialog::getSaveFileName(
        this, tr("Save what is handed in"), workFileName(m_name->text(), m_workbench.lab().id),
        tr("Work to hand in (*.cradle-work)"), nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty())
        return;
    if (!path.endsWith(QLatin1String(workSuffix)))
        path += QLatin1String(workSuffix);
    if (const auto error = writeTo(path)) {
        m_message->setText(error->toString());
        return;
    }
    accept();
}

} // namespace cradle
