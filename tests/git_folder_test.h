// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "git_home.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

namespace cradle {

/// A test of repositories in a folder that is each time new; "w" is the one that is meant.
class GitFolderTest : public QObject
{
protected:
    void takeNewFolder() { m_folder = std::make_unique<QTemporaryDir>(); }

    [[nodiscard]] QString path(const char *name = "w") const
    {
        return m_folder->filePath(QLatin1String(name));
    }
    static QByteArray content(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }
    /// What git says in "w". \param arguments  with a space between two
    QString git(const QString &arguments) const
    {
        return GitHome::git(path(), arguments.split(QLatin1Char(' ')));
    }
    /// What git says in the folder around it.
    QString gitAround(const QStringList &arguments) const
    {
        return GitHome::git(m_folder->path(), arguments);
    }

private:
    GitHome m_home;
    std::unique_ptr<QTemporaryDir> m_folder;
};

} // namespace cradle
