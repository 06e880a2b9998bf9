// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"
#include "tests/test_paths.h"
#include "tests/text.h"

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

namespace cradle::authoring {

using cradle::text;

/// Lab 4.2 as it lies in the repository.
inline const QString shippedFolder = sourcePath("tasks/labs/lab-4.2");

/// Writes a file with its folders.
inline void writeTo(const QString &path, const QByteArray &content)
{
    QVERIFY(QDir().mkpath(QFileInfo(path).path()));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(content), content.size());
}

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The template's lab, with one step.
inline LabFiles small()
{
    return newLab(text("small"), text("Small"), text("en"));
}

/// The files in which two labs differ.
inline QStringList differences(const LabFiles &a, const LabFiles &b)
{
    QStringList paths = a.contents.keys() + b.contents.keys();
    paths.sort();
    paths.removeDuplicates();
    paths.removeIf([&](const QString &path) {
        return a.contents.contains(path) == b.contents.contains(path)
               && a.contents.value(path) == b.contents.value(path);
    });
    return paths;
}

/// The lines of a text that another has not.
inline QList<QByteArray> newLines(const QByteArray &before, const QByteArray &after)
{
    QList<QByteArray> lines = after.split('\n');
    const QList<QByteArray> old = before.split('\n');
    lines.removeIf([&](const QByteArray &line) { return old.contains(line); });
    return lines;
}

} // namespace cradle::authoring

/// The value of a Result; on an error the test fails and says it.
#define TAKE(target, expression)                                                                   \
    do {                                                                                           \
        auto taken_ = (expression);                                                                \
        QVERIFY2(taken_.ok(), taken_ ? "" : qPrintable(taken_.error().toString()));                \
        target = *taken_;                                                                          \
    } while (false)
