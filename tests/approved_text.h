// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/test_paths.h"

#include "model/files/file_io.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

/// Texts as they were when they last changed lie in tests/approved; a test compares them with what
/// is made now. They say that nothing changes unseen, not that all of them is true. With
/// CRADLE_APPROVE=1 (tools/approve) it writes them instead, and the difference of the commit, which
/// is to be read, shows what has changed for who reads them.
namespace cradle::approved {

inline bool isApproving()
{
    return qEnvironmentVariableIsSet("CRADLE_APPROVE");
}

inline QString path(const QString &inside)
{
    return sourcePath("tests/approved/") + inside;
}

/// \return empty where there is no such file
inline QString read(const QString &inside)
{
    QFile file(path(inside));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

inline void write(const QString &inside, const QString &text)
{
    QDir().mkpath(QFileInfo(path(inside)).path());
    if (const auto error = writeFile(path(inside), text.toUtf8()))
        qFatal("%s", qPrintable(error->toString()));
}

/// The first line in which two texts differ, for messages; empty where they are the same.
inline QString difference(const QString &now, const QString &before)
{
    if (now == before)
        return {};
    const QStringList made = now.split(QLatin1Char('\n'));
    const QStringList kept = before.split(QLatin1Char('\n'));
    qsizetype line = 0;
    while (made.value(line) == kept.value(line) && line < std::max(made.size(), kept.size()))
        ++line;
    return QStringLiteral("line %1 is\n  %2\napproved was\n  %3\nlook at it, then tools/approve")
        .arg(line + 1)
        .arg(made.value(line), kept.value(line));
}

/// Compares \p now with the file \p inside, or writes it. \return what differs; empty: nothing
inline QString compare(const QString &inside, const QString &now)
{
    if (isApproving()) {
        write(inside, now);
        return {};
    }
    return difference(now, read(inside));
}

} // namespace cradle::approved
