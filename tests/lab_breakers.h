// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/authoring_labs.h"

#include <functional>
#include <sys/stat.h>
#include <unistd.h>

namespace cradle::authoring {

/// Breaks a lab that lies in a folder.
using Breaker = std::function<void(const QString &folder)>;

/// A file with that content.
inline Breaker put(const char *path, const QByteArray &content)
{
    return [=](const QString &folder) {
        writeTo(folder + QLatin1Char('/') + QString::fromUtf8(path), content);
    };
}

inline Breaker replace(const char *path, const QByteArray &from, const QByteArray &to)
{
    return [=](const QString &folder) {
        const QString full = folder + QLatin1Char('/') + text(path);
        QByteArray content = authoring::contentOf(full);
        QVERIFY(content.contains(from));
        writeTo(full, content.replace(from, to));
    };
}

inline Breaker removed(const char *path)
{
    return [=](const QString &folder) {
        QVERIFY(QFile::remove(folder + QLatin1Char('/') + text(path)));
    };
}

/// A file of that size that takes no room: all of it is zeros.
inline Breaker sparse(const char *path, qint64 bytes)
{
    return [=](const QString &folder) {
        QFile file(folder + QLatin1Char('/') + text(path));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.resize(bytes));
    };
}

inline Breaker link(const char *path, const QString &target)
{
    return [=](const QString &folder) {
        const QString full = folder + QLatin1Char('/') + text(path);
        QFile::remove(full);
        QVERIFY(symlink(QFile::encodeName(target).constData(), QFile::encodeName(full).constData())
                == 0);
    };
}

inline Breaker pipe(const char *path)
{
    return [=](const QString &folder) {
        const QString full = folder + QLatin1Char('/') + text(path);
        QFile::remove(full);
        QVERIFY(mkfifo(QFile::encodeName(full).constData(), 0644) == 0);
    };
}

inline Breaker folderInPlaceOf(const char *path)
{
    return [=](const QString &folder) {
        QFile::remove(folder + QLatin1Char('/') + text(path));
        QVERIFY(QDir(folder).mkpath(text(path)));
    };
}

inline Breaker locked(const char *path)
{
    return [=](const QString &folder) {
        QVERIFY(QFile::setPermissions(folder + QLatin1Char('/') + text(path), {}));
    };
}

inline Breaker manyFiles(int count)
{
    return [=](const QString &folder) {
        QVERIFY(QDir(folder).mkpath(text("S2/z")));
        for (int i = 0; i < count; ++i) {
            QFile file(folder + text("/S2/z/%1").arg(i));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
    };
}

inline Breaker deepFolders(int depth)
{
    return [=](const QString &folder) {
        QVERIFY(QDir(folder).mkpath(text("S2") + text("/d").repeated(depth)));
        writeTo(folder + text("/S2") + text("/d").repeated(depth) + text("/x.md"), "text");
    };
}

inline QByteArray pngOf(quint32 width, quint32 height)
{
    const auto number = [](quint32 n) {
        return QByteArray::fromHex(QByteArray::number(n, 16).rightJustified(8, '0'));
    };
    return QByteArray("\x89PNG\r\n\x1a\n") + number(13) + "IHDR" + number(width) + number(height)
           + QByteArray::fromHex("0802000000") + number(0);
}

} // namespace cradle::authoring
