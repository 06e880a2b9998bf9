// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/world/result.h"

#include <QDialog>
#include <QFutureWatcher>

#include <optional>

QT_BEGIN_NAMESPACE
class QLabel;
class QLineEdit;
class QPushButton;
QT_END_NAMESPACE

namespace cradle {

class Workspace;

/// Sends the history of the work to a git repository elsewhere.
class ShareDialog final : public QDialog
{
    Q_OBJECT
public:
    /// \param workspace  with a history; outlives the dialog.
    /// What is being sent when the dialog is closed goes on being sent.
    explicit ShareDialog(Workspace &workspace, QWidget *parent = nullptr);

private:
    void send();
    void showState(const QString &message);

    Workspace &m_workspace;
    QLineEdit *m_address;
    QLabel *m_last;
    QLabel *m_message;
    QPushButton *m_send;
    QFutureWatcher<std::optional<Error>> m_sending;
};

} // namespace cradle
