// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tasks/authoring/lab_edits.h"
#include "tasks/values/lab_values.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <functional>

namespace cradle {

/// The template's lab with members of lab.json and a text of its step.
inline LabFiles labWith(const QJsonObject &members, const QByteArray &text = {})
{
    LabFiles files =
        newLab(QStringLiteral("valued"), QStringLiteral("Valued"), QStringLiteral("en"));
    QJsonObject json = QJsonDocument::fromJson(files.contents[QStringLiteral("lab.json")]).object();
    for (auto it = members.begin(); it != members.end(); ++it)
        json.insert(it.key(), it.value());
    files.contents[QStringLiteral("lab.json")] = QJsonDocument(json).toJson();
    if (!text.isEmpty())
        files.contents[QStringLiteral("S1/instructions.md")] = text;
    return files;
}

/// The named values of a lab, as they stand in lab.json.
inline QJsonObject values(const QJsonObject &all)
{
    return {{QStringLiteral("values"), all}};
}

/// A value that is drawn: 0.6, 0.65 … 0.9.
inline const QJsonObject range{
    {QStringLiteral("from"), 0.6}, {QStringLiteral("to"), 0.9}, {QStringLiteral("step"), 0.05}};

/// Changes a JSON file of a lab.
inline void edit(LabFiles &files, const char *path,
                 const std::function<void(QJsonObject &)> &change)
{
    QByteArray &bytes = files.contents[QLatin1String(path)];
    QJsonObject json = QJsonDocument::fromJson(bytes).object();
    change(json);
    bytes = QJsonDocument(json).toJson();
}

/// The value of k that \p student has.
inline double k(const LabFiles &files, const QString &student)
{
    return valuesOf(files, {}, student).value(QStringLiteral("k"));
}

} // namespace cradle
