// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/work_job.h"

#include <QDialog>

#include <optional>

QT_BEGIN_NAMESPACE
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
QT_END_NAMESPACE

namespace cradle {

class Workbench;

/// Asks who hands in and shows what: every step, judged once more. Writes one file.
class HandInDialog final : public QDialog
{
    Q_OBJECT
public:
    explicit HandInDialog(Workbench &workbench, QWidget *parent = nullptr);

    /// Writes the file, once all is judged. \return what kept it from being written
    std::optional<Error> writeTo(const QString &path);
    /// Whether all steps are judged.
    [[nodiscard]] bool isReady() const { return m_handIn.has_value(); }

private:
    void fitColumns();
    void judge();
    void showVerdicts();
    void chooseFile();
    [[nodiscard]] Sender sender() const;

    Workbench &m_workbench;
    WorkJob m_job;
    std::optional<HandIn> m_handIn;
    QLineEdit *m_name;
    QLineEdit *m_number;
    QTreeWidget *m_steps;
    QPlainTextEdit *m_note;
    QProgressBar *m_progress;
    QLabel *m_message;
    QPushButton *m_save;
};

} // namespace cradle
