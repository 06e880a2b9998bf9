// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/lab/lab.h"
#include "tests/test_paths.h"

#include <QDir>
#include <QFileInfo>
#include <QTest>

namespace cradle {

/// A lab among the fixtures.
inline QString fixture(const QString &name)
{
    return fixturePath("labs/") + name;
}

/// Writes a file with its folder.
inline void write(const QString &path, const QByteArray &text)
{
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

/// A copy of the good lab, to be broken.
inline void copyLab(const QString &to)
{
    const QString from = fixture(QStringLiteral("good"));
    for (const char *name : {"lab.json", "S1/task.json", "S1/preset.json", "S1/instructions.md",
                             "S2/task.json", "S2/preset.json", "S2/instructions.md"}) {
        const QString path = QLatin1Char('/') + QLatin1String(name);
        QVERIFY(QDir().mkpath(QFileInfo(to + path).path()));
        QVERIFY(QFile::copy(from + path, to + path));
    }
}

/// The findings of a lab, a line each.
inline QByteArray said(const Lab &lab)
{
    QStringList lines;
    for (const Error &finding : lab.findings)
        lines.append(finding.toString());
    return lines.join(QLatin1Char('\n')).toUtf8();
}

} // namespace cradle
