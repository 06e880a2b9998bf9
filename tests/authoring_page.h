// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/test_paths.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

namespace cradle {

/// The text of a file; empty if it cannot be read.
inline QString textOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The page that tells authors how a lab is written.
inline QString authoringPage()
{
    return textOf(sourcePath("docs/authoring.md"));
}

/// A value as it stands in task.json.
inline QString jsonText(const QJsonValue &value)
{
    const QByteArray text = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(text.mid(1, text.size() - 2))
        .replace(QLatin1Char(','), QLatin1String(", "))
        .replace(QLatin1Char(':'), QLatin1String(": "));
}

} // namespace cradle
