// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/patience.h"

#include <QFile>
#include <QProcess>
#include <QString>
#include <QTemporaryDir>

namespace cradle {

/// Git without the settings of who runs the tests. Make it before git is used first.
class GitHome
{
public:
    GitHome()
    {
        qputenv("HOME", m_folder.path().toLocal8Bit());
        qputenv("XDG_CONFIG_HOME", m_folder.path().toLocal8Bit());
        qputenv("GIT_CONFIG_NOSYSTEM", "1");
    }

    /// What the program git says; "failed: …" if it fails.
    static QString git(const QString &folder, const QStringList &arguments)
    {
        QProcess process;
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.setWorkingDirectory(folder);
        process.start(QStringLiteral("git"), arguments);
        if (!process.waitForFinished(patience) || process.exitCode() != 0)
            return QStringLiteral("failed: ") + QString::fromUtf8(process.readAll());
        return QString::fromUtf8(process.readAll()).trimmed();
    }

private:
    QTemporaryDir m_folder;
};

} // namespace cradle
