// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/work_job.h"

#include <QDialog>

QT_BEGIN_NAMESPACE
class QLabel;
class QProgressBar;
class QPushButton;
class QTextBrowser;
QT_END_NAMESPACE

namespace cradle {

class DrawingObject;
class Workbench;

/// The end of a lab, or how far it has come: the pictures of all steps, what was hard, the energy
/// of the whole lab, and the ways to report and to hand in.
class ReportDialog final : public QDialog
{
    Q_OBJECT
public:
    /// \param finished  whether it opens because the last step was passed
    ReportDialog(Workbench &workbench, bool finished, QWidget *parent = nullptr);
    ~ReportDialog() override;

    [[nodiscard]] bool isReady() const { return m_handIn.has_value(); }
    /// Writes the report as its name says, F.pdf or F.html.
    std::optional<Error> writeTo(const QString &path);

signals:
    void handInRequested();

private:
    void showPage();
    void saysWhy(const QString &fault);
    void chooseFile();

    Workbench &m_workbench;
    bool m_finished;
    WorkJob m_job;
    std::optional<HandIn> m_handIn;
    QTextBrowser *m_page;
    std::unique_ptr<DrawingObject> m_drawings;
    QProgressBar *m_progress;
    QLabel *m_message;
    QPushButton *m_report;
};

} // namespace cradle
