// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/grade_run.h"
#include "model/world/result.h"
#include "tasks/lab/lab.h"

#include <QDialog>

#include <functional>

QT_BEGIN_NAMESPACE
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

/// Grades a class by the open lab: choose what was handed in and where the results go, watch, open
/// the results. Closing it stops the grading, which goes on where it was the next time.
class GradeDialog final : public QDialog
{
    Q_OBJECT
public:
    explicit GradeDialog(const Lab &lab, QWidget *parent = nullptr);

    [[nodiscard]] GradeRun &run() { return m_run; }
    void setFolders(const QString &submissions, const QString &results);
    void grade();
    [[nodiscard]] QString resultsPage() const; ///< class.html

private:
    QLineEdit *addPath(QFormLayout *form, const QString &label, const QString &about,
                       const std::function<QString(const QString &)> &choose);
    void showState();
    void addRemark(const QString &text);
    void end(bool complete, const QString &fault);
    void openResults();

    GradeRun m_run;
    QString m_lab; ///< folder
    QLineEdit *m_submissions = nullptr;
    QLineEdit *m_results = nullptr;
    QLineEdit *m_roster = nullptr;
    QDoubleSpinBox *m_late = nullptr;
    QProgressBar *m_progress = nullptr;
    QLabel *m_message = nullptr;
    QPlainTextEdit *m_remarks = nullptr; ///< hidden while there are none
    QPushButton *m_start;
    QPushButton *m_stop;
    QPushButton *m_open;
};

} // namespace cradle
