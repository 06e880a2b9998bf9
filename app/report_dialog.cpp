// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_dialog.h"

#include "app/language.h"
#include "app/workbench.h"
#include "model/files/file_io.h"
#include "tasks/lab_report/ending_page.h"
#include "views/drawing_object.h"
#include "views/focus_ring.h"
#include "views/report_printer.h"

#include <QAbstractTextDocumentLayout>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace cradle {

ReportDialog::ReportDialog(Workbench &workbench, bool finished, QWidget *parent)
    : QDialog(parent)
    , m_workbench(workbench)
    , m_finished(finished)
    , m_page(new QTextBrowser(this))
    , m_progress(new QProgressBar(this))
    , m_message(new QLabel(this))
{
    setWindowTitle(tr("Looking back at %1").arg(workbench.lab().title));
    m_page->setAccessibleName(tr("The steps of the lab, and what was hard"));
    m_page->setOpenLinks(false);
    ringFocus(m_page);
    m_message->setWordWrap(true);
    // Made in the order in which they stand: else Tab does not come to the last.
    auto *buttons = new QDialogButtonBox(this);
    m_report = buttons->addButton(tr("&Report…"), QDialogButtonBox::ActionRole);
    m_report->setEnabled(false);
    QPushButton *handIn = buttons->addButton(tr("&Hand in…"), QDialogButtonBox::ActionRole);
    buttons->addButton(QDialogButtonBox::Close);
    auto *column = new QVBoxLayout(this);
    column->addWidget(m_page, 1);
    column->addWidget(m_progress);
    column->addWidget(m_message);
    column->addWidget(buttons);
    resize(860, 720);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_report, &QPushButton::clicked, this, &ReportDialog::chooseFile);
    connect(handIn, &QPushButton::clicked, this, &ReportDialog::handInRequested);
    connect(&m_job, &WorkJob::progressed, this, [this](int done, int total) {
        m_progress->setRange(0, total);
        m_progress->setValue(done);
    });
    connect(&m_job, &WorkJob::finished, this, [this](const HandIn &done) {
        m_handIn = done;
        showPage();
    });
    connect(&m_job, &WorkJob::failed, this,
            [this](const Error &error) { saysWhy(error.toString()); });
    workbench.progress().save();
    if (!workbench.code().isSaved()) {
        saysWhy(unsavedText());
        return;
    }
    m_message->setText(tr("Every step is judged once more…"));
    m_job.start(workbench.lab(), workbench.code().workspace().folder(), {});
}

ReportDialog::~ReportDialog() = default;

/// Why there is no page.
void ReportDialog::saysWhy(const QString &fault)
{
    m_progress->hide();
    m_message->setText(fault);
    m_message->show();
}

void ReportDialog::showPage()
{
    const LabReportPage page = endingPage(m_handIn->report, m_finished);
    m_drawings = std::make_unique<DrawingObject>(page.drawings);
    m_page->document()->documentLayout()->registerHandler(QTextFormat::ImageObject,
                                                          m_drawings.get());
    // The drawings are of light colours, whatever the window has.
    m_page->setStyleSheet(QStringLiteral("QTextBrowser { background: white; color: #212529; }"));
    m_page->setHtml(page.html);
    m_progress->hide();
    m_message->hide();
    m_report->setEnabled(true);
}

std::optional<Error> ReportDialog::writeTo(const QString &path)
{
    const LabReport &report = m_handIn->report;
    if (path.endsWith(QLatin1String(".html"), Qt::CaseInsensitive))
        return writeFile(path,
                         labReportPage(report, Drawings::Inside, currentLanguage()).html.toUtf8());
    return writeFile(path, printedPdf(labReportPage(report, Drawings::Numbered, currentLanguage()),
                                      titleOf(report)));
}

void ReportDialog::chooseFile()
{
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save the report"), QStringLiteral("report.pdf"),
        tr("Documents (*.pdf);;Web pages (*.html)"), nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty())
        return;
    const auto error = writeTo(path);
    m_message->setText(error ? error->toString() : tr("Saved: %1").arg(path));
}

} // namespace cradle
