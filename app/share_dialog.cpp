// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/share_dialog.h"

#include "tasks/workspace/workspace.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtConcurrentRun>

namespace cradle {

ShareDialog::ShareDialog(Workspace &workspace, QWidget *parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_address(new QLineEdit(this))
    , m_last(new QLabel(this))
    , m_message(new QLabel(this))
{
    setWindowTitle(tr("Share with git"));
    m_address->setText(workspace.history()->remoteUrl());
    m_address->setPlaceholderText(QStringLiteral("git@example.org:me/lab.git"));
    m_message->setWordWrap(true);
    auto *intro = new QLabel(tr("Your work is a git repository in %1. Its commits and versions can "
                                "be sent to one of yours elsewhere; who may read that, reads all "
                                "of them.")
                                 .arg(workspace.folder()),
                             this);
    intro->setWordWrap(true);
    auto *form = new QFormLayout;
    form->addRow(tr("&Address:"), m_address);
    form->addRow(tr("Sent so far:"), m_last);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    m_send = buttons->addButton(tr("&Send"), QDialogButtonBox::ActionRole);
    auto *column = new QVBoxLayout(this);
    column->addWidget(intro);
    column->addLayout(form);
    column->addWidget(m_message);
    column->addStretch();
    column->addWidget(buttons);
    resize(560, 260);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_send, &QPushButton::clicked, this, &ShareDialog::send);
    connect(&m_sending, &QFutureWatcherBase::finished, this, [this] {
        const auto error = m_sending.result();
        showState(error ? error->toString() : tr("All is sent."));
    });
    showState({});
}

void ShareDialog::send()
{
    if (const auto error = m_workspace.history()->setRemoteUrl(m_address->text())) {
        showState(error->toString());
        return;
    }
    m_send->setEnabled(false);
    m_message->setText(tr("Sending…"));
    m_message->show();
    // A history of its own: the network takes its time, and the student goes on working. Who
    // closes the dialog does not wait for a server that does not answer.
    m_sending.setFuture(
        QtConcurrent::run([folder = m_workspace.folder()]() -> std::optional<Error> {
            const auto history = History::openExisting(folder);
            return history ? (*history)->push() : std::optional(history.error());
        }));
}

void ShareDialog::showState(const QString &message)
{
    const QDateTime last = m_workspace.history()->lastPush();
    m_last->setText(last.isValid()
                        ? tr("up to the commit of %1")
                              .arg(QLocale().toString(last.toLocalTime(), QLocale::ShortFormat))
                        : tr("nothing yet"));
    m_message->setText(message);
    m_message->setVisible(!message.isEmpty());
    m_send->setEnabled(true);
}

} // namespace cradle
